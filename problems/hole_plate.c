/* hole_plate.c: a square plate with a round hole is pulled apart by a body acceleration b = (g X,
 * 0), g = 5e6 1/s^2 (W11 5.3), suddenly and to large strains. A quarter of it, symmetry lines x = 0
 * and y = 0. (W11 says "force vector"; as a force per volume the strain would be 1e-5.) No exact
 * solution: fine FEM is the reference (W11 fig 10). */
#include <math.h>
#include "common/contract/layout.h"
#include "common/contract/problem.h"

static const double radius = 0.5, width = 1, gradient = 5e6; /* [m] [m] [1/s^2] */

static const Param params[] = {{NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 210e9, 0.3, 7850);
    s->c = material_wave_speed_bound(&s->mat);
    s->t_end = 696e-6;
    s->error_scale = 1;
    s->body = (Body){BODY_HOLE_PLATE, {0, 0}, radius, width, 0, M_PI / 2};
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = 2 * width;
        s->body_hi[d] = width;
        s->wall[s->nwall++] = (Wall){.axis = d, .side = -1, .at = 0, .mirror = true};
    }
    return 0;
}

static bool inside(const Scene *s, const Vec X)
{
    (void)s;
    return hypot(X[0], X[1]) >= radius && X[0] <= width && X[1] <= width;
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    (void)s, (void)t;
    for (int p = 0; p < n; p++) {
        b[0][p] = gradient * X[0][p];
        b[1][p] = 0;
    }
}

/* Adds the points of an n x n lattice that lie beyond the rings, axis 0 fastest. */
static void add_lattice(int n, int rings, double spacing, Layout *out)
{
    for (int k = 0; k < n * n; k++) {
        Vec X = {(k % n + 0.5) * spacing, (k / n + 0.5) * spacing};
        if (X[0] < width && X[1] < width && hypot(X[0], X[1]) > radius + rings * spacing)
            layout_add(out, X, spacing * spacing, NULL);
    }
}

/* Surface points on the two free sides, and their common corner with the normal between. */
static void add_sides(double spacing, Layout *out)
{
    const int n = (int)ceil(width / layout_surface_spacing(out, spacing) - 1e-9);
    for (int d = 0; d < DIM; d++)
        for (int k = 0; k < n; k++) {
            Vec X, normal = {0};
            X[d] = width;
            X[1 - d] = (k + 0.5) * width / n;
            normal[d] = 1;
            layout_add(out, X, 0, normal);
        }
    layout_add(out, (Vec){width, width}, 0, (Vec){M_SQRT1_2, M_SQRT1_2});
}

/* Two rings around the hole, the lattice beyond, surface particles on hole and free sides but not
 * on the symmetry lines. The spacing is a whole part of the plate's width; where two rings
 * would reach beyond the sides there are fewer. */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    const int n = (int)ceil(width / spacing - 1e-9);
    const double whole = fabs(n * spacing - width) <= 1e-12 * width ? spacing : width / n;
    const int rings = (int)fmin(2, floor((width - radius) / whole + 1e-9));
    for (int k = 0; k < rings; k++)
        layout_add_arc(out, s, radius + (k + 0.5) * whole, whole, whole, 0);
    add_lattice(n, rings, whole, out);
    if (whole < spacing) out->fit = whole / spacing;
    layout_add_arc(out, s, radius, 0, spacing, -1);
    add_sides(spacing, out);
    return true;
}

const Problem problem_hole_plate = {
    .info = {.name = "hole_plate",
             .label = "Plate with hole",
             .about = "a plate with a hole is pulled apart by a sudden body force: surface stress",
             .source = "W11 5.3, figs 9, 10",
             .params = params},
    .cells = 32,
    .ppc = 4,
    .cfl = 0.4,
    .init = init,
    .inside = inside,
    .place = place,
    .body = body,
};
