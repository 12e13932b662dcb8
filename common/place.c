/* place.c: see place.h. */
#include <math.h>
#include <stdlib.h>
#include "place.h"

static bool grow(double **array, int room)
{
    double *more = realloc(*array, sizeof(double) * (size_t)room);
    if (more) *array = more;
    return more != NULL;
}

static bool make_room(Layout *out)
{
    if (out->n < out->room) return true;
    const int room = out->room ? 2 * out->room : 1024;
    bool ok = grow(&out->volume, room);
    for (int d = 0; d < DIM; d++) ok = ok && grow(&out->X[d], room) && grow(&out->normal[d], room);
    if (ok) out->room = room;
    return ok;
}

void layout_add(Layout *out, const Vec X, double volume, const double *normal)
{
    if (!make_room(out)) {
        out->lost++;
        return;
    }
    for (int d = 0; d < DIM; d++) {
        out->X[d][out->n] = X[d];
        out->normal[d][out->n] = normal ? normal[d] : 0;
    }
    out->volume[out->n++] = volume;
}

void layout_free(Layout *out)
{
    free(out->volume);
    for (int d = 0; d < DIM; d++) free(out->X[d]), free(out->normal[d]);
    *out = (Layout){0};
}

void layout_add_arc(Layout *out, const Scene *scene, double R, double dr, double spacing, int side)
{
    const Body *b = &scene->body;
    const double angle = b->angle_hi - b->angle_lo;
    const double apart = dr > 0 ? spacing : layout_surface_spacing(out, spacing);
    const int n = (int)ceil(angle * R / apart - 1e-9);
    for (int q = 0; q < n; q++) {
        const double at = b->angle_lo + (q + 0.5) * angle / n;
        Vec X = {0}, normal = {0};
        for (int d = 0; d < 2 && d < DIM; d++) {
            const double e = d == 0 ? cos(at) : sin(at);
            X[d] = b->centre[d] + R * e;
            normal[d] = side * e;
        }
        layout_add(out, X, R * angle / n * dr, normal);
    }
}

/* W07 fig 4: `count` particles of equal size fill the body from end to end. */
static void place_evenly(Layout *out, const Scene *scene, int count)
{
    const double length = scene->body_hi[0] - scene->body_lo[0];
    for (int k = 0; k < count; k++) {
        Vec X = {scene->body_lo[0] + (k + 0.5) / count * length};
        layout_add(out, X, length / count, NULL);
    }
}

/* Lattice points (i + 1/2) s whose centres lie in the body, axis 0 fastest. */
static void place_lattice(Layout *out, const Scene *scene, double s)
{
    long lo[DIM], n[DIM], total = 1;
    double volume = 1;
    for (int d = 0; d < DIM; d++) {
        lo[d] = lround(floor(scene->body_lo[d] / s - 1));
        n[d] = lround(ceil(scene->body_hi[d] / s + 1)) - lo[d];
        total *= n[d];
        volume *= s;
    }
    for (long k = 0; k < total && !out->lost; k++) {
        Vec X;
        bool in = true;
        long rest = k;
        for (int d = 0; d < DIM; d++) {
            X[d] = ((double)(lo[d] + rest % n[d]) + 0.5) * s;
            rest /= n[d];
            in = in && X[d] > scene->body_lo[d] && X[d] < scene->body_hi[d];
        }
        if (in && (!scene->problem->inside || scene->problem->inside(scene, X)))
            layout_add(out, X, volume, NULL);
    }
}

double layout_surface_spacing(const Layout *out, double spacing)
{
    return out->dense > 0 ? spacing / out->dense : spacing;
}

static bool is_mirror(const Scene *scene, int axis, int side)
{
    for (int k = 0; k < scene->nwall; k++) {
        const Wall *w = &scene->wall[k];
        if (w->mirror && w->axis == axis && w->side == side) return true;
    }
    return false;
}

/* Points at mid spacing on the face of a box across `axis`. */
static void place_face(Layout *out, const Scene *scene, int axis, int side, double spacing)
{
    long n[DIM], total = 1;
    Vec normal = {0};
    normal[axis] = side;
    for (int d = 0; d < DIM; d++) {
        const double length = scene->body_hi[d] - scene->body_lo[d];
        n[d] = d == axis ? 1 : lround(fmax(ceil(length / spacing - 1e-9), 1));
        total *= n[d];
    }
    for (long k = 0; k < total && !out->lost; k++) {
        Vec X;
        long rest = k;
        for (int d = 0; d < DIM; d++) {
            const double f = ((double)(rest % n[d]) + 0.5) / (double)n[d];
            X[d] = scene->body_lo[d] + f * (scene->body_hi[d] - scene->body_lo[d]);
            rest /= n[d];
        }
        X[axis] = side < 0 ? scene->body_lo[axis] : scene->body_hi[axis];
        layout_add(out, X, 0, normal);
    }
}

static void place_faces(Layout *out, const Scene *scene, double spacing)
{
    for (int d = 0; d < DIM; d++)
        for (int side = -1; side <= 1; side += 2)
            if (!is_mirror(scene, d, side)) place_face(out, scene, d, side, spacing);
}

int layout_make(Layout *out, const Scene *scene, double spacing, int count, bool fitted,
                Fault *fault)
{
    const Problem *problem = scene->problem;
    const bool box = scene->body.kind == BODY_BOX && !problem->inside;
    const bool placed = problem->place && problem->place(scene, spacing, fitted, out);
    if (placed)
        ;
    else if (fitted && !box)
        return fault_set(fault, FAULT_USAGE, "layout=radial: %s has no body-fitted layout",
                         problem->info.name);
    else if (count > 0)
        place_evenly(out, scene, count);
    else
        place_lattice(out, scene, spacing);
    if (fitted && !placed) place_faces(out, scene, layout_surface_spacing(out, spacing));
    if (out->lost)
        return fault_set(fault, FAULT_MACHINE, "out of memory placing more than %d particles",
                         out->n);
    return 0;
}
