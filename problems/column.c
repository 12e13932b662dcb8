/* column.c: a bar of unit length under its own weight, held on top and free below, that starts at
 * rest: gravity is applied at once. In 2D it is half as wide, its sides are free.
 *
 * With sigma = E (F - 1) (law=linear, no Poisson effect) the displacement w downwards, at s from
 * the top, obeys w_tt = c^2 w_ss + g at any amplitude, w = 0 at s = 0, w_s = 0 at s = 1. The
 * static w_0 = (g/c^2)(s - s^2/2), odd about the top and even about the free end, falls into two
 * waves (d'Alembert):
 *   w = w_0(s) - [w_0(s + c t) + w_0(s - c t)]/2,  period 4/c, largest g/c^2 at the free end.
 * The neo-Hookean law departs from it at finite strain. */
#include <math.h>
#include "common/contract/problem.h"

enum { E, LAW, GRAVITY };
enum { Y = DIM - 1 }; /* downwards is -Y */

static const double top = 2; /* [m] on a grid line of every mesh */

static const Param params[] = {
    {"E", 1e4, 1e-12, 1e15, "Pa", "Young's modulus; density, length are 1", "", NULL},
    {"law", LINEAR, 0, 1, "", "material law", "W11 eq 32", "neo_hookean|linear"},
    {"g", 100, -1e9, 1e9, "m/s^2", "gravity, downwards", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make((Law)s->par[LAW], s->par[E], 0, 1);
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = top;
        s->body_lo[d] = d == Y ? top - 1 : 0.75;
        s->body_hi[d] = d == Y ? top : 1.25;
    }
    s->wall[s->nwall++] = (Wall){.axis = Y, .side = 1, .at = top, .hold = (1u << DIM) - 1};
    s->c = material_wave_speed_bar(&s->mat);
    s->t_end = 4 / s->c;
    s->error_scale = fmax(fabs(s->par[GRAVITY]), 1e-300) / (s->c * s->c);
    return 0;
}

/* s - s^2/2 within 0 .. 2, odd about 0, of period 4. */
static double parabola(double s)
{
    const double r = s - 4 * floor(0.25 * s + 0.5); /* -2 .. 2 */
    return r - 0.5 * r * fabs(r);
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double scale = s->par[GRAVITY] / (s->c * s->c), ct = s->c * t;
    for (int p = 0; p < n; p++) {
        const double at = top - X[Y][p];
        for (int d = 0; d < DIM; d++) u[d][p] = 0;
        u[Y][p] = -scale * (parabola(at) - 0.5 * (parabola(at + ct) + parabola(at - ct)));
    }
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    (void)X, (void)t;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) b[d][p] = d == Y ? -s->par[GRAVITY] : 0;
}

const Problem problem_column = {
    .info = {.name = "column",
             .label = "column",
             .about = "a bar under its own weight, held on top and free below, exact solution",
             .source = "",
             .formula = "w = w0(s) - [w0(s + c t) + w0(s - c t)]/2 at s from the top, w0 = (g/c^2) "
                        "(s - s^2/2), odd, of period 4",
             .scale = "g/c^2",
             .params = params},
    .cells = 32,
    .ppc = IN_THIS_DIM(2, 4, 8),
    .cfl = 0.2,
    .init = init,
    .exact = exact,
    .body = body,
};
