/* material.c: see material.h. */
#include <math.h>
#include "chunk_log.h"
#include "material.h"

Material material_make(Law law, double E, double nu, double rho)
{
    return (Material){.law = law,
                      .E = E,
                      .nu = nu,
                      .rho = rho,
                      .lambda = E * nu / ((1 + nu) * (1 - 2 * nu)),
                      .mu = E / (2 * (1 + nu))};
}

double wave_speed_bar(const Material *m)
{
    return sqrt(m->E / m->rho);
}

double wave_speed_p(const Material *m)
{
    return sqrt((m->lambda + 2 * m->mu) / m->rho);
}

double wave_speed_bound(const Material *m)
{
    return sqrt((m->lambda + 3 * m->mu) / m->rho);
}

static inline void load(const double *const F[NMAT], int p, Mat out)
{
    for (int k = 0; k < NMAT; k++) out[k] = F[k][p];
}

/* (F F^T)_ab */
static inline double left_cauchy(const Mat F, int a, int b)
{
    double sum = 0;
    for (int k = 0; k < DIM; k++) sum += F[a * DIM + k] * F[b * DIM + k];
    return sum;
}

/* W11 eq 32 times J: lambda ln J I + mu (F F^T - I). */
static void kirchhoff_neo_hookean(const Material *m, const double *const F[NMAT], Field T[NMAT])
{
    const double lambda = m->lambda, mu = m->mu;
    Field J, ln_J;
    for (int p = 0; p < CHUNK; p++) {
        Mat f;
        load(F, p, f);
        J[p] = determinant(f);
        for (int a = 0; a < DIM; a++)
            for (int b = 0; b < DIM; b++)
                T[a * DIM + b][p] = mu * (left_cauchy(f, a, b) - (a == b));
    }
    for (int p = 0; p < CHUNK; p++) ln_J[p] = log_one(J[p]);
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < CHUNK; p++) T[a * DIM + a][p] += lambda * ln_J[p];
}

/* P = lambda tr(H) I + mu (H + H^T), H = F - I; T = P F^T (symmetric only to first order in H). */
static void kirchhoff_linear(const Material *m, const double *const F[NMAT], Field T[NMAT])
{
    for (int p = 0; p < CHUNK; p++) {
        Mat f, P;
        double trace = -DIM;
        load(F, p, f);
        for (int a = 0; a < DIM; a++) trace += f[a * DIM + a];
        for (int a = 0; a < DIM; a++)
            for (int b = 0; b < DIM; b++)
                P[a * DIM + b] = m->mu * (f[a * DIM + b] + f[b * DIM + a] - 2 * (a == b)) +
                                 (a == b) * m->lambda * trace;
        for (int a = 0; a < DIM; a++)
            for (int b = 0; b < DIM; b++) {
                double t = 0;
                for (int k = 0; k < DIM; k++) t += P[a * DIM + k] * f[b * DIM + k];
                T[a * DIM + b][p] = t;
            }
    }
}

void kirchhoff(const Material *m, const double *const F[NMAT], Field T[NMAT])
{
    if (m->law == LINEAR)
        kirchhoff_linear(m, F, T);
    else
        kirchhoff_neo_hookean(m, F, T);
}

/* W11 eq 31 (its "- 2" is the trace of the identity in 2D). */
static double energy_neo_hookean(const Material *m, const Mat F)
{
    double ln_J = log_one(determinant(F)), trace = -DIM;
    for (int a = 0; a < DIM; a++) trace += left_cauchy(F, a, a);
    return 0.5 * m->lambda * ln_J * ln_J - m->mu * ln_J + 0.5 * m->mu * trace;
}

static double energy_linear(const Material *m, const Mat F)
{
    double trace = 0, square = 0;
    for (int a = 0; a < DIM; a++) {
        trace += F[a * DIM + a] - 1;
        for (int b = 0; b < DIM; b++) {
            double strain = 0.5 * (F[a * DIM + b] + F[b * DIM + a]) - (a == b);
            square += strain * strain;
        }
    }
    return 0.5 * m->lambda * trace * trace + m->mu * square;
}

void stored_energy(const Material *m, int n, const double *const F[NMAT], double psi[])
{
    const bool linear = m->law == LINEAR;
    for (int p = 0; p < n; p++) {
        Mat f;
        load(F, p, f);
        psi[p] = linear ? energy_linear(m, f) : energy_neo_hookean(m, f);
    }
}

double out_of_plane_stress(const Material *m, const Mat F)
{
    double J = determinant(F);
    if (DIM == 1) return 0;
    if (m->law == LINEAR) {
        double trace = -DIM;
        for (int a = 0; a < DIM; a++) trace += F[a * DIM + a];
        return m->lambda * trace / J;
    }
    return m->lambda * log(J) / J;
}
