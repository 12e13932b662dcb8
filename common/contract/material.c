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

double material_wave_speed_bar(const Material *m)
{
    return sqrt(m->E / m->rho);
}

double material_wave_speed_p(const Material *m)
{
    return sqrt((m->lambda + 2 * m->mu) / m->rho);
}

double material_wave_speed_bound(const Material *m)
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
static inline void neo_hookean(const Material *m, const Mat f, Mat T)
{
    const double pressure = m->lambda * log_one(determinant(f));
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++)
            T[a * DIM + b] = m->mu * (left_cauchy(f, a, b) - (a == b)) + (a == b ? pressure : 0);
}

/* P = lambda tr(H) I + mu (H + H^T), H = F - I; T = P F^T (symmetric only to first order in H). */
static inline void linear(const Material *m, const Mat f, Mat T)
{
    Mat P;
    double trace = -DIM;
    for (int a = 0; a < DIM; a++) trace += f[a * DIM + a];
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++)
            P[a * DIM + b] = m->mu * (f[a * DIM + b] + f[b * DIM + a] - 2 * (a == b)) +
                             (a == b) * m->lambda * trace;
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) {
            T[a * DIM + b] = 0;
            for (int k = 0; k < DIM; k++) T[a * DIM + b] += P[a * DIM + k] * f[b * DIM + k];
        }
}

/* One law over a chunk; `law` is a constant in each instance. */
static inline __attribute__((always_inline)) void
stress_loop(void (*law)(const Material *, const Mat, Mat), const Material *m,
            const double *const F[NMAT], const double weight[CHUNK], Field T[NMAT])
{
    const Material own = *m; /* its numbers stay in registers */
    for (int p = 0; p < CHUNK; p++) {
        Mat f, t;
        load(F, p, f);
        law(&own, f, t);
        for (int k = 0; k < NMAT; k++) T[k][p] = t[k] * weight[p];
    }
}

void material_kirchhoff_weighted(const Material *m, const double *const F[NMAT],
                                 const double weight[CHUNK], Field T[NMAT])
{
    if (m->law == LINEAR)
        stress_loop(linear, m, F, weight, T);
    else
        stress_loop(neo_hookean, m, F, weight, T);
}

void material_kirchhoff(const Material *m, const double *const F[NMAT], Field T[NMAT])
{
    Field one;
    for (int p = 0; p < CHUNK; p++) one[p] = 1;
    material_kirchhoff_weighted(m, F, one, T);
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

/* One law over all; `law` is a constant in each instance. */
static inline __attribute__((always_inline)) void
energy_loop(double (*law)(const Material *, const Mat), const Material *m, int n,
            const double *const F[NMAT], double *restrict psi)
{
    const Material own = *m;
    for (int p = 0; p < n; p++) {
        Mat f;
        load(F, p, f);
        psi[p] = law(&own, f);
    }
}

void material_stored_energy(const Material *m, int n, const double *const F[NMAT], double psi[])
{
    if (m->law == LINEAR)
        energy_loop(energy_linear, m, n, F, psi);
    else if (n == CHUNK)
        energy_loop(energy_neo_hookean, m, CHUNK, F, psi);
    else
        energy_loop(energy_neo_hookean, m, n, F, psi);
}

/* Eigenvalues and the vectors to them, the columns of `axes`, of a symmetric A: Jacobi's rotations,
 * one in the plane; in space a round of three leaves the cube of what is off the diagonal. */
static void find_principal(const Mat A, double value[DIM], Mat axes)
{
    Mat S;
    for (int k = 0; k < NMAT; k++) S[k] = A[k], axes[k] = k % (DIM + 1) == 0;
    for (int round = 0; round < (DIM > 2 ? 8 : 1); round++)
        for (int a = 0; a < DIM; a++)
            for (int b = a + 1; b < DIM; b++) {
                const double turn =
                    0.5 * atan2(2 * S[a * DIM + b], S[a * (DIM + 1)] - S[b * (DIM + 1)]);
                const double c = cos(turn), s = sin(turn);
                for (int k = 0; k < DIM; k++) { /* S R, axes R */
                    const double x = S[k * DIM + a], y = S[k * DIM + b];
                    const double u = axes[k * DIM + a], v = axes[k * DIM + b];
                    S[k * DIM + a] = c * x + s * y, S[k * DIM + b] = c * y - s * x;
                    axes[k * DIM + a] = c * u + s * v, axes[k * DIM + b] = c * v - s * u;
                }
                for (int k = 0; k < DIM; k++) { /* R^T S */
                    const double x = S[a * DIM + k], y = S[b * DIM + k];
                    S[a * DIM + k] = c * x + s * y, S[b * DIM + k] = c * y - s * x;
                }
            }
    for (int d = 0; d < DIM; d++) value[d] = S[d * (DIM + 1)];
}

double material_largest_stress(const Mat T)
{
    double value[DIM], most;
    Mat axes;
    find_principal(T, value, axes);
    most = value[0];
    for (int d = 1; d < DIM; d++) most = value[d] > most ? value[d] : most;
    return most;
}

double material_without_tension(const Material *m, const Mat F, Mat T)
{
    double square[DIM], ln_J = 0, trace = 0;
    Mat left, axes;
    for (int k = 0; k < NMAT; k++) left[k] = left_cauchy(F, k / DIM, k % DIM), T[k] = 0;
    find_principal(left, square, axes);
    for (int d = 0; d < DIM; d++)
        if (square[d] < 1) ln_J += 0.5 * log(square[d]), trace += square[d] - 1;
    for (int d = 0; d < DIM; d++)
        for (int k = 0; square[d] < 1 && k < NMAT; k++)
            T[k] += (m->lambda * ln_J + m->mu * (square[d] - 1)) * axes[k / DIM * DIM + d] *
                    axes[k % DIM * DIM + d];
    return 0.5 * m->lambda * ln_J * ln_J - m->mu * ln_J + 0.5 * m->mu * trace;
}

double material_out_of_plane_stress(const Material *m, const Mat F)
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
