/* axis_mms.c: axis-aligned displacement, a manufactured solution on the unit square or cube (after
 * Wallstedt & Guilkey 2008): lines along an axis stay straight,
 *
 *   u_i = A sin(pi X_i) sin(c pi t + phi_i),  phi = 0, pi; 3D: 0, 2 pi/3, 4 pi/3,  c = sqrt(E/rho),
 *   F_i = 1 + pi A cos(pi X_i) sin(c pi t + phi_i),  J = prod_i F_i.
 *
 * Body force. F is diagonal, so P_ii = (lambda ln J + mu (F_i^2 - 1))/F_i; with
 *   dF_i/dX_i = -pi^2 u_i,
 *   dP_ii/dX_i = -pi^2 u_i [lambda (1 - ln J)/F_i^2 + mu (1 + 1/F_i^2)],
 *   b_i = u_i,tt - (dP_ii/dX_i)/rho
 *       = (pi^2 u_i/rho) [lambda (1 - ln J)/F_i^2 + mu (1 + 1/F_i^2) - E].
 * The body starts with its exact displacement (none in 2D) and velocity; normal velocities vanish
 * on the sides. */
#include <math.h>
#include "common/contract/chunk_log.h"
#include "common/contract/chunk_trig.h"
#include "common/contract/problem.h"

enum { AMPLITUDE, E, NU, RHO };

static const Param params[] = {
    {"A", 0.05, -0.3, 0.3, "m", "amplitude", "", NULL},
    {"E", 1e4, 1e-12, 1e15, "Pa", "Young's modulus", "", NULL},
    {"nu", 0.3, 0, 0.49, "", "Poisson's ratio", "", NULL},
    {"rho", 1, 1e-12, 1e15, IN_THIS_DIM("kg/m", "kg/m^2", "kg/m^3"), "density", "", NULL},
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

/* A sin(c pi t + phi_d). */
static double amplitude(const Scene *s, int d, double t)
{
    if (DIM > 2) return s->par[AMPLITUDE] * sin(M_PI * s->c * t + 2 * M_PI / 3 * d);
    return (d % 2 ? -1 : 1) * s->par[AMPLITUDE] * sin(M_PI * s->c * t);
}

/* Its rate of change at t = 0. */
static double first_rate(const Scene *s, int d)
{
    const double most = s->par[AMPLITUDE] * M_PI * s->c;
    return DIM > 2 ? most * cos(2 * M_PI / 3 * d) : d % 2 ? -most : most;
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    for (int d = 0; d < DIM; d++) {
        const double a = amplitude(s, d, t);
        for (int p = 0; p < n; p++) u[d][p] = a * trig_sin(M_PI * X[d][p]);
    }
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    for (int d = 0; d < DIM; d++) {
        const double size = amplitude(s, d, 0), rate = first_rate(s, d);
        for (int p = 0; p < n; p++) {
            const double own = 1 + M_PI * size * cos(M_PI * X[d][p]);
            u[d][p] = size * sin(M_PI * X[d][p]);
            v[d][p] = rate * sin(M_PI * X[d][p]);
            F[d * (DIM + 1)][p] = own;
            L[d * (DIM + 1)][p] = rate * M_PI * cos(M_PI * X[d][p]) / own;
        }
    }
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    const Material m = s->mat;
    double a[DIM];
    for (int d = 0; d < DIM; d++) a[d] = amplitude(s, d, t);
    for (int p = 0; p < n; p++) {
        double u[DIM], F[DIM], J = 1;
        for (int d = 0; d < DIM; d++) {
            double sine, cosine;
            trig_sin_cos(M_PI * X[d][p], &sine, &cosine);
            u[d] = a[d] * sine;
            F[d] = 1 + M_PI * a[d] * cosine;
            J *= F[d];
        }
        const double pressure = m.lambda * (1 - log_one(J));
        for (int d = 0; d < DIM; d++) {
            const double iF2 = 1 / (F[d] * F[d]);
            b[d][p] = M_PI * M_PI * u[d] / m.rho * (pressure * iF2 + m.mu * (1 + iF2) - m.E);
        }
    }
}

const Problem problem_axis_mms = {
    .info = {.name = "axis_mms",
             .label = "axis-aligned displacement",
             .about = "large-strain standing waves along all axes, exact solution",
             .source = "Wallstedt & Guilkey 2008",
             .formula = "u_i = A sin(pi X_i) sin(c pi t + phi_i), phi = " IN_THIS_DIM(
                 "0", "0, pi", "0, 2 pi/3, 4 pi/3") ", body force to match",
             .scale = "A",
             .params = params},
    .cells = 32,
    .ppc = IN_THIS_DIM(2, 4, 8),
    .cfl = 0.3,
    .init = init,
    .start = start,
    .exact = exact,
    .body = body,
};
