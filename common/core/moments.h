/* moments.h: moments of a chunk's weights about its particles, for affine transfers and least
 * squares. */
#ifndef MPMLAB_MOMENTS_H
#define MPMLAB_MOMENTS_H

#include "scheme.h"

/* R = S r of every axis, for moments. */
static inline void make_moments(Work *w, int width)
{
    for (int d = 0; d < DIM; d++) {
        Stencil *s = &w->stencil[d];
        for (int k = 0; k < width; k++)
            for (int p = 0; p < CHUNK; p++)
                s->table[T_R][k][p] = s->table[T_S][k][p] * (s->base[p] + k - w->x[d][p]);
    }
}

/* D = sum_i S (x_i - x_p)^2 [m^2] along an axis. */
static inline void spread(const Sim *sim, const Work *w, int axis, int width, Field D)
{
    const Stencil *s = &w->stencil[axis];
    for (int p = 0; p < CHUNK; p++) D[p] = 0;
    for (int k = 0; k < width; k++)
        for (int p = 0; p < CHUNK; p++) {
            const double r = (s->base[p] + k - w->x[axis][p]) * sim->dx;
            D[p] += s->table[T_S][k][p] * r * r;
        }
}

/* Moments become slopes: B /= D. */
static inline void divide_by_spread(const Sim *sim, Work *w, int width)
{
    for (int d = 0; d < DIM; d++) {
        Field D;
        spread(sim, w, d, width, D);
        for (int p = 0; p < CHUNK; p++) D[p] = D[p] > 0 ? 1 / D[p] : 0;
        for (int a = 0; a < DIM; a++)
            for (int p = 0; p < CHUNK; p++) w->payload.B[d][a][p] *= D[p];
    }
}

#endif
