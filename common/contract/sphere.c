/* sphere.c: see sphere.h. */
#include "sphere.h"
#include <math.h>
#include "problem.h"

void sphere_turn(const double axis[3], double angle, Mat turn)
{
    const double c = cos(angle), s = sin(angle);
    const double length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) {
            const double own = a == b, next = (b + 1) % 3 == a, before = (a + 1) % 3 == b;
            const double cross = (next - before) * axis[(6 - a - b) % 3] / length;
            const double along = axis[a] * axis[b] / (length * length);
            turn[a * DIM + b] =
                DIM < 3 ? own : c * own + (1 - c) * along + (a == b ? 0 : s * cross);
        }
}

/* Unit vector at fractions s, t in [-1, 1] of the quarter turn that face `face` (0, 1, 2: the axis
 * it looks along) spans in its two other axes, cyclic. */
static void direction(int face, double s, double t, double e[3])
{
    e[face] = 1;
    e[(face + 1) % 3] = tan(M_PI / 4 * s);
    e[(face + 2) % 3] = tan(M_PI / 4 * t);
    const double length = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
    for (int a = 0; a < 3; a++) e[a] /= length;
}

/* Solid angle of the corner of a face from its middle to fractions s, t. */
static double corner_angle(double s, double t)
{
    const double x = tan(M_PI / 4 * s), y = tan(M_PI / 4 * t);
    return atan2(x * y, sqrt(1 + x * x + y * y));
}

/* Solid angle of cell (i, j) of the n x n cells on a quarter of a face. */
static double cell_angle(int i, int j, int n)
{
    const double s0 = (double)i / n, s1 = (i + 1.0) / n, t0 = (double)j / n, t1 = (j + 1.0) / n;
    return corner_angle(s1, t1) - corner_angle(s0, t1) - corner_angle(s1, t0) +
           corner_angle(s0, t0);
}

/* The point of direction e, turned as the body is; side 0: an interior point. */
static void add_point(Layout *out, const Scene *scene, double R, const double e[3], double volume,
                      int side)
{
    Vec X, normal;
    for (int a = 0; a < DIM; a++) {
        double own = 0;
        for (int k = 0; k < DIM; k++) own += scene->turn[a * DIM + k] * e[k];
        X[a] = scene->body.centre[a] + R * own;
        normal[a] = side * own;
    }
    layout_add(out, X, volume, side ? normal : NULL);
}

void sphere_add(Layout *out, const Scene *scene, double R, double dr, double spacing, int side)
{
    const double apart = dr > 0 ? spacing : layout_surface_spacing(out, spacing);
    const int n = (int)ceil(sqrt(M_PI / 6) * R / apart - 1e-9), octants = scene->octant ? 1 : 8;
    const double third = dr * (R * R + dr * dr / 12); /* integral of r^2 over the layer */
    for (int k = 0; k < octants * 3 * n * n && !out->lost; k++) {
        const int i = k % n, j = k / n % n, face = k / n / n % 3, octant = k / n / n / 3;
        double e[3];
        direction(face, (i + 0.5) / n, (j + 0.5) / n, e);
        for (int a = 0; a < 3; a++) e[a] *= octant >> a & 1 ? -1 : 1;
        add_point(out, scene, R, e, cell_angle(i, j, n) * third, side);
    }
}

void sphere_fill(Layout *out, const Scene *scene, double inner, double outer, double spacing)
{
    const int layers = (int)ceil((outer - inner) / spacing - 1e-9);
    const double dr = (outer - inner) / layers;
    for (int k = 0; k < layers && !out->lost; k++)
        sphere_add(out, scene, inner + (k + 0.5) * dr, dr, spacing, 0);
}
