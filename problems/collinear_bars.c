/* collinear_bars.c: two equal elastic bars of length L = 1 m fly towards each other along one line,
 * meet, and exchange their velocities (one-dimensional wave equation).
 *
 * They meet at t0 = gap/(2 v0). From then on, tau = t - t0, the contact end rests and a front runs
 * away from it at c; it comes back from the free end after 2 L/c as a release, behind which the bar
 * flies with the other's velocity. At a distance s from the contact end, for the left bar (the
 * right one mirrored): u = v0 t until t0, then  u = v0 [t0 + min(tau, s/c) - max(0, tau - (2 L -
 * s)/c)]. At tau = 2 L/c all of a bar has -v0: they part. */
#include <math.h>
#include "contact.h"

enum { E = CONTACT_PARAMS, LAW, V0, GAP };

static const double length = 1, middle = 2; /* [m] of a bar; of the domain, where they meet */

static const Param params[] = {
    CONTACT_PARAM_LIST(0),
    {"E", 1e4, 1e-12, 1e15, "Pa", "Young's modulus; density, length and area are 1", "", NULL},
    {"law", LINEAR, 0, 1, "", "material law", "W11 eq 32", "neo_hookean|linear"},
    {"v0", 0.1, 1e-6, 10, "m/s", "initial velocity of the left bar; the right one has -v0", "",
     NULL},
    {"gap", 0, 0, 0.5, "m", "initial distance of the bars", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    contact_read(s);
    s->mat = material_make((Law)s->par[LAW], s->par[E], 0, 1);
    s->hi[0] = 2 * middle;
    s->body_lo[0] = middle - length - 0.5 * s->par[GAP];
    s->body_hi[0] = middle + length + 0.5 * s->par[GAP];
    s->c = material_wave_speed_bar(&s->mat);
    s->t_end = 0.5 * s->par[GAP] / s->par[V0] + 2.5 * length / s->c;
    s->error_scale = s->par[V0] * length / s->c;
    return 0;
}

static void part(Scene *s, int body)
{
    if (body == 0) s->body_hi[0] = middle - 0.5 * s->par[GAP];
    if (body == 1) s->body_lo[0] = middle + 0.5 * s->par[GAP];
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)u, (void)F, (void)L;
    for (int p = 0; p < n; p++) v[0][p] = X[0][p] < middle ? s->par[V0] : -s->par[V0];
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double flight = 0.5 * s->par[GAP] / s->par[V0], tau = fmax(t - flight, 0);
    for (int p = 0; p < n; p++) {
        const double from = fabs(X[0][p] - middle) - 0.5 * s->par[GAP];
        const double way =
            fmin(t, flight) + fmin(tau, from / s->c) - fmax(0, tau - (2 * length - from) / s->c);
        u[0][p] = (X[0][p] < middle ? 1 : -1) * s->par[V0] * way;
    }
}

const Problem problem_collinear_bars = {
    .info = {.name = "collinear_bars",
             .label = "collinear bars",
             .about = "two equal bars collide and exchange their velocities",
             .source = "",
             .formula = "u = +-v0 [t0 + min(tau, s/c) - max(0, tau - (2 L - s)/c)], tau = t - t0 > "
                        "0, t0 = gap/(2 v0), s from the contact end",
             .scale = "v0 L/c",
             .params = params},
    .cells = 100,
    .ppc = 2,
    .cfl = 0.5,
    .init = init,
    .part = part,
    .start = start,
    .exact = exact,
};
