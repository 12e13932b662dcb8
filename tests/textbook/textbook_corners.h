/* textbook_corners.h: CPDI and CPDI2 of the textbook code: weights from the tents at a domain's
 * corners. Sadeghirad, Brannon & Burghardt 2011; Sadeghirad, Brannon & Guilkey 2013. */
#ifndef MPMLAB_TEXTBOOK_CORNERS_H
#define MPMLAB_TEXTBOOK_CORNERS_H

#include <math.h>
#include <string.h>
#include "textbook.h"

enum { TWIN_CORNERS = 1 << DIM };

/* Corner positions in cells, their shares of S and of grad S [1/m]. */
typedef struct Corners {
    double y[TWIN_CORNERS][DIM], w[TWIN_CORNERS], g[TWIN_CORNERS][DIM];
} Corners;

static inline double side_of(int c, int d)
{
    return c & 1 << d ? 1 : -1;
}

/* Solves M^T a = b by Cramer's rule; returns det M. */
static inline double solve_transposed(double M[DIM][DIM], const double b[DIM], double a[DIM])
{
    double (*det)(const double[DIM][DIM]) = twin_det;
    const double all = det((const double(*)[DIM])M);
    for (int d = 0; d < DIM; d++) {
        double N[DIM][DIM];
        memcpy(N, M, sizeof N);
        for (int k = 0; k < DIM; k++) N[d][k] = b[k];
        a[d] = det((const double(*)[DIM])N) / all;
    }
    return all;
}

/* Multilinear function of corner c at s and its slopes. */
static inline double function_of(int c, const double s[DIM], double slope[DIM])
{
    double N = 1;
    for (int d = 0; d < DIM; d++) slope[d] = 1;
    for (int d = 0; d < DIM; d++) {
        N *= 0.5 * (1 + side_of(c, d) * s[d]);
        for (int e = 0; e < DIM; e++)
            slope[e] *= 0.5 * (e == d ? side_of(c, d) : 1 + side_of(c, d) * s[d]);
    }
    return N;
}

/* Means over any domain of the corners y: the integrals by three Gauss points per axis. */
static inline void integrate(Corners *q, double cells)
{
    static const double at[3] = {-0.77459666924148337704, 0, 0.77459666924148337704};
    static const double weight[3] = {5, 8, 5};
    double V = 0;
    for (int k = 0; k < (DIM == 1 ? 3 : DIM == 2 ? 9 : 27); k++) {
        double s[DIM], share = 1, F[DIM][DIM] = {{0}}, slope[DIM], grad[DIM];
        for (int d = 0, rest = k; d < DIM; d++, rest /= 3)
            s[d] = at[rest % 3], share *= weight[rest % 3];
        for (int c = 0; c < TWIN_CORNERS; c++) {
            function_of(c, s, slope);
            for (int a = 0; a < DIM; a++)
                for (int b = 0; b < DIM; b++) F[a][b] += q->y[c][a] * slope[b];
        }
        for (int c = 0; c < TWIN_CORNERS; c++) {
            const double N = function_of(c, s, slope), J = solve_transposed(F, slope, grad);
            if (c == 0) V += share * J;
            q->w[c] += share * J * N;
            for (int d = 0; d < DIM; d++) q->g[c][d] += share * J * grad[d];
        }
    }
    for (int c = 0; c < TWIN_CORNERS; c++) {
        q->w[c] /= V;
        for (int d = 0; d < DIM; d++) q->g[c][d] *= cells / V;
    }
}

/* The parallelogram about x with half vectors F r0 (l0 along each axis). */
static inline void place_corners(const double x[DIM], const double F[DIM][DIM], double l0,
                                 double corner[TWIN_CORNERS][DIM])
{
    for (int c = 0; c < TWIN_CORNERS; c++)
        for (int a = 0; a < DIM; a++) {
            corner[c][a] = x[a];
            for (int b = 0; b < DIM; b++) corner[c][a] += F[a][b] * side_of(c, b) * l0;
        }
}

static inline double corner_tent(const double y[DIM], const double node[DIM])
{
    double N = 1;
    for (int d = 0; d < DIM; d++) N *= fmax(1 - fabs(y[d] - node[d]), 0);
    return N;
}

#endif
