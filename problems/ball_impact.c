/* ball_impact.c: a soft ball slides into the corner of a box with frictionless walls: the disk of
 * W11 5.2 in 3D (impact.h). */
#include "common/contract/sphere.h"
#include "impact.h"

static int init(Scene *s, char why[128])
{
    const double axis[3] = {1, 2, 3};
    (void)why;
    impact_init(s, (Body){.kind = BODY_BALL});
    sphere_turn(axis, 0, s->turn);
    return 0;
}

/* Spheres at mid radii, and surface particles on the outermost one. */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    sphere_fill(out, s, 0, impact_radius, spacing);
    sphere_add(out, s, impact_radius, 0, spacing, 1);
    return true;
}

const Problem problem_ball_impact = {
    .info = {.name = "ball_impact",
             .label = "Ball impact",
             .about = "a ball hits frictionless walls: energy through an impact",
             .source = "after W11 5.2",
             .params = impact_params},
    .cells = 24,
    .ppc = 8,
    .cfl = 0.4,
    .init = init,
    .inside = impact_inside,
    .place = place,
    .start = impact_begin,
};
