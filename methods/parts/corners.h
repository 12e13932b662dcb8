/* corners.h: weights that are sums over the corners of a particle's domain (Sadeghirad, Brannon &
 * Burghardt 2011): with N the tents of the grid, y_c the corners,
 *   S_ip = sum_c w_c N_i(y_c),  grad S_ip = sum_c g_c N_i(y_c).
 * Corner c lies at the side (-1 or +1) of bit d of c along the domain's own axis d. */
#ifndef MPMLAB_CORNERS_H
#define MPMLAB_CORNERS_H

#include <math.h>
#include "common/contract/material.h"
#include "common/contract/method.h"

enum { CORNERS = 1 << DIM };

/* Names of coordinates of corners as a method's own fields. */
#define CORNER_X(c)   #c "_x"
#define CORNER_XY(c)  #c "_x", #c "_y"
#define CORNER_XYZ(c) #c "_x", #c "_y", #c "_z"
#define CORNERS_1(OF) OF(c0), OF(c1)
#define CORNERS_2(OF) CORNERS_1(OF), OF(c2), OF(c3)
#define CORNERS_3(OF) CORNERS_2(OF), OF(c4), OF(c5), OF(c6), OF(c7)
#define CORNER_NAMES  IN_THIS_DIM(CORNERS_1(CORNER_X), CORNERS_2(CORNER_XY), CORNERS_3(CORNER_XYZ))

static inline double corner_side(int c, int d)
{
    return c >> d & 1 ? 1 : -1;
}

/* Nodes within b cells along an axis of a particle that may be half a cell off its node. */
static inline int corner_width(double b)
{
    return 2 * (int)floor(b + 1.5) + 1;
}

/* The nodes of the cell that corner c lies in: y [cells], w and g as above, g per cell. */
static inline void corner_nodes(const Place *grid, int c, const Field y[DIM], const Field w,
                                const Field g[DIM], NodeList *out)
{
    long long first[CHUNK];
    Field f[DIM];
    for (int p = 0; p < CHUNK; p++) first[p] = 0;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < CHUNK; p++) {
            const double cell = floor(y[d][p]);
            f[d][p] = y[d][p] - cell;
            first[p] += (long long)cell * grid->stride[d];
        }
    for (int k = 0; k < CORNERS; k++) {
        const int entry = c * CORNERS + k;
        long long step = 0;
        for (int d = 0; d < DIM; d++) step += (k >> d & 1) * grid->stride[d];
        for (int p = 0; p < CHUNK; p++) {
            double N = 1;
            for (int d = 0; d < DIM; d++) N *= k >> d & 1 ? f[d][p] : 1 - f[d][p];
            out->at[entry][p] = first[p] + step;
            out->N[entry][p] = N;
        }
    }
    for (int p = 0; p < CHUNK; p++) out->S[c][p] = w[p];
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < CHUNK; p++) out->G[d][c][p] = g[d][p];
    out->points = out->part = CORNERS;
}

/* r limited to +-reach. (NaN becomes one of them; the check of positions then finds the fault.) */
static inline double corner_within(double r, double reach)
{
    r = r < reach ? r : reach;
    return r > -reach ? r : -reach;
}

/* How far the corners of x + F r lie from x along any axis [cells]. */
static inline void parallelogram_reach(const Chunk *c, const Place *grid, Field out)
{
    for (int p = 0; p < CHUNK; p++) out[p] = 0;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < CHUNK; p++) {
            double r = 0;
            for (int k = 0; k < DIM; k++) r += fabs(c->F[d * DIM + k][p]);
            out[p] = grid->half * r > out[p] ? grid->half * r : out[p];
        }
}

/* The same for corners kept as the method's own fields c DIM + d [m]. */
static inline void corner_reach(const Chunk *c, const Place *grid, Field out)
{
    for (int p = 0; p < CHUNK; p++) out[p] = 0;
    for (int k = 0; k < CORNERS * DIM; k++)
        for (int p = 0; p < CHUNK; p++) {
            const double r = fabs(own_field(c, k)[p] - c->x[k % DIM][p]) * grid->cells;
            out[p] = r > out[p] ? r : out[p];
        }
}

/* Corners at the start: x + F r. */
static inline void start_corners(const Chunk *c, const Place *grid)
{
    for (int k = 0; k < CORNERS * DIM; k++)
        for (int p = 0; p < CHUNK; p++) {
            double r = 0;
            for (int e = 0; e < DIM; e++) r += corner_side(k / DIM, e) * c->F[k % DIM * DIM + e][p];
            own_field(c, k)[p] = c->x[k % DIM][p] + r * grid->half / grid->cells;
        }
}

/* dN_c/ds of axis d at s (multilinear, s in [-1, 1]). */
static inline double corner_slope(int c, int d, const double s[DIM])
{
    double N = 0.5 * corner_side(c, d);
    for (int e = 0; e < DIM; e++)
        if (e != d) N *= 0.5 * (1 + corner_side(c, e) * s[e]);
    return N;
}

/* Adds the Gauss point s: volume, w V and g V of all corners. */
static inline void add_gauss(double r[CORNERS][DIM], const double s[DIM], double *V,
                             double w[CORNERS], double g[CORNERS][DIM])
{
    Mat F = {0};
    for (int c = 0; c < CORNERS; c++)
        for (int k = 0; k < NMAT; k++) F[k] += r[c][k / DIM] * corner_slope(c, k % DIM, s);
    const double J = determinant(F);
    *V += J;
    for (int c = 0; c < CORNERS; c++) {
        w[c] += J * corner_slope(c, 0, s) * corner_side(c, 0) * (1 + corner_side(c, 0) * s[0]);
        for (int k = 0; k < NMAT; k++)
            g[c][k / DIM] += cofactor(F, k / DIM, k % DIM) * corner_slope(c, k % DIM, s);
    }
}

#endif
