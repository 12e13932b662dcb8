/* ring.c: oscillating ring, a manufactured solution at large strain (W11 5.1, eqs 36, 37;
 * radial.h). In 3D the same ring, two cells thick between symmetry planes. */
#include <stdio.h>
enum { RADIAL_AXES = 2, LAST = DIM - 1 }; /* in 3D: the axis of the ring */
#include "circles.h"
#include "radial.h"

enum { AMPLITUDE, SECTOR, OFFSET_X, OFFSET_Y, ANGLE, TRACTION };
enum { QUARTER, FULL };

static const Param params[] = {
    {"A", 0.1, -0.15, 0.15, "m", "amplitude: displacement at the outer radius", "W11 5.1", NULL},
    {"sector", QUARTER, 0, 1, "", "quarter ring with symmetry lines, or the full ring", "W11 fig 4",
     "quarter|full"},
    {"offset_x", 0, -1, 1, "h", "full: centre of the ring off the grid line x = 0", "", NULL},
    {"offset_y", 0, -1, 1, "h", "full: centre of the ring off the grid line y = 0", "", NULL},
    {"angle", 0, -360, 360, "deg", "full: turn of body-fitted points or mesh", "", NULL},
    RADIAL_TRACTION,
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

/* Symmetry planes on both sides of two cells along the ring's axis. */
static void set_thickness(Scene *s)
{
    s->lo[LAST] = s->body_lo[LAST] = 0;
    s->hi[LAST] = s->body_hi[LAST] = 2 * s->cell;
    s->wall[s->nwall++] = (Wall){.axis = LAST, .side = -1, .at = 0, .mirror = true};
    s->wall[s->nwall++] = (Wall){.axis = LAST, .side = 1, .at = s->hi[LAST], .mirror = true};
}

static int init(Scene *s, char why[128])
{
    const bool full = s->par[SECTOR] > 0;
    const double turn = s->par[ANGLE] * M_PI / 180;
    if (!full && (s->par[OFFSET_X] != 0 || s->par[OFFSET_Y] != 0 || s->par[ANGLE] != 0)) {
        snprintf(why, 128, "offset_x, offset_y and angle need sector=full");
        return -1;
    }
    s->traction = s->par[TRACTION] > 0;
    radial_init(s);
    s->body = (Body){.kind = BODY_RING,
                     .centre = {s->par[OFFSET_X] * s->cell, s->par[OFFSET_Y] * s->cell},
                     .inner = radial_inner,
                     .outer = radial_outer,
                     .angle_lo = turn,
                     .angle_hi = turn + (full ? 2 * M_PI : M_PI / 2)};
    radial_bounds(s, full);
    if (DIM > 2) set_thickness(s);
    return 0;
}

const Problem problem_ring = {
    .info = {.name = "ring",
             .label = "Oscillating ring",
             .about = "large-strain oscillation of a neo-Hookean ring, exact solution",
             .source = "W11 5.1, eqs 36, 37",
             .formula = "u(R) = A cos(c pi t) (c1 R + c2 R^2 + c3 R^3), body force to match",
             .scale = "1 m",
             .params = params},
    .cells = 32,
    .ppc = IN_THIS_DIM(2, 4, 8),
    .cfl = 0.3,
    .init = init,
    .inside = radial_inside,
    .place = circles_place,
    .start = radial_start,
    .exact = radial_exact,
    .distance = radial_distance,
    .body = radial_body,
    .surface = circles_surface,
    .traction = radial_traction,
};
