/* two_disks.c: two soft disks fly towards each other along the diagonal, collide and rebound
 * (Sulsky, Chen & Schreyer 1994; Bardenhagen et al. 2001): the field's standard test.
 *
 * Radius .2 m, centres (.3, .3) and (.7, .7), velocities +-(.1, .1): contact at t = .586 s. The
 * second disk is the first one turned by half a turn, and the figure is symmetric about the
 * diagonal. There is no exact solution: energy, momentum and symmetry are judged. */
#include <math.h>
#include "contact.h"
#include "common/contract/layout.h"

static const double radius = 0.2, speed = 0.1, centre[2] = {0.3, 0.7}; /* [m] [m/s] [m] */

static const Param params[] = {CONTACT_PARAM_LIST(0), {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    contact_read(s);
    s->mat = material_make(NEO_HOOKEAN, 1000, 0.3, 1000);
    s->c = material_wave_speed_bound(&s->mat);
    s->t_end = 3;
    s->error_scale = 1;
    for (int d = 0; d < DIM; d++) {
        s->lo[d] = -0.25;
        s->hi[d] = 1.25;
        s->body_lo[d] = centre[0] - radius;
        s->body_hi[d] = centre[1] + radius;
    }
    return 0;
}

static void part(Scene *s, int body)
{
    s->body = (Body){.kind = BODY_DISK, .outer = radius, .angle_hi = 2 * M_PI};
    for (int d = 0; d < DIM; d++) {
        s->body.centre[d] = centre[body];
        s->body_lo[d] = centre[body] - radius;
        s->body_hi[d] = centre[body] + radius;
    }
}

static bool inside(const Scene *s, const Vec X)
{
    double square = 0;
    for (int d = 0; d < DIM; d++) square += pow(X[d] - s->body.centre[d], 2);
    return square <= radius * radius;
}

static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    layout_fill_arcs(out, s, 0, radius, spacing);
    layout_add_arc(out, s, radius, 0, spacing, 1);
    return true;
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)s, (void)u, (void)F, (void)L;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) v[d][p] = X[0][p] + X[1][p] < 1 ? speed : -speed;
}

const Problem problem_two_disks = {
    .info = {.name = "two_disks",
             .label = "two disks",
             .about = "two soft disks collide and rebound: energy through a contact",
             .source = "Sulsky et al. 1994",
             .params = params},
    .cells = 20,
    .ppc = 4,
    .cfl = 0.2,
    .init = init,
    .inside = inside,
    .part = part,
    .place = place,
    .start = start,
};
