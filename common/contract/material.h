/* material.h: hyperelastic laws: Kirchhoff stress and stored energy from F, and the wave speeds.
 * W11 eqs 31, 32; 1D is the same with nu = 0 (sigma = E/2 (F - 1/F)). */
#ifndef MPMLAB_MATERIAL_H
#define MPMLAB_MATERIAL_H

#include <stdbool.h>
#include "dim.h"

typedef enum { NEO_HOOKEAN, LINEAR } Law;

typedef struct Material {
    Law law;
    double E, nu, rho; /* [Pa] [-] [kg/m^DIM]: Young, Poisson, reference density */
    double lambda, mu; /* [Pa] Lame */
} Material;

/* Lame constants from E, nu. In 1D Poisson's ratio has no meaning and must be 0. */
Material material_make(Law law, double E, double nu, double rho);

double material_wave_speed_bar(const Material *m); /* sqrt(E/rho) */
double material_wave_speed_p(const Material *m);   /* sqrt((lambda + 2 mu)/rho) */
double material_wave_speed_bound(
    const Material *m); /* sqrt((lambda + 3 mu)/rho), W11 eq 33: an upper bound */

/* T = J sigma [Pa] for 64 particles, symmetric, row-major components. F, T: [NMAT][CHUNK]. Where
 * J <= 0 the result is NaN (neo-Hookean) or finite nonsense (linear): the caller checks J. */
void material_kirchhoff(const Material *m, const double *const F[NMAT], Field T[NMAT]);

/* The same times a weight per particle: V0/h makes it the momentum flux of a deposit. */
void material_kirchhoff_weighted(const Material *m, const double *const F[NMAT],
                                 const double weight[CHUNK], Field T[NMAT]);

/* Stored energy per reference volume psi [J/m^DIM] for n particles. */
void material_stored_energy(const Material *m, int n, const double *const F[NMAT], double psi[]);

/* sigma_zz of plane strain [Pa], T_zz/J: lambda ln J/J, or lambda tr(F - I)/J of the linear law; 0
 * in 1D; without meaning in 3D. */
double material_out_of_plane_stress(const Material *m, const Mat F);

/* Largest principal value of a symmetric tensor. */
double material_largest_stress(const Mat T);

/* T and psi of neo-Hookean matter that bears no tension: those of F whose principal stretches above
 * 1 are 1, psi(min(lambda_i, 1)), T = sum_i dpsi/d ln lambda_i n_i n_i <= 0. */
double material_without_tension(const Material *m, const Mat F, Mat T);

static inline double determinant(const Mat F)
{
    double det = 0;
    if (DIM == 1) return F[0];
    if (DIM == 2) return F[0] * F[NMAT - 1] - F[1 % NMAT] * F[DIM % NMAT];
    for (int a = 0; a < DIM; a++) { /* first row times its cofactors, cyclic */
        const int b = (a + 1) % DIM, c = (a + 2) % DIM;
        det += F[a] *
               (F[(DIM + b) % NMAT] * F[NMAT - DIM + c] - F[(DIM + c) % NMAT] * F[NMAT - DIM + b]);
    }
    return det;
}

/* Cofactor (a, b): J F^-T, which turns reference normals into current ones. */
static inline double cofactor(const Mat F, int a, int b)
{
    if (DIM == 1) return 1;
    if (DIM == 2) return (a == b ? 1 : -1) * F[((1 - a) * DIM + 1 - b) % NMAT];
    const int i = (a + 1) % DIM, j = (a + 2) % DIM, k = (b + 1) % DIM, l = (b + 2) % DIM;
    return F[i * DIM + k] * F[j * DIM + l] - F[i * DIM + l] * F[j * DIM + k];
}

#endif
