/* sine_bar.c: standing wave in a bar with fixed ends (W07 5.2, fig 13).
 *
 * u(X, t) = A sin(pi X) cos(c pi t), c = sqrt(E/rho). Exact at any amplitude for sigma = E (F - 1),
 * whose V0 J sigma F^-1 = V0 E (F - 1) makes the wave equation linear; the neo-Hookean law departs
 * from it at finite strain, which is why its convergence tails off. */
#include <math.h>
#include "common/contract/chunk_trig.h"
#include "common/contract/problem.h"

enum { E, A, LAW };

static const Param params[] = {
    {"E", 1e4, 1e-12, 1e15, "Pa", "Young's modulus; density and length are 1", "W07 5.2", NULL},
    {"A", 0.01, -0.3, 0.3, "m", "amplitude", "W07 5.2", NULL},
    {"law", NEO_HOOKEAN, 0, 1, "", "material law", "W11 eq 32", "neo_hookean|linear"},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make((Law)s->par[LAW], s->par[E], 0, 1);
    s->hi[0] = s->body_hi[0] = 1;
    s->wall[s->nwall++] = (Wall){.axis = 0, .side = -1, .at = 0, .hold = 1};
    s->wall[s->nwall++] = (Wall){.axis = 0, .side = 1, .at = 1, .hold = 1};
    s->c = material_wave_speed_bar(&s->mat);
    s->t_end = 0.5 / s->c; /* a quarter period */
    s->error_scale = scale_of_motion(s->par[A], s->par[A]);
    return 0;
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double a = s->par[A] * cos(s->c * M_PI * t);
    for (int p = 0; p < n; p++) u[0][p] = a * trig_sin(M_PI * X[0][p]);
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)v, (void)L;
    exact(s, n, X, 0, u);
    for (int p = 0; p < n; p++) F[0][p] = 1 + s->par[A] * M_PI * cos(M_PI * X[0][p]);
}

const Problem problem_sine_bar = {
    .info = {.name = "sine_bar",
             .label = "sine bar",
             .about = "standing wave in a bar with fixed ends",
             .source = "W07 5.2, fig 13",
             .formula = "u = A sin(pi X) cos(c pi t)",
             .scale = "A",
             .params = params},
    .cells = 40,
    .ppc = 2,
    .cfl = 0.2,
    .init = init,
    .start = start,
    .exact = exact,
};
