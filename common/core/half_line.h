/* half_line.h: the first half of a line holds mass and momentum, or a node's v: all that a round of
 * a velocity filter moves, with weights S alone; as scheme.h does it with whole lines. */
#ifndef MPMLAB_HALF_LINE_H
#define MPMLAB_HALF_LINE_H

#include "scheme.h"

typedef double Half __attribute__((vector_size(LANES / 2 * sizeof(double)), may_alias));

static inline __attribute__((always_inline)) void deposit_half(Grid *g, const Work *w,
                                                               const int width)
{
    for (int p = 0; p < CHUNK; p++) {
        Line *const first = g->node + first_node(g, w->stencil, p);
        const Half value = *(const Half *)&w->A[p];
        FOR_ROWS(r, width)
        {
            Line *node = first + row_offset(g, width, r);
            const Half row = value * row_share(w->stencil, p, width, r);
            for (int i = 0; i < width; i++)
                *(Half *)&node[i] += row * w->stencil[0].table[T_S][i][p];
        }
    }
}

static inline __attribute__((always_inline)) void gather_half(const Grid *g, Work *w,
                                                              const int width)
{
    for (int p = 0; p < CHUNK; p++) {
        const Line *const first = g->node + first_node(g, w->stencil, p);
        Half sum = {0};
        FOR_ROWS(r, width)
        {
            const Line *node = first + row_offset(g, width, r);
            Half row = {0};
            for (int i = 0; i < width; i++)
                row += *(const Half *)&node[i] * w->stencil[0].table[T_S][i][p];
            sum += row * row_share(w->stencil, p, width, r);
        }
        *(Half *)&w->A[p] = sum;
    }
}

#endif
