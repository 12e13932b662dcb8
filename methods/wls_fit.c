/* wls_fit.c: the planes of one node from its moments and loads (W11 eqs 9, 10), or its mean where
 * they cannot be had (3.5). See wls.h. */
#include "wls.h"

/* Inverse of the moment matrix, by elimination without pivots (it is positive definite or of no
 * use). Returns its determinant; the inverse is good if that is positive. */
static double invert(double M[DIM + 1][DIM + 1])
{
    double det = 1;
    for (int k = 0; k <= DIM; k++) {
        const double pivot = M[k][k], inverse = 1 / pivot;
        det *= pivot;
        if (!(pivot > 0)) return 0;
        M[k][k] = 1;
        for (int j = 0; j <= DIM; j++) M[k][j] *= inverse;
        for (int i = 0; i <= DIM; i++) {
            const double factor = M[i][k];
            if (i == k) continue;
            M[i][k] = 0;
            for (int j = 0; j <= DIM; j++) M[i][j] -= factor * M[k][j];
        }
    }
    return det;
}

bool wls_solve(Line fit[FIT], bool near)
{
    const Line m = fit[FIT_MOMENTS];
    double M[DIM + 1][DIM + 1], least = 1e-10;
    const double total = m[M_ONE];
    for (int d = 0; d <= DIM; d++) least *= total;
    M[0][0] = total;
    for (int d = 0; d < DIM; d++) {
        M[0][1 + d] = M[1 + d][0] = m[M_FIRST + d];
        for (int e = 0; e < DIM; e++) M[1 + d][1 + e] = m[M_SECOND + pair(d, e)];
    }
    const bool whole = near && invert(M) > least;
    const Line load = fit[FIT_VALUE];
    if (!whole) {
        fit[FIT_VALUE] = total > 0 ? load / total : (Line){0};
        for (int d = 0; d < DIM; d++) fit[FIT_SLOPE + d] = (Line){0};
        return false;
    }
    Line c[DIM + 1];
    for (int k = 0; k <= DIM; k++) {
        c[k] = M[k][0] * load;
        for (int d = 0; d < DIM; d++) c[k] += M[k][1 + d] * fit[FIT_SLOPE + d];
    }
    for (int k = 0; k <= DIM; k++) fit[FIT_VALUE + k] = c[k];
    return true;
}
