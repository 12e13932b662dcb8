/* radial.h: the manufactured radial oscillation that ring (W11 5.1, eqs 36, 37) and shell share, in
 * n = 2 or 3 axes about the body's centre. A scene defines enum { RADIAL_AXES = n } before it
 * includes this, and its first parameter is the amplitude A.
 *
 *   u(R, t) = s(t) g(R) e_R,  s = A cos(w t),  w = c pi,  c = sqrt(E/rho),
 *   g = c1 R + c2 R^2 + c3 R^3,  g' = 0 at both radii, so that they are free of traction.
 *
 * Body force. nu = 0: P = mu (F - F^-T), mu = E/2, and F is diagonal along the radius and across
 * it,
 *
 *   F_rr = 1 + s g',  F_tt = 1 + s g/R,  P_rr = mu (F_rr - 1/F_rr),  P_tt likewise.
 *
 * Balance of momentum rho u_tt = DIV P + rho b, with DIV P = dP_rr/dR + (n - 1) (P_rr - P_tt)/R:
 *
 *   dP_rr/dR        = mu (1 + 1/F_rr^2) s g'',
 *   (P_rr - P_tt)/R = mu (1 + 1/(F_rr F_tt)) (F_rr - F_tt)/R,
 *   (F_rr - F_tt)/R = s (c2 + 2 c3 R),
 *   b_R = -w^2 s g - (c^2/2) s [(1 + 1/F_rr^2) g'' + (n - 1) (1 + 1/(F_rr F_tt)) (c2 + 2 c3 R)].
 *
 * traction=1 takes c1 = 6, c2 = -8, c3 = 3 instead: g' = .25 at the inner, -1 at the outer radius,
 * so that P_rr there is known and not zero. */
#ifndef MPMLAB_RADIAL_H
#define MPMLAB_RADIAL_H

#include <math.h>
#include "common/contract/problem.h"

enum { RADIAL_C1, RADIAL_C2, RADIAL_C3, RADIAL_OMEGA }; /* s->k */

static const double radial_inner = 0.5, radial_outer = 1; /* [m] */

/* The last parameter of both scenes. */
#define RADIAL_TRACTION                                                                            \
    {                                                                                              \
        "traction", 0, 0, 1, "", "1: other c2, c3, so that both radii bear a known traction",      \
            "W11 eq 3", "0|1"                                                                      \
    }

/* Material, times and coefficients: eq 37's, whose radii are free, or where s->traction was set
 * others, whose radii bear a traction. */
static inline void radial_init(Scene *s)
{
    const double D = radial_outer - 3 * radial_inner, outer2 = radial_outer * radial_outer;
    s->mat = material_make(NEO_HOOKEAN, 1e4, 0, 1);
    s->c = material_wave_speed_bar(&s->mat);
    s->t_end = 2 / s->c;
    s->error_scale = scale_of_motion(s->par[0], 1);
    s->k[RADIAL_C1] = -6 * radial_inner / (radial_outer * D);
    s->k[RADIAL_C2] = 3 * (radial_outer + radial_inner) / (outer2 * D);
    s->k[RADIAL_C3] = -2 / (outer2 * D);
    s->k[RADIAL_OMEGA] = M_PI * s->c;
    if (!s->traction) return;
    s->k[RADIAL_C1] = 6;
    s->k[RADIAL_C2] = -8;
    s->k[RADIAL_C3] = 3;
}

/* Grid and box of the body, which `full` makes whole; else between symmetry planes. */
static inline void radial_bounds(Scene *s, bool full)
{
    for (int d = 0; d < RADIAL_AXES; d++) {
        s->lo[d] = full ? -2 : 0;
        s->hi[d] = 2;
        s->body_lo[d] = full ? s->body.centre[d] - radial_outer : 0;
        s->body_hi[d] = s->body.centre[d] + radial_outer;
        if (!full) s->wall[s->nwall++] = (Wall){.axis = d, .side = -1, .at = 0, .mirror = true};
    }
}

/* s(t) [m]. */
static inline double radial_amplitude(const Scene *s, double t)
{
    return s->par[0] * cos(s->k[RADIAL_OMEGA] * t);
}

/* Distance [m] of x from the body's centre (an axis in space, for n = 2). */
static inline double radial_radius(const Scene *s, const Vec x)
{
    double square = 0;
    for (int d = 0; d < RADIAL_AXES; d++) square += pow(x[d] - s->body.centre[d], 2);
    return sqrt(square);
}

/* The same for point p of component arrays; r: its position from the centre. */
static inline double radial_from_centre(const Scene *s, ConstFields X, int p, double r[])
{
    double square = 0;
    for (int d = 0; d < RADIAL_AXES; d++) {
        r[d] = X[d][p] - s->body.centre[d];
        square += r[d] * r[d];
    }
    return sqrt(square);
}

