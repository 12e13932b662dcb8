/* disk_impact.c: a soft disk slides into the corner of a box with frictionless walls (W11 5.2).
 *
 * The disk flies freely until its lower edge meets the floor at t ~ .5, rebounds with vy reversed
 * while vx stays, and meets the right wall at t ~ 2.5. Walls: v_n = a_n = 0 on their nodes and
 * beyond, always (bilateral) or only while the body pushes (unilateral). No exact solution: energy
 * and momentum are what can be checked. */
#include <math.h>
#include "common/contract/layout.h"
#include "common/contract/problem.h"

enum { WALL };

static const double radius = 0.2, start_at = 0.3, speed = 0.2; /* [m] [m] [m/s] an axis */

static const Param params[] = {{"wall", 0, 0, 1, "",
                                "holds always, or only while the body pushes against it", "W11 5.2",
                                "bilateral|unilateral"},
                               {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 1000, 0.3, 1000);
    s->c = material_wave_speed_bound(&s->mat);
    s->t_end = 3;
    s->error_scale = 1;
    s->body = (Body){BODY_DISK, {start_at, start_at}, 0, radius, 0, 2 * M_PI};
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = 1;
        s->body_lo[d] = start_at - radius;
        s->body_hi[d] = start_at + radius;
        for (int side = -1; side <= 1; side += 2)
            s->wall[s->nwall++] = (Wall){.axis = d,
                                         .side = side,
                                         .at = side < 0 ? 0 : 1,
                                         .hold = 1u << d,
                                         .unilateral = s->par[WALL] > 0};
    }
    return 0;
}

static bool inside(const Scene *s, const Vec X)
{
    return hypot(X[0] - s->body.centre[0], X[1] - s->body.centre[1]) <= radius;
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)s, (void)X, (void)u, (void)F, (void)L;
    for (int p = 0; p < n; p++) {
        v[0][p] = speed;
        v[1][p] = -speed;
    }
}

/* Rings at mid radii, and surface particles on the circle. */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    const int rings = (int)ceil(radius / spacing - 1e-9);
    const double dr = radius / rings;
    for (int k = 0; k < rings; k++) layout_add_arc(out, s, (k + 0.5) * dr, dr, spacing, 0);
    layout_add_arc(out, s, radius, 0, spacing, 1);
    return true;
}

const Problem problem_disk_impact = {
    .info = {.name = "disk_impact",
             .label = "Disk impact",
             .about = "a disk hits frictionless walls: energy through an impact",
             .source = "W11 5.2, figs 7, 8",
             .params = params},
    .cells = 48,
    .ppc = 4,
    .cfl = 0.4,
    .init = init,
    .inside = inside,
    .place = place,
    .start = start,
};
