/* test_wls_mass.c: the consistent mass matrix of GE-WLS: its symbol (wave.h), entries, moments. */
#include <stdlib.h>
#include "methods/wls/wls.h"
#include "wave.h"

/* The wave on the nodes times M, over D; one entry of M after the other in a full cell's middle. */
static void multiply(Sim *sim, const double *x)
{
    const Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            w->inertia[at] = (Inertia){{0}, {0}, {0}};
            w->inertia[at].factor[I_V] = x[at];
        }
    wls_mass_times(sim);
}

static double *node_field(const Sim *sim)
{
    double *x = calloc((size_t)sim->g.rows * (size_t)sim->g.n[0] + 1, sizeof *x);
    CU_ASSERT_PTR_NOT_NULL_FATAL(x);
    return x;
}

static void test_matrix_symbol(void)
{
    Fixture r;
    static const char *const set[] = {"velocity=plain", "velocity=corrected"};
    for (int exact = 0; exact < 2; exact++) {
        Sim *sim = block_open(&r, set[exact]);
        const Grid *g = &sim->g;
        CU_ASSERT(sim_project(sim).code == OK);
        double *x = node_field(sim);
        for (int row = 0; row < g->rows; row++)
            for (int i = 0; i < g->n[0]; i++)
                x[(size_t)row * (size_t)g->n[0] + (size_t)i] =
                    cos(k_wave * ((i + g->origin[0]) - middle(sim) * (double)CELLS));
        multiply(sim, x);
        const Inertia in = wls_of(sim)->inertia[middle_node(sim)];
        check_coefficient(in.product[I_V] / in.row[I_SUM], exact ? 1.0 / 6 : 1.0 / 4);
        free(x);
        sim_free(sim);
    }
}

/* Entries 2/3 and 1/6 per axis, rho h^DIM their unit; others are 0. */
static void test_matrix_entries(void)
{
    Fixture r;
    Sim *sim = block_open(&r, "velocity=corrected");
    CU_ASSERT(sim_project(sim).code == OK);
    const size_t middle_at = middle_node(sim), row = (size_t)sim->g.n[0];
    double *x = node_field(sim);
    x[middle_at] = 1;
    multiply(sim, x);
    for (int j = DIM > 1 ? -2 : 0; j <= (DIM > 1 ? 2 : 0); j++)
        for (int i = -2; i <= 2; i++) {
            static const double entry[] = {2.0 / 3, 1.0 / 6, 0};
            const size_t at = (size_t)((ptrdiff_t)middle_at + j * (ptrdiff_t)row + i);
            const double want = entry[abs(i)] * (DIM > 1 ? entry[abs(j)] : 1) * pow(dx, DIM);
            CHECK_CLOSE(wls_of(sim)->inertia[at].product[I_V], want, 1e-14 * pow(dx, DIM));
        }
    free(x);
    sim_free(sim);
}

/* Off the grid's lines, turned in the plane: all cells of its edge are cut. */
static const char *const askew = DIM > 1 ? "offset_x=.3;offset_y=.2;angle=20;velocity=corrected"
                                         : "offset_x=.3;velocity=corrected";

/* sum over live nodes of y times (M x). */
static double form(Sim *sim, const double *y, const double *x)
{
    const Grid *g = &sim->g;
    double sum = 0;
    multiply(sim, x);
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            sum += y[at] * wls_of(sim)->inertia[at].product[I_V];
        }
    return sum;
}

/* First moments are M times coordinates less row sums; and M is symmetric, cut cells included. */
static void test_moments(void)
{
    Fixture r;
    Sim *sim = block_open(&r, askew);
    CU_ASSERT(sim_project(sim).code == OK);
    const Grid *g = &sim->g;
    const size_t n = (size_t)g->rows * (size_t)g->n[0];
    double *x = node_field(sim), *y = node_field(sim);
    for (int d = 0; d < DIM; d++) {
        for (size_t at = 0; at < n; at++)
            x[at] = (double)(d ? at / (size_t)g->n[0] : at % (size_t)g->n[0]);
        multiply(sim, x);
        for (size_t at = 0; at < n; at++) {
            const int row = (int)(at / (size_t)g->n[0]), i = (int)(at % (size_t)g->n[0]);
            if (i < g->lo[row] || i >= g->hi[row]) continue;
            const Inertia in = wls_of(sim)->inertia[at];
            CHECK_CLOSE(in.product[I_V], in.row[I_FIRST + d] + x[at] * in.row[I_SUM],
                        1e-12 * pow(dx, DIM));
        }
    }
    for (size_t at = 0; at < n; at++) x[at] = fixture_random(-1, 1), y[at] = fixture_random(-1, 1);
    const double sum = form(sim, y, x);
    CHECK_CLOSE(sum, form(sim, x, y), 1e-14);
    CU_ASSERT(fabs(sum) > 1e-5);
    free(x), free(y);
    sim_free(sim);
}

static const TestCase tests[] = {
    {"mass matrix 1 - k^2/6", test_matrix_symbol},
    {"its entries in full cells", test_matrix_entries},
    {"its first moments and symmetry, cut cells included", test_moments},
    {NULL, NULL},
};
CHECK_SUITE(tests)
