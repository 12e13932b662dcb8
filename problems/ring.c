/* ring.c: oscillating ring, a manufactured solution at large strain (W11 5.1, eqs 36, 37).
 *
 *   u(R, t) = s(t) g(R) e_R,  s = A cos(w t), w = c pi, c = sqrt(E/rho),  g = c1 R + c2 R^2 + c3
 * R^3, g' = 0 at both radii, so that they are free of traction.
 *
 * Body force. nu = 0: P = mu (F - F^-T), mu = E/2, and F is diagonal in polar axes,
 *   F_rr = 1 + s g',  F_tt = 1 + s g/R,  P_rr = mu (F_rr - 1/F_rr),  P_tt likewise.
 * Balance of momentum rho u_tt = DIV P + rho b, with DIV P = dP_rr/dR + (P_rr - P_tt)/R:
 *   dP_rr/dR       = mu (1 + 1/F_rr^2) s g''
 *   (P_rr - P_tt)/R = mu (1 + 1/(F_rr F_tt)) (F_rr - F_tt)/R,  (F_rr - F_tt)/R = s (c2 + 2 c3 R)
 *   b_R = -w^2 s g - (c^2/2) s [(1 + 1/F_rr^2) g'' + (1 + 1/(F_rr F_tt)) (c2 + 2 c3 R)]. */
#include <math.h>
#include <stdio.h>
#include "common/contract/layout.h"
#include "common/contract/problem.h"

enum { AMPLITUDE, SECTOR, OFFSET_X, OFFSET_Y, ANGLE };
enum { QUARTER, FULL };
enum { C1, C2, C3, OMEGA }; /* s->k */

static const double inner = 0.5, outer = 1; /* [m] */

static const Param params[] = {
    {"A", 0.1, -0.15, 0.15, "m", "amplitude: displacement at the outer radius", "W11 5.1", NULL},
    {"sector", QUARTER, 0, 1, "", "quarter ring with symmetry lines, or the full ring", "W11 fig 4",
     "quarter|full"},
    {"offset_x", 0, -1, 1, "h", "full: centre of the ring off the grid line x = 0", "", NULL},
    {"offset_y", 0, -1, 1, "h", "full: centre of the ring off the grid line y = 0", "", NULL},
    {"angle", 0, -360, 360, "deg", "full: turn of body-fitted points or mesh", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    const bool full = s->par[SECTOR] > 0;
    const double D = outer - 3 * inner, turn = s->par[ANGLE] * M_PI / 180;
    if (!full && (s->par[OFFSET_X] != 0 || s->par[OFFSET_Y] != 0 || s->par[ANGLE] != 0)) {
        snprintf(why, 128, "offset_x, offset_y and angle need sector=full");
        return -1;
    }
    s->mat = material_make(NEO_HOOKEAN, 1e4, 0, 1);
    s->c = material_wave_speed_bar(&s->mat);
    s->t_end = 2 / s->c;
    s->error_scale = scale_of_motion(s->par[AMPLITUDE], 1);
    s->body = (Body){BODY_RING, {s->par[OFFSET_X] * s->cell, s->par[OFFSET_Y] * s->cell},
                     inner,     outer,
                     turn,      turn + (full ? 2 * M_PI : M_PI / 2)};
    for (int d = 0; d < DIM; d++) {
        s->lo[d] = full ? -2 : 0;
        s->hi[d] = 2;
        s->body_lo[d] = full ? s->body.centre[d] - outer : 0;
        s->body_hi[d] = s->body.centre[d] + outer;
        if (!full) s->wall[s->nwall++] = (Wall){.axis = d, .side = -1, .at = 0, .mirror = true};
    }
    s->k[C1] = -6 * inner / (outer * D); /* eq 37 */
    s->k[C2] = 3 * (outer + inner) / (outer * outer * D);
    s->k[C3] = -2 / (outer * outer * D);
    s->k[OMEGA] = M_PI * s->c;
    return 0;
}

static double amplitude(const Scene *s, double t)
{
    return s->par[AMPLITUDE] * cos(s->k[OMEGA] * t);
}

static bool inside(const Scene *s, const Vec X)
{
    double R = hypot(X[0] - s->body.centre[0], X[1] - s->body.centre[1]);
    return R >= inner && R <= outer;
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double a = amplitude(s, t), c1 = s->k[C1], c2 = s->k[C2], c3 = s->k[C3];
    for (int p = 0; p < n; p++) {
        double x = X[0][p] - s->body.centre[0], y = X[1][p] - s->body.centre[1];
        double R = sqrt(x * x + y * y), u_over_R = a * (c1 + R * (c2 + R * c3));
        u[0][p] = u_over_R * x;
        u[1][p] = u_over_R * y;
    }
}

/* The circles move to R + u(R, t). */
static double distance(const Scene *s, const Vec x, double t)
{
    const double a = amplitude(s, t), c1 = s->k[C1], c2 = s->k[C2], c3 = s->k[C3];
    const double lo = inner * (1 + a * (c1 + inner * (c2 + inner * c3)));
    const double hi = outer * (1 + a * (c1 + outer * (c2 + outer * c3)));
    const double r = hypot(x[0] - s->body.centre[0], x[1] - s->body.centre[1]);
    return fmin(r - lo, hi - r);
}

/* F = F_tt I + (F_rr - F_tt) e_R e_R^T; at rest, since u_t ~ sin(w t). */
static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)v, (void)L;
    const double a = amplitude(s, 0), c1 = s->k[C1], c2 = s->k[C2], c3 = s->k[C3];
    exact(s, n, X, 0, u);
    for (int p = 0; p < n; p++) {
        double x = X[0][p] - s->body.centre[0], y = X[1][p] - s->body.centre[1];
        double R = sqrt(x * x + y * y), F_tt = 1 + a * (c1 + R * (c2 + R * c3));
        double difference = a * (c2 / R + 2 * c3); /* (F_rr - F_tt)/R^2 */
        F[0][p] = F_tt + difference * x * x;
        F[1][p] = F[2][p] = difference * x * y;
        F[3][p] = F_tt + difference * y * y;
    }
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    const double a = amplitude(s, t), c1 = s->k[C1], c2 = s->k[C2], c3 = s->k[C3];
    const double w2 = s->k[OMEGA] * s->k[OMEGA], half_c2 = s->mat.mu / s->mat.rho;
    for (int p = 0; p < n; p++) {
        double x = X[0][p] - s->body.centre[0], y = X[1][p] - s->body.centre[1];
        double R = sqrt(x * x + y * y), g_over_R = c1 + R * (c2 + R * c3);
        double iF_rr = 1 / (1 + a * (c1 + R * (2 * c2 + R * 3 * c3)));
        double iF_tt = 1 / (1 + a * g_over_R);
        double stress =
            (1 + iF_rr * iF_rr) * (2 * c2 + 6 * c3 * R) + (1 + iF_rr * iF_tt) * (c2 + 2 * c3 * R);
        double b_over_R = -a * (w2 * g_over_R + half_c2 * stress / R);
        b[0][p] = b_over_R * x;
        b[1][p] = b_over_R * y;
    }
}

