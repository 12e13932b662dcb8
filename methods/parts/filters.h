/* filters.h: shared by methods with a filter of the grid velocity: sum_l c_l (S+ S)^l v, with S
 * from nodes to particles and S+ back by mass. Hammerquist & Nairn 2017; Nairn & Hammerquist 2021.
 */
#ifndef MPMLAB_FILTERS_H
#define MPMLAB_FILTERS_H

#include "shapes.h"
#include "transfers.h"

/* The filtered velocity stands in the lanes of a. */
static inline void filtered_update(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    if (take & TAKE_V)
        for (int a = 0; a < DIM; a++)
            for (int p = 0; p < CHUNK; p++) c->v[a][p] = sums[DIM + a][p];
    take_position(c, sums, dt, take);
    if (take & TAKE_F) deform(c, sums, dt);
}

/* I - (I - A)^k = sum_{l < k} c_l A^(l+1), c_l = (-1)^l C(k, l+1); returns k - 1. */
static inline int binomial_filter(int k, double c[])
{
    c[0] = k;
    for (int l = 1; l < k; l++) c[l] = -c[l - 1] * (k - l) / (l + 1);
    return k - 1;
}

/* Parameters of such methods, and the coefficients of the filter of the chosen order. */
enum { FILTER_SHAPE, FILTER_ORDER };

static const Param filter_params[] = {
    [FILTER_SHAPE] = SHAPE_PARAM(BY_GIMP),
    [FILTER_ORDER] = {"order", 1, 0, 7, "", "of the filter; each takes one more projection", "",
                      "1|2|3|4|5|6|7|8"},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static inline int filter_of_order(const double par[], double c[])
{
    return binomial_filter(1 + (int)par[FILTER_ORDER], c);
}

#endif
