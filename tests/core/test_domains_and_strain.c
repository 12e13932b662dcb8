/* test_domains_and_strain.c: what a run may choose instead of the papers' rules: half widths from
 * the stretch, or none of it; F by the exponential of dt L, or in cycles. */
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_matrix.h>
#include <stdlib.h>
#include "common/core/passes.h"
#include "common/core/scheme.h"
#include "common/core/strain.h"
#include "tests/fixture.h"

enum { ROUNDS = 200 };

static void random_matrix(double size, Mat out)
{
    for (int k = 0; k < NMAT; k++) out[k] = fixture_random(-size, size);
}

/* J > 0, stretches up to some 4. */
static void random_gradient(Mat F)
{
    do {
        random_matrix(2, F);
        for (int d = 0; d < DIM; d++) F[d * (DIM + 1)] += 1;
    } while (determinant(F) < 0.05);
}

/* U_dd = sum_k sqrt(c_k) e_k,d^2 of the eigenvalues and vectors of C = F^T F (GSL). */
static void eigen_stretch(const Mat F, double U[DIM])
{
    gsl_matrix *C = gsl_matrix_alloc(DIM, DIM), *e = gsl_matrix_alloc(DIM, DIM);
    gsl_vector *c = gsl_vector_alloc(DIM);
    gsl_eigen_symmv_workspace *w = gsl_eigen_symmv_alloc(DIM);
    for (size_t a = 0; a < DIM; a++)
        for (size_t b = 0; b < DIM; b++) {
            double sum = 0;
            for (size_t k = 0; k < DIM; k++) sum += F[k * DIM + a] * F[k * DIM + b];
            gsl_matrix_set(C, a, b, sum);
        }
    gsl_eigen_symmv(C, c, e, w);
    for (size_t d = 0; d < DIM; d++) {
        U[d] = 0;
        for (size_t k = 0; k < DIM; k++)
            U[d] += sqrt(fmax(gsl_vector_get(c, k), 0)) * pow(gsl_matrix_get(e, d, k), 2);
    }
    gsl_matrix_free(C), gsl_matrix_free(e), gsl_vector_free(c), gsl_eigen_symmv_free(w);
}

static void test_stretch(void)
{
    for (int round = 0; round < ROUNDS; round++) {
        double U[DIM];
        Mat F;
        random_gradient(F);
        eigen_stretch(F, U);
        for (int d = 0; d < DIM; d++) CHECK_CLOSE(stretch_along(F, d), U[d], 1e-12);
    }
}

/* Stretches, then a turn by `angle` in the plane of the first two axes (1D: none). */
static void turned(double angle, const double stretch[3], Mat F)
{
    const double c = cos(angle), s = sin(angle);
    const double Q[2][2] = {{c, -s}, {s, c}};
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++)
            F[a * DIM + b] = stretch[b] * (DIM > 1 && a < 2 && b < 2 ? Q[a % 2][b % 2]
                                           : a == b                  ? 1
                                                                     : 0);
}

static Sim *block(Fixture *r, const char *more)
{
    const Case c = {DIM, "free_block", 8, 0, 0, "spin=0;drift=0;swing=0"};
    CU_ASSERT_FATAL(fixture_plan(r, &c, "gimp", CD, more));
    return fixture_sim(r);
}

static void set_all(Sim *sim, const Mat F)
{
    for (int k = 0; k < NMAT; k++)
        for (int s = 0; s < sim->p.n; s++) sim->p.field[AT_F + k][s] = F[k];
}

/* Rotation changes no half width with U, and leaves none with F_dd at a quarter turn. */
static void test_half_widths(void)
{
    static const double stretch[3] = {1.4, 0.8, 1.1};
    static const char *const rules[] = {"domain=fxx", "domain=stretch", "domain=undeformed"};
    for (int rule = 0; rule < 3 && DIM < 3; rule++)
        for (int k = 0; k <= 8; k++) {
            Fixture r;
            Mat F;
            Field b;
            const double angle = k * M_PI / 4;
            Sim *sim = block(&r, rules[rule]);
            turned(angle, stretch, F);
            set_all(sim, F);
            sim_sort(sim);
            set_all(sim, F);
            const Chunk c = sim_chunk(sim, 0);
            for (int d = 0; d < DIM; d++) {
                const double by_F = fabs(F[d * (DIM + 1)]), least = 1e-6;
                const double wanted = rule == 0 ? fmax(by_F, least) : rule == 1 ? stretch[d] : 1;
                half_widths(sim, &c, d, b);
                for (int p = 0; p < CHUNK; p++) CHECK_CLOSE(b[p], sim->half * wanted, 1e-14);
            }
            sim_free(sim);
        }
}

