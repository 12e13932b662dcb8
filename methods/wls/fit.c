/* fit.c: the planes of one node from its moments and loads (W11 eqs 9, 10), or its mean where
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

/* The moment matrix, `more` times M00 added to its slopes; inverted in place. */
static bool invert_moments(const Line fit[FIT], double more, double least,
                           double M[DIM + 1][DIM + 1])
{
    const Line m = fit[FIT_MOMENTS];
    const double total = m[M_ONE];
    for (int d = 0; d <= DIM; d++) least *= total;
    M[0][0] = total;
    for (int d = 0; d < DIM; d++) {
        M[0][1 + d] = M[1 + d][0] = R_RIDES ? fit[FIT_VALUE][Q_R + d] : m[M_FIRST + d];
        for (int e = 0; e < DIM; e++)
            M[1 + d][1 + e] = R_RIDES ? fit[FIT_SLOPE + (d < e ? d : e)][Q_R + (d < e ? e : d)]
                                      : m[M_SECOND + pair(d, e)];
        M[1 + d][1 + d] += more * total;
    }
    return invert(M) > least;
}

/* The means of all quantities in place of planes: slopes 0, of v too. */
static void fall_back(Line fit[FIT], double total)
{
    fit[FIT_VALUE] = total > 0 ? fit[FIT_VALUE] / total : (Line){0};
    for (int d = 0; d < DIM; d++) fit[FIT_SLOPE + d] = (Line){0};
}

bool wls_solve(Line fit[FIT], bool near, double hermite, double least)
{
    double M[DIM + 1][DIM + 1], V[DIM + 1][DIM + 1];
    const double total = fit[FIT_MOMENTS][M_ONE];
    const bool whole = near && invert_moments(fit, 0, least, M);
    if (!whole) {
        fall_back(fit, total);
        return false;
    }
    if (hermite > 0) invert_moments(fit, hermite, least, V);
    Line c[DIM + 1];
    for (int k = 0; k <= DIM; k++) {
        c[k] = (Line){0};
        for (int j = 0; j <= DIM; j++) {
            Line entry = M[k][j] + (Line){0};
            for (int a = 0; a < DIM && hermite > 0; a++) entry[Q_V + a] = V[k][j];
            c[k] += entry * fit[FIT_VALUE + j];
        }
    }
    for (int k = 0; k <= DIM; k++) fit[FIT_VALUE + k] = c[k];
    return true;
}
