/* raster.c: see raster.h. */
#include "raster.h"
#include <math.h>

enum { BISECTIONS = 40, CORNERS = 1 << DIM };

/* Grey of the sample at an index, which may lie outside the image. */
static double grey_at(const Raster *r, const int index[DIM])
{
    int at[3] = {0};
    for (int d = 0; d < DIM; d++) {
        at[d] = index[d];
        if (at[d] < 0 && r->mirrors >> d & 1) at[d] = -1 - at[d];
        if (at[d] < 0 || at[d] >= r->image->n[d]) return 1;
    }
    return r->image->grey[image_at(r->image, at[0], at[1], at[2])] / (double)GREY_LIGHT;
}

static double sample(const Raster *r, const int index[DIM])
{
    const double grey = grey_at(r, index);
    return r->halfway ? grey >= r->threshold : grey;
}

/* Grey at x [m], from 0 to 1. Samples lie at (i + 1/2) pixel. Between a dark and a light one,
 * halfway is where grey is 1/2. */
static double grey_within(const Raster *r, const Vec x)
{
    int low[DIM];
    double part[DIM], sum = 0;
    for (int d = 0; d < DIM; d++) {
        const double at = x[d] / r->pixel - 0.5;
        low[d] = (int)floor(at);
        part[d] = at - low[d];
    }
    for (int c = 0; c < CORNERS; c++) {
        int index[DIM];
        double weight = 1;
        for (int d = 0; d < DIM; d++) {
            index[d] = low[d] + (c >> d & 1);
            weight *= c >> d & 1 ? part[d] : 1 - part[d];
        }
        if (weight > 0) sum += weight * sample(r, index);
    }
    return sum;
}

bool raster_is_in(const Raster *r, const Vec x)
{
    return grey_within(r, x) < (r->halfway ? 0.5 : r->threshold);
}

/* A lattice over the image, a point more than it needs at both ends. */
typedef struct Comb {
    double spacing;
    long n[DIM], total;
} Comb;

static Comb comb_over(const Raster *r, double spacing)
{
    Comb c = {.spacing = spacing, .total = 1};
    for (int d = 0; d < DIM; d++) {
        c.n[d] = (long)ceil(r->image->n[d] * r->pixel / spacing) + 2;
        c.total *= c.n[d];
    }
    return c;
}

static void comb_at(const Comb *c, long k, Vec x)
{
    for (int d = 0; d < DIM; d++) {
        x[d] = ((double)(k % c->n[d]) - 0.5) * c->spacing;
        k /= c->n[d];
    }
}

static bool is_beyond_mirror(const Raster *r, const Vec x)
{
    for (int d = 0; d < DIM; d++)
        if (r->mirrors >> d & 1 && x[d] < 0) return true;
    return false;
}

void raster_add_particles(const Raster *r, double spacing, Layout *out)
{
    const Comb comb = comb_over(r, spacing);
    for (long k = 0; k < comb.total && !out->lost; k++) {
        Vec x;
        comb_at(&comb, k, x);
        if (!is_beyond_mirror(r, x) && raster_is_in(r, x))
            layout_add(out, x, pow(spacing, DIM), NULL);
    }
}

/* Unit vector from dark to light: the first moment of the samples within `reach` of x, whose
 * weights fall smoothly to 0. */
static bool find_normal(const Raster *r, const Vec x, double reach, Vec normal)
{
    int low[DIM], n = (int)ceil(2 * reach / r->pixel) + 2;
    long total = 1;
    double length = 0;
    for (int d = 0; d < DIM; d++) {
        low[d] = (int)floor((x[d] - reach) / r->pixel - 0.5);
        total *= n;
        normal[d] = 0;
    }
    for (long k = 0; k < total; k++) {
        int index[DIM];
        Vec from;
        double square = 0;
        long rest = k;
        for (int d = 0; d < DIM; d++) {
            index[d] = low[d] + (int)(rest % n);
            rest /= n;
            from[d] = (index[d] + 0.5) * r->pixel - x[d];
            square += from[d] * from[d];
        }
        const double part = 1 - square / (reach * reach);
        if (part <= 0) continue;
        const double weight = part * part * (grey_at(r, index) - r->threshold);
        for (int d = 0; d < DIM; d++) normal[d] += weight * from[d];
    }
    for (int d = 0; d < DIM; d++) length += normal[d] * normal[d];
    for (int d = 0; d < DIM; d++) normal[d] /= sqrt(length);
    return length > 0;
}

/* The place between x and x + step along an axis where the surface is crossed. */
static void find_crossing(const Raster *r, Vec x, int axis, double step)
{
    const bool inside = raster_is_in(r, x);
    const double from = x[axis];
    double low = 0, high = step;
    for (int k = 0; k < BISECTIONS; k++) {
        const double middle = 0.5 * (low + high);
        x[axis] = from + middle;
        if (raster_is_in(r, x) == inside)
            low = middle;
        else
            high = middle;
    }
    x[axis] = from + 0.5 * (low + high);
}

/* Lines a apart along all axes cross a surface 4/pi times per length a, on average over its
 * directions; in 3D 3/2 times per area a^2. */
void raster_add_surface(const Raster *r, double spacing, Layout *out)
{
    const double apart = layout_surface_spacing(out, spacing);
    const Comb comb = comb_over(r, apart * (DIM > 2 ? sqrt(1.5) : 4 / M_PI));
    for (long k = 0; k < comb.total && !out->lost; k++) {
        Vec x, next, normal;
        comb_at(&comb, k, x);
        const bool inside = raster_is_in(r, x);
        for (int d = 0; d < DIM; d++) {
            comb_at(&comb, k, x);
            comb_at(&comb, k, next);
            next[d] += comb.spacing;
            if (is_beyond_mirror(r, x) || is_beyond_mirror(r, next) ||
                raster_is_in(r, next) == inside)
                continue;
            find_crossing(r, x, d, comb.spacing);
            if (find_normal(r, x, fmax(apart, 3 * r->pixel), normal)) layout_add(out, x, 0, normal);
        }
    }
}
