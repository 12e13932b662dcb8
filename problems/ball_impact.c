/* ball_impact.c: a soft ball slides into the corner of a box with frictionless walls: the disk of
 * W11 5.2 in 3D, on 24 cells.
 *
 * The ball flies freely until it meets the floor y = 0 at t ~ .5, rebounds with vy reversed while
 * vx stays, and meets the wall x = 1 at t ~ 2.5. Walls: v_n = a_n = 0 on their nodes and beyond,
 * always (bilateral) or only while the body pushes (unilateral). There is no exact solution; energy
 * and momentum are judged. */
#include <math.h>
#include "common/contract/problem.h"
#include "common/contract/sphere.h"

enum { WALL };

static const double radius = 0.2, start_at = 0.3, speed = 0.2; /* [m] [m] [m/s] an axis */

static const Param params[] = {{"wall", 0, 0, 1, "",
                                "holds always, or only while the body pushes against it", "W11 5.2",
                                "bilateral|unilateral"},
                               {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    const double axis[3] = {1, 2, 3};
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 1000, 0.3, 1000);
    s->c = material_wave_speed_bound(&s->mat);
    s->t_end = 3;
    s->error_scale = 1;
    s->body = (Body){.kind = BODY_BALL, .outer = radius};
    sphere_turn(axis, 0, s->turn);
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = 1;
        s->body.centre[d] = start_at;
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
    double square = 0;
    for (int d = 0; d < DIM; d++) square += pow(X[d] - s->body.centre[d], 2);
    return square <= radius * radius;
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)s, (void)X, (void)u, (void)F, (void)L;
    for (int p = 0; p < n; p++) {
        v[0][p] = speed;
        v[1][p] = -speed;
    }
}

/* Spheres at mid radii, and surface particles on the outermost one. */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    sphere_fill(out, s, 0, radius, spacing);
    sphere_add(out, s, radius, 0, spacing, 1);
    return true;
}

const Problem problem_ball_impact = {
    .info = {.name = "ball_impact",
             .label = "Ball impact",
             .about = "a ball hits frictionless walls: energy through an impact",
             .source = "after W11 5.2",
             .params = params},
    .cells = 24,
    .ppc = 8,
    .cfl = 0.4,
    .init = init,
    .inside = inside,
    .place = place,
    .start = start,
};