/* All mass and no force reaches the grid from a body stretched to `stretch`, far beyond l = h/2,
 * and where half widths are capped; then it moves on without a fault. */
static void test_wide(void)
{
    static const char *const rules[] = {"domain=fxx", "domain=stretch", "domain=undeformed"};
    static const double stretches[] = {1e-3, 1, 2.9, 4, 50};
    for (int k = 0; k < 3 * COUNT(stretches) && DIM < 3; k++) {
        const double stretch = stretches[k / 3], all[3] = {stretch, stretch, stretch};
        Fixture r;
        Mat F;
        double mass = 0, force = 0, size = 0;
        Sim *sim = block(&r, rules[k % 3]);
        turned(0, all, F);
        set_all(sim, F);
        sim->half_now = fmin(sim->half * stretch, sim->half_max);
        sim_sort(sim);
        deposit_all(sim, 0, FORCES);
        for (int row = 0; row < sim->g.rows; row++)
            for (int i = sim->g.lo[row]; i < sim->g.hi[row]; i++) {
                const Line n = sim->g.node[(size_t)row * (size_t)sim->g.n[0] + (size_t)i];
                mass += n[0];
                for (int l = FLUX; l < LANES; l++) force += n[l], size += fabs(n[l]);
            }
        CHECK_CLOSE(mass, 1, 1e-12);
        CU_ASSERT(fabs(force) <= 1e-12 * size);
        CU_ASSERT(sim->half_max <= (MAX_WIDTH - 5) / 2.0);
        sim_free(sim);
    }
}

/* A chunk of one F and one L. */
typedef struct Piece {
    Field F[NMAT], sums[LANES];
    Chunk c;
} Piece;

static void piece_make(Piece *q, const Mat F, const Mat L)
{
    for (int k = 0; k < NMAT; k++) {
        q->c.F[k] = q->F[k];
        for (int p = 0; p < CHUNK; p++) {
            q->F[k][p] = F[k];
            q->sums[FLUX + k % DIM * DIM + k / DIM][p] = L[k];
        }
    }
}

static void by_gsl(const Mat A, Mat out)
{
    Mat copy;
    for (int k = 0; k < NMAT; k++) copy[k] = A[k];
    const gsl_matrix_view a = gsl_matrix_view_array(copy, DIM, DIM),
                          e = gsl_matrix_view_array(out, DIM, DIM);
    CU_ASSERT(gsl_linalg_exponential_ss(&a.matrix, (gsl_matrix *)&e.matrix, GSL_PREC_DOUBLE) == 0);
}

static void test_exponential(void)
{
    static const double sizes[] = {0, 1e-9, 1e-5, 1e-3, 0.1, 1, 4};
    for (int round = 0; round < ROUNDS; round++) {
        Mat A, own, gsl;
        double trace = 0, size = 1;
        random_matrix(sizes[round % COUNT(sizes)], A);
        if (DIM > 1 && round % 2 && sizes[round % COUNT(sizes)] < 1e-8)
            A[1 % NMAT] *= 1e9; /* where A^2 is small, but A is not */
        strain_exponential(A, own);
        by_gsl(A, gsl);
        for (int k = 0; k < NMAT; k++) size = fmax(size, fabs(gsl[k]));
        for (int k = 0; k < NMAT; k++) CHECK_CLOSE(own[k], gsl[k], 1e-13 * size);
        for (int d = 0; d < DIM; d++) trace += A[d * (DIM + 1)];
        CHECK_CLOSE(determinant(own), exp(trace), 1e-12 * pow(size, DIM));
    }
}

