/* parts.h: deposit and gather of scheme.h where a line is wider than the machine's vectors: in
 * parts of their width, one after the other, so that a part's weights stay in registers. For
 * stencils of 2 or 3 nodes per axis in 2D and 3D; all others use scheme.h's loops. */
#ifndef MPMLAB_PARTS_H
#define MPMLAB_PARTS_H

#include "scheme.h"

/* Weights of part q of a line for one node on one axis: as axis_weight. */
static inline __attribute__((always_inline)) Part part_weight(const Stencil s[DIM], int d, int k,
                                                              int p, const int table, const int q)
{
    return weight_part(s[d].table[T_S][k][p], s[d].table[table][k][p], d, q);
}

static inline __attribute__((always_inline)) const Part *part_at(const Line *line, const int q)
{
    return (const Part *)line + q;
}

/* The weights of an axis; `hi` of stencils of 3 nodes only. */
typedef struct Three {
    Part lo, mid, hi;
} Three;

static inline __attribute__((always_inline)) Three
three_weights(const Stencil s[DIM], int d, int p, const int width, const int table, const int q)
{
    Three x = {part_weight(s, d, 0, p, table, q), part_weight(s, d, 1, p, table, q), {0}};
    if (width == 3) x.hi = part_weight(s, d, 2, p, table, q);
    return x;
}

/* Parts from a node to the next along axes 1 and 2. */
typedef struct Strides {
    size_t row, plane;
} Strides;

/* Adds a part to a row of nodes, and to a plane of rows: `value` is that at the first node; with
 * `slopes` it grows by `step` from node to node and by `next` from row to row. */
static inline __attribute__((always_inline)) void
add_row(Part *to, const int width, const Three x, Part value, const Part step, const bool slopes)
{
    to[0] += x.lo * value;
    if (slopes) value += step;
    to[PARTS] += x.mid * value;
    if (width == 2) return;
    if (slopes) value += step;
    to[2 * PARTS] += x.hi * value;
}

static inline __attribute__((always_inline)) void add_plane(Part *to, const int width, size_t row,
                                                            const Three x, const Three y,
                                                            Part value, const Part step,
                                                            const Part next, const bool slopes)
{
    add_row(to, width, x, value * y.lo, step * y.lo, slopes);
    if (slopes) value += next;
    add_row(to + row, width, x, value * y.mid, step * y.mid, slopes);
    if (width == 2) return;
    if (slopes) value += next;
    add_row(to + 2 * row, width, x, value * y.hi, step * y.hi, slopes);
}

/* Part q of particle p's deposit: see deposit. */
static inline __attribute__((always_inline)) void deposit_part(Line *first, const Strides by,
                                                               const Work *w, int p,
                                                               const int width, const bool affine,
                                                               const int q)
{
    const bool slopes = affine && q * PART_LANES <= DIM;
    const Three x = three_weights(w->stencil, 0, p, width, T_G, q);
    const Three y = three_weights(w->stencil, AXIS_Y, p, width, T_G, q);
    const Line *B = &w->B[p];
    Part *to = (Part *)first + q, value = *part_at(&w->A[p], q), s0 = {0}, s1 = {0}, s2 = {0};
    if (slopes) s0 = slope_part(B, 0, q), s1 = slope_part(B, AXIS_Y, q);
    if (DIM < 3) {
        add_plane(to, width, by.row, x, y, value, s0, s1, slopes);
        return;
    }
    const Three z = three_weights(w->stencil, AXIS_LAST, p, width, T_G, q);
    if (slopes) s2 = slope_part(B, AXIS_LAST, q);
    add_plane(to, width, by.row, x, y, value * z.lo, s0 * z.lo, s1 * z.lo, slopes);
    value += s2;
    add_plane(to + by.plane, width, by.row, x, y, value * z.mid, s0 * z.mid, s1 * z.mid, slopes);
    if (width == 2) return;
    value += s2;
    add_plane(to + 2 * by.plane, width, by.row, x, y, value * z.hi, s0 * z.hi, s1 * z.hi, slopes);
}

