/* circles.h: body-fitted points of a quarter ring or a full one, in 2D and, in layers along the
 * last axis, in 3D: for scenes whose body is BODY_RING. */
#ifndef MPMLAB_CIRCLES_H
#define MPMLAB_CIRCLES_H

#include <math.h>
#include "common/contract/layout.h"
#include "common/contract/problem.h"

/* Points at mid angles on the circle of radius R, spacing s or less; dr = 0: on the surface. In 3D
 * of each of the `layers` along the axis. */
static inline void circles_add(const Scene *scene, double R, double dr, double spacing, int layers,
                               Layout *out)
{
    const Body *b = &scene->body;
    const int quarters = b->angle_hi - b->angle_lo > M_PI ? 4 : 1;
    const int n = quarters * (int)ceil(M_PI / 2 * R / spacing - 1e-9);
    const double arc = quarters * M_PI / 2 / n;
    const double outwards = R < 0.5 * (b->inner + b->outer) ? -1 : 1;
    const double thickness = DIM > 2 ? scene->body_hi[AXIS_LAST] / layers : 1;
    for (int q = 0; q < n * layers; q++) {
        const double angle = b->angle_lo + (q % n + 0.5) * arc;
        const Vec e = {cos(angle), sin(angle)};
        Vec X = {0}, normal = {0};
        for (int d = 0; d < 2; d++) {
            X[d] = b->centre[d] + R * e[d];
            normal[d] = outwards * e[d];
        }
        if (DIM > 2) X[AXIS_LAST] = (q / n + 0.5) * thickness;
        layout_add(out, X, R * arc * dr * thickness, dr > 0 ? NULL : normal);
    }
}

static inline int circles_layers(const Scene *s, double spacing)
{
    return DIM > 2 ? (int)ceil(s->body_hi[AXIS_LAST] / spacing - 1e-9) : 1;
}

/* Rings at mid radii, and surface particles on both circles. */
static inline bool circles_place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    if (!fitted) return false;
    const double inner = s->body.inner, outer = s->body.outer;
    const int rings = (int)ceil((outer - inner) / spacing - 1e-9);
    const int layers = circles_layers(s, spacing);
    const double dr = (outer - inner) / rings;
    const double apart = layout_surface_spacing(out, spacing);
    for (int k = 0; k < rings; k++)
        circles_add(s, inner + (k + 0.5) * dr, dr, spacing, layers, out);
    circles_add(s, inner, 0, apart, layers, out);
    circles_add(s, outer, 0, apart, layers, out);
    return true;
}

/* Both circles, equal shares of their areas. */
static inline void circles_surface(const Scene *s, double spacing, Layout *out)
{
    const double height = DIM > 2 ? s->body_hi[AXIS_LAST] : 1;
    for (int side = 0; side < 2; side++) {
        const double R = side ? s->body.outer : s->body.inner;
        const double area = R * (s->body.angle_hi - s->body.angle_lo) * height;
        const int first = out->n;
        circles_add(s, R, 0, spacing, circles_layers(s, spacing), out);
        for (int p = first; p < out->n; p++) out->volume[p] = area / (out->n - first);
    }
}

#endif
