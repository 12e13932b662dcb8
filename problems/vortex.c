/* vortex.c: generalized vortex, a manufactured solution of large shear and rotation (Kamojjala,
 * Brannon, Sadeghirad & Guilkey 2013).
 *
 * Every circle about the centre turns as a whole: x = Q(a) X, Q a rotation by
 *   a(R, t) = g(t) h(R),  g = G sin(pi t),  h = 1 - 32 s^2 + 256 s^4,  s = R - 1,
 * h = h' = 0 at both radii: the circles there rest. With k = R da/dR, e_R and e_T the polar axes at
 * X:  F = Q (I + k e_T e_R^T),  J = 1,  F^-T = Q (I - k e_R e_T^T), so that the neo-Hookean law
 * gives P = mu (F - F^-T) = mu k Q (e_T e_R^T + e_R e_T^T), whatever lambda is, and P e_R = mu k Q
 * e_T vanishes with h' at both radii: no traction.
 *
 * Body force. With dQ/da e_R = Q e_T, dQ/da e_T = -Q e_R and d e_R/dT = e_T, d e_T/dT = -e_R,
 *   DIV P = dP/dR e_R + (1/R) dP/dT e_T = mu Q [(k' + 2 k/R) e_T - k a' e_R]
 *         = mu Q [(3 a' + R a'') e_T - R a'^2 e_R],
 *   x_tt  = R Q (a_tt e_T - a_t^2 e_R),  a_tt = -pi^2 a,
 * b = x_tt - DIV P/rho = Q [(R a_tt - m (3 a' + R a'')) e_T + R (m a'^2 - a_t^2) e_R], m = mu/rho.
 * At t = 0 and 1 the body is undeformed. */
#include <math.h>
#include "common/contract/chunk_trig.h"
#include "common/contract/layout.h"
#include "common/contract/problem.h"

enum { TURN, E, NU, RHO, OFFSET_X, OFFSET_Y };

static const double inner = 0.75, outer = 1.25; /* [m] */

static const Param params[] = {
    {"G", 1, -1.5, 1.5, "rad", "amplitude: largest turn, of the circle R = 1 at t = 1/2",
     "Kamojjala et al. 2013", NULL},
    {"E", 1000, 1e-12, 1e15, "Pa", "Young's modulus", "Kamojjala et al. 2013", NULL},
    {"nu", 0.3, 0, 0.4999, "", "Poisson's ratio", "Kamojjala et al. 2013", NULL},
    {"rho", 1000, 1e-12, 1e15, "kg/m^3", "density", "Kamojjala et al. 2013", NULL},
    {"offset_x", 0, -1, 1, "h", "centre of the ring off the grid line x = 0", "", NULL},
    {"offset_y", 0, -1, 1, "h", "centre of the ring off the grid line y = 0", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, s->par[E], s->par[NU], s->par[RHO]);
    s->c = material_wave_speed_bound(&s->mat);
    s->t_end = 1;
    s->error_scale = scale_of_motion(s->par[TURN], 1);
    s->body =
        (Body){BODY_RING, {s->par[OFFSET_X] * s->cell, s->par[OFFSET_Y] * s->cell}, inner, outer, 0,
               2 * M_PI};
    for (int d = 0; d < DIM; d++) {
        s->lo[d] = -2;
        s->hi[d] = 2;
        s->body_lo[d] = s->body.centre[d] - outer;
        s->body_hi[d] = s->body.centre[d] + outer;
    }
    return 0;
}

/* A point of the reference ring: from the centre, and h, h', h'' at its radius. */
typedef struct Place {
    double x, y, R, h, h1, h2;
} Place;

static Place place_of(const Scene *s, ConstFields X, int p)
{
    Place at = {.x = X[0][p] - s->body.centre[0], .y = X[1][p] - s->body.centre[1]};
    at.R = sqrt(at.x * at.x + at.y * at.y);
    const double q = (at.R - 1) * (at.R - 1);
    at.h = 1 + q * (256 * q - 32);
    at.h1 = (at.R - 1) * (1024 * q - 64);
    at.h2 = 3072 * q - 64;
    return at;
}

static bool inside(const Scene *s, const Vec X)
{
    const double R = hypot(X[0] - s->body.centre[0], X[1] - s->body.centre[1]);
    return R >= inner && R <= outer;
}

/* u = (Q - I) X, with 1 - cos a = 2 sin^2(a/2). */
static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double g = s->par[TURN] * sin(M_PI * t);
    for (int p = 0; p < n; p++) {
        const Place at = place_of(s, X, p);
        const double half = trig_sin(0.5 * g * at.h), S = trig_sin(g * at.h), C = 2 * half * half;
        u[0][p] = -C * at.x - S * at.y;
        u[1][p] = S * at.x - C * at.y;
    }
}

/* Both boundary circles are at rest, so t does not matter. */
static double distance(const Scene *s, const Vec x, double t)
{
    const double r = hypot(x[0] - s->body.centre[0], x[1] - s->body.centre[1]);
    (void)t;
    return fmin(r - inner, outer - r);
}

/* v = a_t(0) R e_T; L = a_t (e_T e_R^T - e_R e_T^T) + R a_t' e_T e_R^T. */
static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    const double rate = M_PI * s->par[TURN];
    (void)u, (void)F;
    for (int p = 0; p < n; p++) {
        const Place at = place_of(s, X, p);
        const double w = rate * at.h, shear = rate * at.h1 / at.R;
        v[0][p] = -w * at.y;
        v[1][p] = w * at.x;
        L[0][p] = -shear * at.x * at.y;
        L[1][p] = -w - shear * at.y * at.y;
        L[2][p] = w + shear * at.x * at.x;
        L[3][p] = shear * at.x * at.y;
    }
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    const double g = s->par[TURN] * sin(M_PI * t), rate = M_PI * s->par[TURN] * cos(M_PI * t);
    const double m = s->mat.mu / s->mat.rho;
    for (int p = 0; p < n; p++) {
        const Place at = place_of(s, X, p);
        const double a = g * at.h, a1 = g * at.h1, a2 = g * at.h2, a_t = rate * at.h;
        const double across = -M_PI * M_PI * a - m * (3 * a1 / at.R + a2); /* over R */
        const double along = m * a1 * a1 - a_t * a_t;                      /* over R */
        const double bx = along * at.x - across * at.y, by = along * at.y + across * at.x;
        double S, C;
        trig_sin_cos(a, &S, &C);
        b[0][p] = C * bx - S * by;
        b[1][p] = S * bx + C * by;
    }
}

/* Rings at mid radii, and surface particles on both circles, as the oscillating ring has them. */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    layout_fill_arcs(out, s, inner, outer, spacing);
    layout_add_arc(out, s, inner, 0, spacing, -1);
    layout_add_arc(out, s, outer, 0, spacing, 1);
    return true;
}

const Problem problem_vortex = {
    .info = {.name = "vortex",
             .label = "Generalized vortex",
             .about = "circles of a neo-Hookean ring turn: large shear, rotation, exact solution",
             .source = "Kamojjala et al. 2013",
             .formula = "a circle of radius R turns by G sin(pi t) (1 - 32 (R-1)^2 + 256 (R-1)^4), "
                        "body force to match",
             .scale = "1 m",
             .params = params},
    .cells = 32,
    .ppc = 4,
    .cfl = 0.3,
    .init = init,
    .inside = inside,
    .place = place,
    .start = start,
    .exact = exact,
    .distance = distance,
    .body = body,
};
