/* transfers.h: deposits (particles to nodes) and updates (nodes to particles) that methods share.
 * W07 eqs 2.1, 4.1-4.3; W11 eqs 26-30. */
#ifndef MPMLAB_TRANSFERS_H
#define MPMLAB_TRANSFERS_H

#include "common/contract/method.h"

/* Mass, momentum m v and momentum flux -V0 J sigma; the spare lanes carry mass once more, which the
 * momentum ledger reads where symmetry folds the grid. */
static inline void mass_payload(const Chunk *c, const Field T[NMAT], Payload *out)
{
    for (int p = 0; p < CHUNK; p++) out->A[0][p] = c->m[p];
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < CHUNK; p++) out->A[1 + a][p] = c->m[p] * c->v[a][p];
    for (int s = 1 + DIM; s < FLUX; s++)
        for (int p = 0; p < CHUNK; p++) out->A[s][p] = c->m[p];
    for (int b = 0; b < DIM; b++)
        for (int a = 0; a < DIM; a++)
            for (int p = 0; p < CHUNK; p++) out->A[FLUX + b * DIM + a][p] = -T[a * DIM + b][p];
}

/* W07 eq 4.2: every particle deposits the velocity v_p + L_p (x_i - x_p) at node i; the mass is
 * that of mass_payload. */
static inline void gradient_payload(const Chunk *c, const Field T[NMAT], Payload *out)
{
    mass_payload(c, T, out);
    for (int d = 0; d < DIM; d++)
        for (int a = 0; a < DIM; a++)
            for (int p = 0; p < CHUNK; p++) out->B[d][a][p] = c->m[p] * c->L[a * DIM + d][p];
}

/* Positions: x += dt v_grid, at once or in two halves around a re-projection. */
static inline void take_position(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    for (int a = 0; a < DIM; a++) {
        if (take & TAKE_X)
            for (int p = 0; p < CHUNK; p++) c->x[a][p] += dt * sums[a][p];
        if (take & STASH_X)
            for (int p = 0; p < CHUNK; p++) c->u[a][p] = dt * sums[a][p];
        if (take & MOVE_STASH)
            for (int p = 0; p < CHUNK; p++) c->x[a][p] += c->u[a][p];
    }
}

/* L_ab = dv_a/dx_b, for the next step's deposit. */
static inline void keep_gradient(const Chunk *c, const Field sums[])
{
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++)
            for (int p = 0; p < CHUNK; p++) c->L[a * DIM + b][p] = sums[FLUX + b * DIM + a][p];
}

/* Column k of F += dt L F in 3D. The increments go to an array of their own first, so that the
 * compiler knows that writing one row of the column changes no row still to be read. */
static inline void deform_column(const Chunk *c, const Field sums[], double dt, int k)
{
    Field more[DIM];
    const double *column[DIM];
    for (int b = 0; b < DIM; b++) column[b] = c->F[b * DIM + k];
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < CHUNK; p++) {
            double sum = 0;
            for (int b = 0; b < DIM; b++) sum += sums[FLUX + b * DIM + a][p] * column[b][p];
            more[a][p] = dt * sum;
        }
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < CHUNK; p++) c->F[a * DIM + k][p] += more[a][p];
}

/* F += dt L F */
static inline void deform(const Chunk *c, const Field sums[], double dt)
{
    for (int k = 0; DIM == 3 && k < DIM; k++) deform_column(c, sums, dt, k);
    for (int p = 0; DIM < 3 && p < CHUNK; p++) {
        double F[NMAT];
        for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p];
        for (int a = 0; a < DIM; a++)
            for (int k = 0; k < DIM; k++) {
                double f = F[a * DIM + k];
                for (int b = 0; b < DIM; b++)
                    f += dt * sums[FLUX + b * DIM + a][p] * F[b * DIM + k];
                c->F[a * DIM + k][p] = f;
            }
    }
}

/* FLIP: v += dt a, W11 eqs 27-30. */
static inline void flip_update(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    if (take & TAKE_V)
        for (int a = 0; a < DIM; a++)
            for (int p = 0; p < CHUNK; p++) c->v[a][p] += dt * sums[DIM + a][p];
    take_position(c, sums, dt, take);
    if ((take & (TAKE_F | TAKE_L)) && c->L[0]) keep_gradient(c, sums);
    if (take & TAKE_F) deform(c, sums, dt);
}

/* PIC: v = S v_grid. A gradient that is kept belongs to the same velocity, so that it is never
 * stale, however often particles are projected. */
static inline void pic_update(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    if (take & TAKE_V)
        for (int a = 0; a < DIM; a++)
            for (int p = 0; p < CHUNK; p++) c->v[a][p] = sums[a][p];
    if (take & TAKE_V && c->L[0]) keep_gradient(c, sums);
    take_position(c, sums, dt, take);
    if (take & TAKE_F) deform(c, sums, dt);
}

#endif
