/* free_bar.c: a bar with free ends in its first mode of vibration.
 *
 * u(X, t) = A cos(pi X) sin(c pi t), c = sqrt(E/rho): undeformed at first, with velocities A c pi
 * cos(pi X). Exact at any amplitude, since sigma = E (F - 1) makes the wave equation linear. */
#include <math.h>
#include "common/contract/problem.h"

enum { E, A };

static const Param params[] = {
    {"E", 1e4, 1, 1e12, "Pa", "Young's modulus; density and length are 1", "", NULL},
    {"A", 0.01, -0.1, 0.1, "m", "amplitude", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(LINEAR, s->par[E], 0, 1);
    s->lo[0] = -0.5, s->hi[0] = 1.5; /* the grid; nothing is held at its ends */
    s->body_lo[0] = 0, s->body_hi[0] = 1;
    s->c = material_wave_speed_bar(&s->mat);
    s->t_end = 0.5 / s->c; /* a quarter period */
    s->error_scale = scale_of_motion(s->par[A], s->par[A]);
    return 0;
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)u, (void)F, (void)L;
    for (int p = 0; p < n; p++) v[0][p] = s->par[A] * s->c * M_PI * cos(M_PI * X[0][p]);
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double a = s->par[A] * sin(s->c * M_PI * t);
    for (int p = 0; p < n; p++) u[0][p] = a * cos(M_PI * X[0][p]);
}

const Problem problem_free_bar = {
    .info = {.name = "free_bar",
             .label = "free bar",
             .about = "first mode of a bar with free ends",
             .formula = "u = A cos(pi X) sin(c pi t)",
             .scale = "A",
             .params = params},
    .cells = 20,
    .ppc = 2,
    .cfl = 0.2,
    .init = init,
    .start = start,
    .exact = exact,
};