static inline bool radial_inside(const Scene *s, const Vec X)
{
    const double R = radial_radius(s, X);
    return R >= radial_inner && R <= radial_outer;
}

static inline void radial_exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double a = radial_amplitude(s, t);
    const double c1 = s->k[RADIAL_C1], c2 = s->k[RADIAL_C2], c3 = s->k[RADIAL_C3];
    for (int p = 0; p < n; p++) {
        double r[DIM];
        const double R = radial_from_centre(s, X, p, r);
        const double u_over_R = a * (c1 + R * (c2 + R * c3));
        for (int d = 0; d < DIM; d++) u[d][p] = d < RADIAL_AXES ? u_over_R * r[d] : 0;
    }
}

/* Distance [m] of x from the nearer surface, > 0 inside: the radii move to R + u(R, t). */
static inline double radial_distance(const Scene *s, const Vec x, double t)
{
    const double a = radial_amplitude(s, t);
    const double c1 = s->k[RADIAL_C1], c2 = s->k[RADIAL_C2], c3 = s->k[RADIAL_C3];
    const double in = radial_inner, out = radial_outer;
    const double lo = in * (1 + a * (c1 + in * (c2 + in * c3)));
    const double hi = out * (1 + a * (c1 + out * (c2 + out * c3)));
    const double r = radial_radius(s, x);
    return fmin(r - lo, hi - r);
}

/* F = F_tt I + (F_rr - F_tt) e_R e_R^T in the n axes; at rest, since u_t ~ sin(w t). */
static inline void radial_start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F,
                                Fields L)
{
    (void)v, (void)L;
    const double a = radial_amplitude(s, 0);
    const double c1 = s->k[RADIAL_C1], c2 = s->k[RADIAL_C2], c3 = s->k[RADIAL_C3];
    radial_exact(s, n, X, 0, u);
    for (int p = 0; p < n; p++) {
        double r[DIM];
        const double R = radial_from_centre(s, X, p, r);
        const double F_tt = 1 + a * (c1 + R * (c2 + R * c3));
        const double difference = a * (c2 / R + 2 * c3); /* (F_rr - F_tt)/R^2 */
        for (int i = 0; i < RADIAL_AXES; i++)
            for (int j = 0; j < RADIAL_AXES; j++)
                F[i * DIM + j][p] = (i == j ? F_tt : 0) + difference * r[i] * r[j];
    }
}

static inline void radial_body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    const double a = radial_amplitude(s, t);
    const double c1 = s->k[RADIAL_C1], c2 = s->k[RADIAL_C2], c3 = s->k[RADIAL_C3];
    const double w2 = s->k[RADIAL_OMEGA] * s->k[RADIAL_OMEGA], half_c2 = s->mat.mu / s->mat.rho;
    for (int p = 0; p < n; p++) {
        double r[DIM];
        const double R = radial_from_centre(s, X, p, r), g_over_R = c1 + R * (c2 + R * c3);
        const double iF_rr = 1 / (1 + a * (c1 + R * (2 * c2 + R * 3 * c3)));
        const double iF_tt = 1 / (1 + a * g_over_R);
        const double stress = (1 + iF_rr * iF_rr) * (2 * c2 + 6 * c3 * R) +
                              (RADIAL_AXES - 1) * (1 + iF_rr * iF_tt) * (c2 + 2 * c3 * R);
        const double b_over_R = -a * (w2 * g_over_R + half_c2 * stress / R);
        for (int d = 0; d < DIM; d++) b[d][p] = d < RADIAL_AXES ? b_over_R * r[d] : 0;
    }
}

/* P N = +-P_rr e_R on faces whose normal N lies along the radius. */
static inline void radial_traction(const Scene *s, int n, ConstFields X, ConstFields N, double t,
                                   Fields out)
{
    const double a = radial_amplitude(s, t);
    const double c1 = s->k[RADIAL_C1], c2 = s->k[RADIAL_C2], c3 = s->k[RADIAL_C3];
    for (int p = 0; p < n; p++) {
        double r[DIM], along = 0;
        const double R = radial_from_centre(s, X, p, r);
        const double F_rr = 1 + a * (c1 + R * (2 * c2 + R * 3 * c3));
        const double P_rr = s->mat.mu * (F_rr - 1 / F_rr);
        for (int d = 0; d < RADIAL_AXES; d++) along += N[d][p] * r[d] / R;
        const double side = fabs(along) > 0.5 ? copysign(1, along) : 0;
        for (int d = 0; d < DIM; d++) out[d][p] = d < RADIAL_AXES ? side * P_rr * r[d] / R : 0;
    }
}

#endif