static inline __attribute__((always_inline)) Part sum_row(const Part *from, const int width,
                                                          const Three x)
{
    Part sum = x.lo * from[0] + x.mid * from[PARTS];
    if (width == 3) sum += x.hi * from[2 * PARTS];
    return sum;
}

static inline __attribute__((always_inline)) Part
sum_plane(const Part *from, const int width, size_t row, const Three x, const Three y)
{
    Part sum = y.lo * sum_row(from, width, x) + y.mid * sum_row(from + row, width, x);
    if (width == 3) sum += y.hi * sum_row(from + 2 * row, width, x);
    return sum;
}

/* Part q of particle p's gather: see gather. */
static inline __attribute__((always_inline)) void gather_part(const Line *first, const Strides by,
                                                              Work *w, int p, const int width,
                                                              const int table, const int q)
{
    const Three x = three_weights(w->stencil, 0, p, width, table, q);
    const Three y = three_weights(w->stencil, AXIS_Y, p, width, table, q);
    const Part *from = part_at(first, q);
    Part *sum = (Part *)&w->A[p] + q;
    if (DIM < 3) {
        *sum = sum_plane(from, width, by.row, x, y);
        return;
    }
    const Three z = three_weights(w->stencil, AXIS_LAST, p, width, table, q);
    Part all = z.lo * sum_plane(from, width, by.row, x, y) +
               z.mid * sum_plane(from + by.plane, width, by.row, x, y);
    if (width == 3) all += z.hi * sum_plane(from + 2 * by.plane, width, by.row, x, y);
    *sum = all;
}

static inline Strides strides_of(const Grid *g)
{
    const size_t row = (size_t)g->n[0] * PARTS;
    return (Strides){row, row * (size_t)g->n[AXIS_Y]};
}

/* Are the lines of stencils of this width taken in parts? */
#define IN_PARTS(width) (DIM > 1 && PARTS > 1 && (width) <= 3)

/* A chunk's deposit, in lines or in their parts. */
static inline __attribute__((always_inline)) void deposit_lines(Grid *g, const Work *w,
                                                                const int width, const bool affine)
{
    const Strides by = strides_of(g);
    if (!IN_PARTS(width)) {
        deposit(g, w, width, affine);
        return;
    }
    for (int p = 0; p < CHUNK; p++) {
        Line *first = g->node + first_node(g, w->stencil, p);
        deposit_part(first, by, w, p, width, affine, 0);
        if (PARTS > 1) deposit_part(first, by, w, p, width, affine, 1 % PARTS);
        if (PARTS > 2) deposit_part(first, by, w, p, width, affine, 2 % PARTS);
        if (PARTS > 2) deposit_part(first, by, w, p, width, affine, 3 % PARTS);
        for (int q = 4; q < PARTS; q++) deposit_part(first, by, w, p, width, affine, q);
    }
}

/* A chunk's gather, in lines or in their parts. */
static inline __attribute__((always_inline)) void gather_lines(const Grid *g, Work *w,
                                                               const int width, const int table)
{
    const Strides by = strides_of(g);
    if (!IN_PARTS(width)) {
        gather(g, w, width, table);
        return;
    }
    for (int p = 0; p < CHUNK; p++) {
        const Line *first = g->node + first_node(g, w->stencil, p);
        gather_part(first, by, w, p, width, table, 0);
        if (PARTS > 1) gather_part(first, by, w, p, width, table, 1 % PARTS);
        if (PARTS > 2) gather_part(first, by, w, p, width, table, 2 % PARTS);
        if (PARTS > 2) gather_part(first, by, w, p, width, table, 3 % PARTS);
        for (int q = 4; q < PARTS; q++) gather_part(first, by, w, p, width, table, q);
    }
}

#endif
