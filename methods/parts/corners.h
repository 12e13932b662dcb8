/* corners.h: weights that are sums over the corners of a particle's domain (Sadeghirad, Brannon &
 * Burghardt 2011): with N the tents of the grid, y_c the corners,
 *   S_ip = sum_c w_c N_i(y_c),  grad S_ip = sum_c g_c N_i(y_c).
 * Corner c lies at the side (-1 or +1) of bit d of c along the domain's own axis d. */
#ifndef MPMLAB_CORNERS_H
#define MPMLAB_CORNERS_H

#include <math.h>
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

/* r within the reach of the grid. (NaN becomes its end, and the check of positions finds it.) */
static inline double corner_within(double r, double reach)
{
    r = r < reach ? r : reach;
    return r > -reach ? r : -reach;
}

#endif
