/* layout.c: see layout.h. */
#include <math.h>
#include <stdlib.h>
#include "layout.h"
#include "problem.h"

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

void layout_fill_arcs(Layout *out, const Scene *scene, double inner, double outer, double spacing)
{
    const int rings = (int)ceil((outer - inner) / spacing - 1e-9);
    const double dr = (outer - inner) / rings;
    for (int k = 0; k < rings; k++)
        layout_add_arc(out, scene, inner + (k + 0.5) * dr, dr, spacing, 0);
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

/* Points from + (first + k + 1/2) step, k = 0 .. n - 1, along one axis. */
typedef struct Comb {
    double from, first, step;
    long n;
} Comb;

/* The lattice of spacing s from the origin, a point more than the body needs at both ends. */
static Comb comb_over(double lo, double hi, double s)
{
    const double first = floor(lo / s - 1);
    return (Comb){0, first, s, lround(ceil(hi / s + 1) - first)};
}

/* The lattice that fills [lo, hi], where n particles represent lengths (hi - lo)/n. It is that from
 * the origin if its boxes end where the body does. Else (an odd number of cells, or a spacing that
 * is no part of the length) it starts at lo instead, n = (hi - lo)/s rounded up: boxes of equal
 * size tile the body, a mirror image of itself. (To keep the lattice where it was and weigh cut
 * boxes by what is left of them would make slivers of any small mass at faces, and let them act
 * through GIMP boxes l0 = h/(2n) that reach beyond the body.) */
static Comb comb_within(double lo, double hi, double s)
{
    const double length = hi - lo, first = lo / s, n = fmax(ceil(length / s - 1e-9), 1);
    const bool tiles = fabs(n * s - length) <= 1e-13 * length && fabs(first - round(first)) <= 1e-9;
    return tiles ? (Comb){0, round(first), s, lround(n)} : (Comb){lo, 0, length / n, lround(n)};
}

static double comb_at(const Comb *c, long k)
{
    return c->from + (c->first + (double)k + 0.5) * c->step;
}

/* Points of a lattice in the body, axis 0 fastest: of a box, the one that fills it; of any other
 * body, those of the lattice from the origin that lie inside. */
static void place_lattice(Layout *out, const Scene *scene, double s)
{
    const Problem *problem = scene->problem;
    Comb comb[DIM];
    long total = 1;
    double volume = 1;
    for (int d = 0; d < DIM; d++) {
        const double lo = scene->body_lo[d], hi = scene->body_hi[d];
        comb[d] = problem->inside ? comb_over(lo, hi, s) : comb_within(lo, hi, s);
        total *= comb[d].n;
        volume *= comb[d].step;
    }
    if (!(fabs(volume / pow(s, DIM) - 1) <= 1e-9)) out->fit = pow(volume, 1.0 / DIM) / s;
    for (long k = 0; k < total && !out->lost; k++) {
        Vec X;
        bool in = true;
        long rest = k;
        for (int d = 0; d < DIM; d++) {
            X[d] = comb_at(&comb[d], rest % comb[d].n);
            rest /= comb[d].n;
            in = in && X[d] > scene->body_lo[d] && X[d] < scene->body_hi[d];
        }
        if (in && (!problem->inside || problem->inside(scene, X))) layout_add(out, X, volume, NULL);
    }
}

double layout_surface_spacing(const Layout *out, double spacing)
{
    return out->dense > 0 ? spacing / out->dense : spacing;
}

double layout_ppc(const Layout *out, double asked, double cell)
{
    long double volume = 0;
    int n = 0;
    for (int k = 0; k < out->n; k++) {
        volume += out->volume[k];
        n += out->volume[k] > 0;
    }
    if (!(volume > 0)) return NAN;
    const double used = n * pow(cell, DIM) / (double)volume;
    return fabs(used - asked) <= 1e-9 * asked ? asked : used;
}

static bool is_mirror(const Scene *scene, int axis, int side)
{
    for (int k = 0; k < scene->nwall; k++) {
        const Wall *w = &scene->wall[k];
        if (w->mirror && w->axis == axis && w->side == side) return true;
    }
    return false;
}

void layout_add_face(Layout *out, const Scene *scene, int axis, int side, double spacing,
                     bool areas)
{
    long n[DIM], total = 1;
    double share = 1;
    Vec normal = {0};
    normal[axis] = side;
    for (int d = 0; d < DIM; d++) {
        const double length = scene->body_hi[d] - scene->body_lo[d];
        n[d] = d == axis ? 1 : lround(fmax(ceil(length / spacing - 1e-9), 1));
        total *= n[d];
        if (d != axis) share *= length / (double)n[d];
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
        layout_add(out, X, areas ? share : 0, normal);
    }
}

static void place_faces(Layout *out, const Scene *scene, double spacing)
{
    for (int d = 0; d < DIM; d++)
        for (int side = -1; side <= 1; side += 2)
            if (!is_mirror(scene, d, side)) layout_add_face(out, scene, d, side, spacing, false);
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
    if (out->why[0]) return fault_set(fault, FAULT_MACHINE, "%s", out->why);
    if (out->lost)
        return fault_set(fault, FAULT_MACHINE, "out of memory placing more than %d particles",
                         out->n);
    return 0;
}
