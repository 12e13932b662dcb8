/* kernel.h: what a chunk of particles deposits: weights per axis, quantities (moments.c, space.h).
 */
#ifndef MPMLAB_WLS_KERNEL_H
#define MPMLAB_WLS_KERNEL_H

#include "common/core/scheme.h"
#include "wls.h"

/* Tables of one axis: W, W r, W r^2, tent; for the nodes base, base + 1, base + 2. */
enum { W_ONE, W_R, W_RR, W_TENT, KERNELS };

typedef struct Kernel {
    int base[CHUNK];
    Field off; /* of the particle from the middle node */
    Field table[KERNELS][3];
} Kernel;

typedef struct Deposit {
    Kernel kernel[DIM];
    Field T[NMAT], body[DIM], quantity[LANES];
    Line A[CHUNK];      /* quantities by particle */
    Line B[CHUNK][DIM]; /* loads of the slopes besides W r f: W g^2 h L for v */
    Line x[CHUNK][3];   /* weights of the moments on axis 0; not in 3D */
} Deposit;

/* The first node that particle p reaches. */
static inline size_t first_of(const Grid *g, const Kernel k[DIM], int p)
{
    size_t row = 0;
    for (int d = DIM - 1; d > 0; d--) row = row * (size_t)g->n[d] + (size_t)k[d].base[p];
    return row * (size_t)g->n[0] + (size_t)k[0].base[p];
}

/* Does particle p + 1 reach the same nodes as p? */
static inline bool same_nodes(const Kernel k[DIM], int p)
{
    bool same = true;
    for (int d = 0; d < DIM; d++) same &= k[d].base[p + 1] == k[d].base[p];
    return same;
}

#endif
