/* shell.c: oscillating spherical shell in 3D, the ring's manufactured solution one dimension up
 * (radial.h; coefficients of W11 eq 37): no traction on either surface, since nu = 0. One octant
 * between three symmetry planes, or the whole shell, placed anywhere on the grid and turned. */
#include <stdio.h>
#include "common/contract/sphere.h"
enum { RADIAL_AXES = DIM };
#include "radial.h"

enum { AMPLITUDE, SECTOR, OFFSET, ANGLE = OFFSET + DIM, TRACTION };
enum { OCTANT, FULL };

static const Param params[] = {
    {"A", 0.1, -0.15, 0.15, "m", "amplitude: displacement at the outer radius", "", NULL},
    {"sector", OCTANT, 0, 1, "", "an octant with symmetry planes, or the full shell", "",
     "octant|full"},
    {"offset_x", 0, -1, 1, "h", "full: centre of the shell off the grid plane x = 0", "", NULL},
    {"offset_y", 0, -1, 1, "h", "full: centre of the shell off the grid plane y = 0", "", NULL},
    {"offset_z", 0, -1, 1, "h", "full: centre of the shell off the grid plane z = 0", "", NULL},
    {"angle", 0, -360, 360, "deg",
     "full: turn of body-fitted points or mesh about the axis (1, 2, 3)", "", NULL},
    RADIAL_TRACTION,
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    const double axis[3] = {1, 2, 3};
    const bool full = s->par[SECTOR] > 0;
    double moved = fabs(s->par[ANGLE]);
    for (int d = 0; d < DIM; d++) moved += fabs(s->par[OFFSET + d]);
    if (!full && moved > 0) {
        snprintf(why, 128, "offset_x, offset_y, offset_z and angle need sector=full");
        return -1;
    }
    s->traction = s->par[TRACTION] > 0;
    radial_init(s);
    s->body = (Body){.kind = BODY_SHELL, .inner = radial_inner, .outer = radial_outer};
    s->octant = !full;
    sphere_turn(axis, s->par[ANGLE] * M_PI / 180, s->turn);
    for (int d = 0; d < DIM; d++) s->body.centre[d] = s->par[OFFSET + d] * s->cell;
    radial_bounds(s, full);
    return 0;
}

/* Spheres at mid radii, and surface particles on both surfaces. */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    sphere_fill(out, s, radial_inner, radial_outer, spacing);
    sphere_add(out, s, radial_inner, 0, spacing, -1);
    sphere_add(out, s, radial_outer, 0, spacing, 1);
    return true;
}

/* Both spheres, shares of their areas: those of a layer of thickness 1 over its volume per area. */
static void surface(const Scene *s, double spacing, Layout *out)
{
    for (int side = -1; side < 2; side += 2) {
        const double R = side > 0 ? radial_outer : radial_inner, layer = 1 + 1 / (12 * R * R);
        const int first = out->n;
        sphere_add(out, s, R, 1, spacing, side);
        for (int p = first; p < out->n; p++) out->volume[p] /= layer;
    }
}

const Problem problem_shell = {
    .info = {.name = "shell",
             .label = "Oscillating shell",
             .about = "large-strain oscillation of a neo-Hookean spherical shell, exact solution",
             .source = "after W11 5.1",
             .formula = "u(R) = A cos(c pi t) (c1 R + c2 R^2 + c3 R^3), body force to match",
             .scale = "1 m",
             .params = params},
    .cells = 32,
    .ppc = 8,
    .cfl = 0.3,
    .init = init,
    .inside = radial_inside,
    .place = place,
    .start = radial_start,
    .exact = radial_exact,
    .distance = radial_distance,
    .body = radial_body,
    .surface = surface,
    .traction = radial_traction,
};
