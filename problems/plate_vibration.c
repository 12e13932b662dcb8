/* plate_vibration.c: in-plane vibration of a unit square (Soedel 2004; W07 5.3, figs 14, 15).
 *
 *   u = A cos(pi x) sin(pi y) cos wt,  v = -+A sin(pi x) cos(pi y) cos wt
 * Shear mode (upper sign): free of divergence, w = pi sqrt(2 mu/rho). Dilatational mode (lower
 * sign): free of rotation, w = pi sqrt(2 (lambda + 2 mu)/rho). Sides are free to move along their
 * normal, not along themselves: tangential velocity 0 on the side nodes and on all nodes beyond. */
#include <math.h>
#include "common/contract/chunk_trig.h"
#include "common/contract/problem.h"

enum { A, MODE, LAW, NU };
enum { SHEAR, DILATATIONAL };
enum { OMEGA, SIGN }; /* s->k */

static const Param params[] = {
    {"A", 0.004, -0.1, 0.1, "m", "amplitude", "W07 5.3", NULL},
    {"mode", SHEAR, 0, 1, "", "which of the two modes with this period in space", "Soedel 2004",
     "shear|dilatational"},
    {"law", NEO_HOOKEAN, 0, 1, "", "material law", "W11 eq 32", "neo_hookean|linear"},
    {"nu", 0.3, 0, 0.4999, "", "Poisson's ratio", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    const bool shear = (int)s->par[MODE] == SHEAR;
    (void)why;
    s->mat = material_make((Law)s->par[LAW], 1000, s->par[NU], 1);
    for (int d = 0; d < DIM; d++) {
        s->lo[d] = -0.25;
        s->hi[d] = 1.25;
        s->body_hi[d] = 1;
        const unsigned tangential = 1u << (1 - d);
        s->wall[s->nwall++] = (Wall){.axis = d, .side = -1, .at = 0, .hold = tangential};
        s->wall[s->nwall++] = (Wall){.axis = d, .side = 1, .at = 1, .hold = tangential};
    }
    const double speed = shear ? sqrt(s->mat.mu / s->mat.rho) : material_wave_speed_p(&s->mat);
    s->c = material_wave_speed_p(&s->mat);
    s->k[OMEGA] = M_PI * sqrt(2) * speed;
    s->k[SIGN] = shear ? -1 : 1;
    s->t_end = M_PI / 2 / s->k[OMEGA]; /* a quarter period */
    s->error_scale = scale_of_motion(s->par[A], s->par[A]);
    return 0;
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double a = s->par[A] * cos(s->k[OMEGA] * t), b = s->k[SIGN] * a;
    for (int p = 0; p < n; p++) {
        double sin_x, cos_x, sin_y, cos_y;
        trig_sin_cos(M_PI * X[0][p], &sin_x, &cos_x);
        trig_sin_cos(M_PI * X[1][p], &sin_y, &cos_y);
        u[0][p] = a * cos_x * sin_y;
        u[1][p] = b * sin_x * cos_y;
    }
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    const double a = s->par[A] * M_PI, b = s->k[SIGN] * a;
    (void)v, (void)L;
    exact(s, n, X, 0, u);
    for (int p = 0; p < n; p++) {
        const double x = M_PI * X[0][p], y = M_PI * X[1][p];
        F[0][p] = 1 - a * sin(x) * sin(y);
        F[1][p] = a * cos(x) * cos(y);
        F[2][p] = b * cos(x) * cos(y);
        F[3][p] = 1 - b * sin(x) * sin(y);
    }
}

const Problem problem_plate_vibration = {
    .info = {.name = "plate_vibration",
             .label = "plate vibration",
             .about = "in-plane vibration of a square plate",
             .source = "W07 5.3, figs 14, 15; Soedel 2004",
             .formula = "u = A cos(pi X) sin(pi Y) cos wt, v = -A sin(pi X) cos(pi Y) cos wt, w = "
                        "pi sqrt(2 mu/rho)",
             .scale = "A",
             .params = params},
    .cells = 32,
    .ppc = 4,
    .cfl = 0.2,
    .init = init,
    .start = start,
    .exact = exact,
};
