/* axis_mms.c: axis-aligned displacement, a manufactured solution on the unit square (after
 * Wallstedt & Guilkey 2008): lines along an axis stay straight,
 *
 *   u_i = A sin(pi X_i) sin(c pi t + phi_i),  phi = 0, pi,  c = sqrt(E/rho),
 *   F_i = 1 + pi A cos(pi X_i) sin(c pi t + phi_i),  J = F_1 F_2.
 *
 * Body force. F is diagonal, so P_ii = (lambda ln J + mu (F_i^2 - 1))/F_i; with dF_i/dX_i = -pi^2
 * u_i dP_ii/dX_i = -pi^2 u_i [lambda (1 - ln J)/F_i^2 + mu (1 + 1/F_i^2)], b_i = u_i,tt -
 * (dP_ii/dX_i)/rho = (pi^2 u_i/rho) [lambda (1 - ln J)/F_i^2 + mu (1 + 1/F_i^2) - E]. The body
 * starts at rest position with its exact velocity; normal velocities vanish on the sides. */
#include <math.h>
#include "common/contract/problem.h"

enum { AMPLITUDE, E, NU, RHO };

static const Param params[] = {{"A", 0.05, -0.3, 0.3, "m", "amplitude", "PHYSICS 7b", NULL},
                               {"E", 1e4, 1e-12, 1e15, "Pa", "Young's modulus", "PHYSICS 7b", NULL},
                               {"nu", 0.3, 0, 0.49, "", "Poisson's ratio", "PHYSICS 7b", NULL},
                               {"rho", 1, 1e-12, 1e15, "kg/m^2", "density", "PHYSICS 7b", NULL},
                               {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, s->par[E], s->par[NU], s->par[RHO]);
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = s->body_hi[d] = 1;
        s->wall[s->nwall++] = (Wall){.axis = d, .side = -1, .at = 0, .hold = 1u << d};
        s->wall[s->nwall++] = (Wall){.axis = d, .side = 1, .at = 1, .hold = 1u << d};
    }
    s->c = material_wave_speed_bar(&s->mat);
    s->t_end = 2 / s->c; /* one period */
    s->error_scale = scale_of_motion(s->par[AMPLITUDE], s->par[AMPLITUDE]);
    return 0;
}

/* A sin(c pi t + phi_d), phi = 0 or pi. */
static double amplitude(const Scene *s, int d, double t)
{
    return (d % 2 ? -1 : 1) * s->par[AMPLITUDE] * sin(M_PI * s->c * t);
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) u[d][p] = amplitude(s, d, t) * sin(M_PI * X[d][p]);
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)u, (void)F;
    for (int d = 0; d < DIM; d++) {
        const double speed = (d % 2 ? -1 : 1) * s->par[AMPLITUDE] * M_PI * s->c;
        for (int p = 0; p < n; p++) {
            v[d][p] = speed * sin(M_PI * X[d][p]);
            L[d * (DIM + 1)][p] = speed * M_PI * cos(M_PI * X[d][p]);
        }
    }
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    const Material *m = &s->mat;
    for (int p = 0; p < n; p++) {
        double F[DIM], J = 1;
        for (int d = 0; d < DIM; d++) {
            F[d] = 1 + M_PI * amplitude(s, d, t) * cos(M_PI * X[d][p]);
            J *= F[d];
        }
        for (int d = 0; d < DIM; d++) {
            const double u = amplitude(s, d, t) * sin(M_PI * X[d][p]), iF2 = 1 / (F[d] * F[d]);
            b[d][p] = M_PI * M_PI * u / m->rho *
                      (m->lambda * (1 - log(J)) * iF2 + m->mu * (1 + iF2) - m->E);
        }
    }
}

const Problem problem_axis_mms = {
    .info = {.name = "axis_mms",
             .label = "axis-aligned displacement",
             .about = "large-strain standing waves along both axes, exact solution",
             .source = "Wallstedt & Guilkey 2008",
             .formula = "u_i = A sin(pi X_i) sin(c pi t + phi_i), phi = 0, pi, body force to match",
             .scale = "A",
             .params = params},
    .cells = 32,
    .ppc = 4,
    .cfl = 0.3,
    .init = init,
    .start = start,
    .exact = exact,
    .body = body,
};
