/* stretch.h: how far a particle is stretched along an axis: what its half width l = l0 stretch
 * follows (DOMAIN_*, method.h).
 *
 * |F_dd| is W11's authors' rule; it vanishes under a quarter turn. U_dd does not: F = R U, U = sqrt
 * C, C = F^T F, in the plane U = (C + det U I)/sqrt(tr C + 2 det U) (Hoger & Carlson 1984). In
 * space R comes from Newton's iteration R <- (R + R^-T)/2 (Higham 1986), U_dd = sum_a R_ad F_ad. */
#ifndef MPMLAB_STRETCH_H
#define MPMLAB_STRETCH_H

#include <math.h>
#include "common/contract/material.h"
#include "common/contract/method.h"

/* A particle's stretch is never taken as zero. */
static const double LEAST_STRETCH = 1e-6;

/* U_dd of F = R U [-]; NaN for F = 0. */
static inline double stretch_along(const Mat F, int d)
{
    enum { ROUNDS = 16 }; /* from stretches of .01 to 100 to round-off */
    Mat R, old;
    double own = 0, trace = 0;
    if (DIM == 1) return fabs(F[0]);
    for (int k = 0; k < NMAT; k++) trace += F[k] * F[k];
    if (DIM == 2) {
        const double J = fabs(determinant(F));
        for (int a = 0; a < DIM; a++) own += F[a * DIM + d] * F[a * DIM + d];
        return (own + J) / sqrt(trace + 2 * J);
    }
    for (int k = 0; k < NMAT; k++) R[k] = F[k];
    for (int round = 0; round < ROUNDS; round++) {
        for (int k = 0; k < NMAT; k++) old[k] = R[k];
        const double J = determinant(old);
        for (int k = 0; k < NMAT; k++) R[k] = 0.5 * (old[k] + cofactor(old, k / DIM, k % DIM) / J);
    }
    for (int a = 0; a < DIM; a++) own += R[a * DIM + d] * F[a * DIM + d];
    return own;
}

/* The stretch along axis d of particle p, whose F [NMAT][p] is given per component. */
static inline __attribute__((always_inline)) double
domain_stretch(const Domain domain, double *const F[NMAT], int d, int p)
{
    Mat f;
    if (domain == DOMAIN_FXX) return fabs(F[d * (DIM + 1)][p]);
    if (domain == DOMAIN_UNDEFORMED) return 1;
    for (int k = 0; k < NMAT; k++) f[k] = F[k][p];
    return stretch_along(f, d);
}

#endif
