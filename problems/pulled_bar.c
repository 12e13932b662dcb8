/* pulled_bar.c: a bar of unit length, fixed at X = 0, pulled at its free end by a stress that grows
 * linearly over the time of one passage, L/c, and is held then. In 2D it is half as wide, its sides
 * are free.
 *
 * With P = E (F - 1) (law=linear, no Poisson effect) the wave equation u_tt = c^2 u_XX holds at any
 * amplitude. u = f(c t + X) - f(c t - X) vanishes at X = 0, and E u_X = p at X = L asks for
 *   f'(s) = p(s - L)/E - f'(s - 2L),  so  f(s) = Q(s - L) - Q(s - 3L) + ...  (d'Alembert),
 * where Q is the integral of p/E over c t: of the ramp, .01 s^2/(2 L), then .01 (s - L/2).
 * Errors are divided by the final elongation under the held stress, .01 L. */
#include <math.h>
#include "common/contract/layout.h"
#include "common/contract/problem.h"

enum { E, LAW, PULL };

static const double length = 1; /* [m] */

static const Param params[] = {
    {"E", 1e4, 1e-12, 1e15, "Pa", "Young's modulus; density, length are 1", "", NULL},
    {"law", LINEAR, 0, 1, "", "material law", "W11 eq 32", "neo_hookean|linear"},
    {"pull", 0.01, -0.5, 0.5, "E", "stress at the end after the ramp", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make((Law)s->par[LAW], s->par[E], 0, 1);
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = 2;
        s->body_lo[d] = d == 0 ? 0 : 0.75;
        s->body_hi[d] = d == 0 ? length : 1.25;
    }
    s->wall[s->nwall++] = (Wall){.axis = 0, .side = -1, .at = 0, .hold = (1u << DIM) - 1};
    s->traction = true;
    s->c = material_wave_speed_bar(&s->mat);
    s->t_end = 2 * length / s->c;
    s->error_scale = scale_of_motion(s->par[PULL], s->par[PULL] * length);
    return 0;
}

/* Integral of p/(pull E) from 0 to s [m]. */
static double ramp(double s)
{
    if (!(s > 0)) return 0;
    return s < length ? 0.5 * s * s / length : s - 0.5 * length;
}

static double wave(double s)
{
    double sum = 0, sign = 1;
    for (double at = s - length; at > 0; at -= 2 * length, sign = -sign) sum += sign * ramp(at);
    return sum;
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double ct = s->c * t;
    for (int p = 0; p < n; p++) {
        for (int d = 0; d < DIM; d++) u[d][p] = 0;
        u[0][p] = s->par[PULL] * (wave(ct + X[0][p]) - wave(ct - X[0][p]));
    }
}

static void surface(const Scene *s, double spacing, Layout *out)
{
    layout_add_face(out, s, 0, 1, spacing, true);
}

static void traction(const Scene *s, int n, ConstFields X, ConstFields N, double t, Fields out)
{
    const double p = s->par[PULL] * s->par[E] * fmin(s->c * t / length, 1);
    for (int k = 0; k < n; k++)
        for (int d = 0; d < DIM; d++)
            out[d][k] = d == 0 && N[0][k] > 0.5 && X[0][k] > 0.5 * length ? p : 0;
}

const Problem problem_pulled_bar = {
    .info = {.name = "pulled_bar",
             .label = "pulled bar",
             .about = "a bar pulled at its end by a stress that ramps up, exact solution",
             .source = "W11 eq 3",
             .formula = "u = f(c t + X) - f(c t - X), f(s) = Q(s - L) - Q(s - 3 L) + ..., Q the "
                        "integral of the end stress/E over c t",
             .scale = "pull L, the elongation under the held stress",
             .params = params},
    .cells = 40,
    .ppc = IN_THIS_DIM(2, 4, 8),
    .cfl = 0.2,
    .init = init,
    .exact = exact,
    .surface = surface,
    .traction = traction,
};
