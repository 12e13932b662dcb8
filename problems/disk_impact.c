/* disk_impact.c: a soft disk slides into the corner of a box with frictionless walls (W11 5.2;
 * impact.h). */
#include "common/contract/layout.h"
#include "impact.h"

static int init(Scene *s, char why[128])
{
    (void)why;
    impact_init(s, (Body){.kind = BODY_DISK, .angle_hi = 2 * M_PI});
    return 0;
}

/* Rings at mid radii, and surface particles on the circle. */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    layout_fill_arcs(out, s, 0, impact_radius, spacing);
    layout_add_arc(out, s, impact_radius, 0, spacing, 1);
    return true;
}

const Problem problem_disk_impact = {
    .info = {.name = "disk_impact",
             .label = "Disk impact",
             .about = "a disk hits frictionless walls: energy through an impact",
             .source = "W11 5.2, figs 7, 8",
             .params = impact_params},
    .cells = 48,
    .ppc = 4,
    .cfl = 0.4,
    .init = init,
    .inside = impact_inside,
    .place = place,
    .start = impact_begin,
};
