/* bar.c: a bar in uniform motion whose left end is stopped at t = 0 (W07 5.2, eq 5.1, figs 11, 12).
 *
 * Linear wave equation: with t' = t mod 2 L/c, u = s v0 min(t', X/c, 2 L/c - t'), and s = +-1
 * changes sign each half period 2 L/c. The strain stays at v0/c = 1 %, so finite strain shows only
 * weakly. */
#include <math.h>
#include "common/contract/problem.h"

enum { E, LAW, V0 };

static const Param params[] = {
    {"E", 1e4, 1e-12, 1e15, "Pa", "Young's modulus; density, length and area are 1", "W07 5.2",
     NULL},
    {"law", NEO_HOOKEAN, 0, 1, "", "material law", "W11 eq 32", "neo_hookean|linear"},
    {"v0", 1, -1e6, 1e6, "m/s", "initial velocity", "W07 5.2", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make((Law)s->par[LAW], s->par[E], 0, 1);
    s->hi[0] = 1.25;
    s->body_hi[0] = 1;
    s->wall[s->nwall++] = (Wall){.axis = 0, .side = -1, .at = 0, .hold = 1};
    s->c = material_wave_speed_bar(&s->mat);
    s->t_end = 4 / s->c;
    s->error_scale = scale_of_motion(s->par[V0], s->par[V0] / s->c);
    return 0;
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)X, (void)u, (void)F, (void)L;
    for (int p = 0; p < n; p++) v[0][p] = s->par[V0];
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double half = 2 / s->c, turns = floor(t / half), rest = t - turns * half;
    const double sign = fmod(turns, 2) > 0 ? -1 : 1;
    const double edge = fmin(rest, half - rest); /* ends of the saw-tooth */
    const double v = sign * s->par[V0], c = s->c;
    for (int p = 0; p < n; p++) {
        const double arrival = X[0][p] / c;
        u[0][p] = v * (arrival < edge ? arrival : edge);
    }
}

const Problem problem_bar = {
    .info =
        {.name = "bar",
         .label = "saw-tooth bar",
         .about = "a moving bar is stopped at one end; saw-tooth displacements",
         .source = "W07 5.2, figs 11, 12",
         .formula =
             "u = +-v0 min(t', X/c, 2 L/c - t'), t' = t mod 2 L/c, its sign changing every 2 L/c",
         .scale = "v0 L/c",
         .params = params},
    .cells = 40,
    .ppc = 2,
    .cfl = 0.1,
    .init = init,
    .start = start,
    .exact = exact,
};
