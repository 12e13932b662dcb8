/* cavity.c: a cube with a spherical cavity is pulled apart by a body acceleration b = (g X, 0, 0),
 * g = 5e6 1/s^2, suddenly and to large strains: the plate with a hole of W11 5.3 in 3D. One octant
 * between symmetry planes x = 0, y = 0, z = 0. There is no exact solution: fine FEM is the
 * reference. */
#include <math.h>
#include "common/contract/problem.h"
#include "common/contract/sphere.h"

static const double radius = 0.5, width = 1, gradient = 5e6; /* [m] [m] [1/s^2] */

static const Param params[] = {{NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    const double axis[3] = {1, 2, 3};
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 210e9, 0.3, 7850);
    s->c = material_wave_speed_bound(&s->mat);
    s->t_end = 696e-6;
    s->error_scale = 1;
    s->body = (Body){.kind = BODY_CAVITY, .inner = radius, .outer = width};
    s->octant = true;
    sphere_turn(axis, 0, s->turn);
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = 2 * width;
        s->body_hi[d] = width;
        s->wall[s->nwall++] = (Wall){.axis = d, .side = -1, .at = 0, .mirror = true};
    }
    return 0;
}

static double from_centre(const Vec X)
{
    double square = 0;
    for (int d = 0; d < DIM; d++) square += X[d] * X[d];
    return sqrt(square);
}

static bool inside(const Scene *s, const Vec X)
{
    bool in = from_centre(X) >= radius;
    (void)s;
    for (int d = 0; d < DIM; d++) in = in && X[d] <= width;
    return in;
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    (void)s, (void)t;
    for (int p = 0; p < n; p++) {
        for (int d = 0; d < DIM; d++) b[d][p] = 0;
        b[0][p] = gradient * X[0][p];
    }
}

/* Adds the points of an n x n x n lattice that lie beyond radius `from`, axis 0 fastest. */
static void add_lattice(int n, double from, double spacing, Layout *out)
{
    const long total = lround(pow(n, DIM));
    for (long k = 0; k < total && !out->lost; k++) {
        Vec X;
        long rest = k;
        for (int d = 0; d < DIM; d++, rest /= n) X[d] = ((double)(rest % n) + 0.5) * spacing;
        if (from_centre(X) > from) layout_add(out, X, pow(spacing, DIM), NULL);
    }
}

/* Surface points on the free faces: at mid spacing within a face; and one on the middle of the
 * spacing along each free edge and on the free corner, with the normal between their faces. */
static void add_faces(double spacing, Layout *out)
{
    const int n = (int)ceil(width / layout_surface_spacing(out, spacing) - 1e-9);
    for (unsigned faces = 1; faces < 1u << DIM; faces++) {
        const int met = __builtin_popcount(faces);
        const long total = lround(pow(n, DIM - met));
        for (long k = 0; k < total; k++) {
            Vec X, normal;
            long rest = k;
            for (int d = 0; d < DIM; d++) {
                const bool on = faces >> d & 1;
                X[d] = on ? width : ((double)(rest % n) + 0.5) * width / n;
                normal[d] = on ? 1 / sqrt(met) : 0;
                if (!on) rest /= n;
            }
            layout_add(out, X, 0, normal);
        }
    }
}

/* Two spheres of points around the cavity, the lattice beyond, surface particles on cavity and free
 * faces but not on the symmetry planes. The spacing is a whole part of the cube's side; where two
 * spheres would reach beyond the faces there are less. */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    const int n = (int)ceil(width / spacing - 1e-9);
    const double whole = fabs(n * spacing - width) <= 1e-12 * width ? spacing : width / n;
    const int layers = (int)fmin(2, floor((width - radius) / whole + 1e-9));
    const double from = radius + layers * whole;
    if (layers) sphere_fill(out, s, radius, from, whole);
    add_lattice(n, from, whole, out);
    if (whole < spacing) out->fit = whole / spacing;
    sphere_add(out, s, radius, 0, spacing, -1);
    add_faces(spacing, out);
    return true;
}

const Problem problem_cavity = {
    .info = {.name = "cavity",
             .label = "Cube with cavity",
             .about = "a cube with a spherical cavity is pulled apart by a sudden body force",
             .source = "after W11 5.3",
             .params = params},
    .cells = 16,
    .ppc = 8,
    .cfl = 0.4,
    .init = init,
    .inside = inside,
    .place = place,
    .body = body,
};