/* Points at mid angles on the circle of radius R, spacing s or less; dr = 0: on the surface. */
static void add_circle(const Scene *scene, double R, double dr, double spacing, Layout *out)
{
    const Body *b = &scene->body;
    const int quarters = scene->par[SECTOR] > 0 ? 4 : 1;
    const int n = quarters * (int)ceil(M_PI / 2 * R / spacing - 1e-9);
    const double arc = quarters * M_PI / 2 / n, outwards = R < 0.5 * (inner + outer) ? -1 : 1;
    for (int q = 0; q < n; q++) {
        double angle = b->angle_lo + (q + 0.5) * arc;
        Vec e = {cos(angle), sin(angle)};
        layout_add(out, (Vec){b->centre[0] + R * e[0], b->centre[1] + R * e[1]}, R * arc * dr,
                   dr > 0 ? NULL : (Vec){outwards * e[0], outwards * e[1]});
    }
}

/* Rings at mid radii, and surface particles on both circles (PHYSICS 7). */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    const int rings = (int)ceil((outer - inner) / spacing - 1e-9);
    const double dr = (outer - inner) / rings;
    for (int k = 0; k < rings; k++) add_circle(s, inner + (k + 0.5) * dr, dr, spacing, out);
    add_circle(s, inner, 0, layout_surface_spacing(out, spacing), out);
    add_circle(s, outer, 0, layout_surface_spacing(out, spacing), out);
    return true;
}

const Problem problem_ring = {
    .info = {.name = "ring",
             .label = "Oscillating ring",
             .about = "large-strain oscillation of a neo-Hookean ring, exact solution",
             .source = "W11 5.1, eqs 36, 37",
             .formula = "u(R) = A cos(c pi t) (c1 R + c2 R^2 + c3 R^3), body force to match",
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
