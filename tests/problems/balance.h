/* balance.h: a scene's exact motion against finite differences: deformation gradient, first
 * Piola-Kirchhoff stress of the neo-Hookean law, and the body force that balances its momentum. */
#ifndef MPMLAB_BALANCE_H
#define MPMLAB_BALANCE_H

#include <stdlib.h>
#include "common/contract/problem.h"
#include "tests/check.h"

/* Central differences of eighth order: first derivative at offsets k e, k = 1 .. 4; second
 * derivative at the same and, [0], in the middle. */
static const double first_weight[4] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
static const double second_weight[5] = {-205.0 / 72, 8.0 / 5, -1.0 / 5, 8.0 / 315, -1.0 / 560};
static const double balance_step = 0.004; /* [m]; in time a hundredth of the scene's duration */

static inline void displacement(const Scene *s, const Vec X, double t, Vec u)
{
    const double *at[DIM];
    double *out[DIM];
    for (int d = 0; d < DIM; d++) at[d] = &X[d], out[d] = &u[d];
    s->problem->exact(s, 1, at, t, out);
}

static inline void body_force(const Scene *s, const Vec X, double t, Vec b)
{
    const double *at[DIM];
    double *out[DIM];
    for (int d = 0; d < DIM; d++) at[d] = &X[d], out[d] = &b[d];
    s->problem->body(s, 1, at, t, out);
}

/* F_ab = delta_ab + du_a/dX_b */
static inline void exact_gradient(const Scene *s, const Vec X, double t, Mat F)
{
    const double e = balance_step;
    for (int b = 0; b < DIM; b++) {
        for (int a = 0; a < DIM; a++) F[a * DIM + b] = a == b;
        for (int k = 1; k <= 4; k++)
            for (int side = -1; side <= 1; side += 2) {
                Vec at, u;
                for (int d = 0; d < DIM; d++) at[d] = X[d];
                at[b] += side * k * e;
                displacement(s, at, t, u);
                for (int a = 0; a < DIM; a++)
                    F[a * DIM + b] += side * first_weight[k - 1] * u[a] / e;
            }
    }
}

/* P = mu (F - F^-T) + lambda ln J F^-T [Pa] */
static inline void first_stress(const Scene *s, const Vec X, double t, Mat P)
{
    Mat F;
    exact_gradient(s, X, t, F);
    const double J = determinant(F), ln_J = log(J);
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) {
            const double inverse = cofactor(F, a, b) / J;
            P[a * DIM + b] =
                s->mat.mu * (F[a * DIM + b] - inverse) + s->mat.lambda * ln_J * inverse;
        }
}

/* b_a = u_a,tt - P_ab,b / rho [m/s^2] */
static inline void balance(const Scene *s, const Vec X, double t, Vec b)
{
    const double e = balance_step, dt = 0.01 * s->t_end;
    for (int a = 0; a < DIM; a++) b[a] = 0;
    for (int k = -4; k <= 4; k++) {
        Vec u;
        displacement(s, X, t + k * dt, u);
        for (int a = 0; a < DIM; a++) b[a] += second_weight[abs(k)] * u[a] / (dt * dt);
    }
    for (int axis = 0; axis < DIM; axis++)
        for (int k = 1; k <= 4; k++)
            for (int side = -1; side <= 1; side += 2) {
                Vec at;
                Mat P;
                for (int d = 0; d < DIM; d++) at[d] = X[d];
                at[axis] += side * k * e;
                first_stress(s, at, t, P);
                for (int a = 0; a < DIM; a++)
                    b[a] -= side * first_weight[k - 1] * P[a * DIM + axis] / e / s->mat.rho;
            }
}

/* Initial v [m/s] and L [1/s] of the scene, with its u and F; and by differences, from the exact
 * motion just after the start, grad v with respect to X. */
static inline void start_velocity(const Scene *s, const Vec X, Vec v, Mat L, Vec u, Mat F)
{
    const double *at[DIM];
    double *pu[DIM], *pv[DIM], *pF[NMAT], *pL[NMAT];
    for (int d = 0; d < DIM; d++) at[d] = &X[d], pu[d] = &u[d], pv[d] = &v[d], u[d] = v[d] = 0;
    for (int k = 0; k < NMAT; k++)
        pF[k] = &F[k], pL[k] = &L[k], L[k] = 0, F[k] = k % (DIM + 1) == 0;
    s->problem->start(s, 1, at, pu, pv, pF, pL);
}

static inline void exact_velocity(const Scene *s, const Vec X, Vec v, Mat L)
{
    const double dt = 0.01 * s->t_end;
    for (int d = 0; d < DIM; d++) v[d] = 0;
    for (int k = 0; k < NMAT; k++) L[k] = 0;
    for (int k = 1; k <= 4; k++)
        for (int side = -1; side <= 1; side += 2) {
            const double w = side * first_weight[k - 1] / dt;
            Vec u;
            Mat F;
            displacement(s, X, side * k * dt, u);
            exact_gradient(s, X, side * k * dt, F);
            for (int d = 0; d < DIM; d++) v[d] += w * u[d];
            for (int j = 0; j < NMAT; j++) L[j] += w * F[j];
        }
}

#endif
