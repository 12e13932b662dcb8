/* omega.c: see omega.h. */
#include "omega.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include "common/run/engine.h"

enum { EMPTY = 4 }; /* cells on either side of the bar */

/* Lumped masses and stiffness, in units of rho h and E/h. */
static void assemble(const char *method, int cells, int per_cell, double beyond, gsl_vector *m,
                     gsl_matrix *K)
{
    const double n = per_cell, end = cells + EMPTY + beyond; /* of the last particle, from node 0 */
    gsl_vector *G = gsl_vector_calloc(m->size);
    for (int p = 0; p < cells * per_cell; p++) {
        for (size_t i = 0; i < m->size; i++) {
            double S = 0, slope = 0;
            engine_1d.weight(method, end - p / n - (double)i, 0.5 / n, &S, &slope);
            *gsl_vector_ptr(m, i) += S / n;
            gsl_vector_set(G, i, slope);
        }
        gsl_blas_dger(1 / n, G, G, K);
    }
    gsl_vector_free(G);
}

/* K becomes M^-1/2 K M^-1/2, whose eigenvalues are those of M^-1 K; nodes without mass drop out. */
static void divide_by_masses(gsl_matrix *K, const gsl_vector *m)
{
    const double least = 1e-14;
    for (size_t i = 0; i < m->size; i++)
        for (size_t j = 0; j < m->size; j++) {
            const double a = gsl_vector_get(m, i), b = gsl_vector_get(m, j);
            double *k = gsl_matrix_ptr(K, i, j);
            *k = a > least && b > least ? *k / sqrt(a * b) : 0;
        }
}

double omega_step_limit(const char *method, int cells, int per_cell, double beyond)
{
    const size_t nodes = (size_t)cells + 2 * EMPTY;
    gsl_vector *m = gsl_vector_calloc(nodes), *squares = gsl_vector_alloc(nodes);
    gsl_matrix *K = gsl_matrix_calloc(nodes, nodes);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(nodes);
    assemble(method, cells, per_cell, beyond, m, K);
    divide_by_masses(K, m);
    gsl_eigen_symm(K, squares, work);
    const double largest = gsl_vector_max(squares);
    gsl_eigen_symm_free(work);
    gsl_matrix_free(K);
    gsl_vector_free(squares);
    gsl_vector_free(m);
    return 2 / sqrt(largest);
}