/* One step of every pair: the linear rule's F tells L, which tells the others' F. */
static void check_update(const char *method, Integrator i, const char *rule)
{
    const Case c = {DIM, "free_block", 8, 0, 0, "allow_unstable=1;frame=current"};
    double *F[2];
    Fixture r;
    int n = 0;
    for (int k = 0; k < 2; k++) {
        CU_ASSERT_FATAL(fixture_plan(&r, &c, method, i, k ? rule : NULL));
        Sim *sim = fixture_sim(&r);
        CU_ASSERT_FATAL(fixture_steps(&r, sim, 0, 1));
        F[k] = fixture_state(sim);
        n = sim->p.count;
        sim_free(sim);
    }
    double most = 0;
    for (int p = 0; p < n; p++) { /* F starts as I */
        Mat A, wanted, square;
        for (int k = 0; k < NMAT; k++) A[k] = F[0][(AT_F + k) * n + p] - (k % (DIM + 1) == 0);
        strain_exponential(A, wanted);
        for (int k = 0; k < NMAT && r.plan.setup.strain == STRAIN_SUBCYCLED; k++) {
            square[k] = 0; /* (I + A/2)^2 */
            for (int j = 0; j < DIM; j++)
                square[k] += ((k / DIM == j) + A[k / DIM * DIM + j] / 2) *
                             ((k % DIM == j) + A[j * DIM + k % DIM] / 2);
            wanted[k] = square[k];
        }
        for (int k = 0; k < NMAT; k++)
            most = fmax(most, fabs(F[1][(AT_F + k) * n + p] - wanted[k]));
    }
    CU_ASSERT(most < 1e-14);
    if (i != USF) { /* there F comes first */
        CU_ASSERT(fixture_gap(F[0], F[1], n, AT_X, DIM) < 1e-15);
        CU_ASSERT(fixture_gap(F[0], F[1], n, AT_L, NMAT) <=
                  1e-12 * fixture_size(F[0], n, AT_L, NMAT));
    }
    CU_ASSERT(fixture_gap(F[0], F[1], n, AT_F, NMAT) > 1e-7);
    free(F[0]), free(F[1]);
}

static void test_updates(void)
{
    if (DIM > 2) return; /* no scenes there */
    FOR_METHODS(m) FOR_INTEGRATORS(i)
    {
        check_update((*m)->info.name, i, "strain_update=exponential");
        check_update((*m)->info.name, i, "strain_update=subcycled;subcycles=2");
    }
}

/* An imposed spin (or in 1D growth), a hundred steps per turn: the linear rule's volume grows by
 * exp(2 pi w dt) per turn, k cycles' by the k-th root of that, the exponential's not at all. */
static void test_spin(void)
{
    const double step = 2 * M_PI / 100;
    Mat identity, L = {0};
    for (int k = 0; k < NMAT; k++) identity[k] = k % (DIM + 1) == 0;
    if (DIM == 1) L[0] = 1;
    if (DIM > 1) L[1 % NMAT] = -1, L[DIM % NMAT] = 1;
    for (int cycles = 0; cycles <= 5; cycles += 5) {
        Piece q;
        const Setup s = {.strain = cycles ? STRAIN_SUBCYCLED : STRAIN_EXPONENTIAL,
                         .subcycles = cycles};
        piece_make(&q, identity, L);
        for (int k = 0; k < 100; k++) strain_chunk(&s, &q.c, (const Field *)q.sums, step);
        Mat F;
        for (int k = 0; k < NMAT; k++) F[k] = q.F[k][CHUNK - 1];
        const double growth = log(determinant(F));
        if (DIM == 1) {
            CHECK_CLOSE(growth, cycles ? 500 * log(1 + step / 5) : 2 * M_PI, 1e-12);
        } else if (cycles) {
            CHECK_CLOSE(growth / (2 * M_PI * step / cycles), 1, 0.01);
        } else {
            CHECK_CLOSE(growth, 0, 1e-12);
        }
    }
}

static const TestCase tests[] = {
    {"the stretch along an axis is that of the eigenvalues", test_stretch},
    {"half widths by each rule, under rotation", test_half_widths},
    {"wide boxes: all mass, no net force, capped", test_wide},
    {"exponential of a matrix against GSL's", test_exponential},
    {"every method and integrator updates F by the rule", test_updates},
    {"an imposed spin keeps its volume", test_spin},
    {NULL, NULL},
};
CHECK_SUITE(tests)
