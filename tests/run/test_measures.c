/* test_measures.c: what is measured of a state, against plain sums: error norms, energies, momenta,
 * volumes, the von Mises stress. */
#include <stdio.h>
#include "common/run/ledger.h"
#include "common/run/output.h"
#include "common/run/state.h"
#include "common/base/table.h"
#include "tests/fixture.h"

/* Points 0, 1 have mass; 2 is a surface point and 3 padding, far off, which no norm counts. */
enum { N = 4, REAL = 2 };
static const double weight[N] = {1, 3, 0, 0}, mass[N] = {2, 5, 0, 0};
static const int ids[N] = {1, 0, 2, -1};

typedef struct Set {
    double X[DIM][N], x[DIM][N], v[DIM][N], F[NMAT][N];
    Points points;
    Samples samples;
} Set;

/* u = X_d + d + 1 */
static void shift(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    (void)s, (void)t;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) u[d][p] = X[d][p] + d + 1;
}

/* Anything but zeros and ones. */
static void fill(Set *s)
{
    s->points = (Points){.n = N, .id = ids, .m = mass, .V0 = weight};
    s->samples = (Samples){.n = N, .V0 = weight};
    for (int p = 0; p < N; p++) {
        for (int d = 0; d < DIM; d++) {
            s->X[d][p] = fixture_random(-1, 1);
            s->x[d][p] = p < REAL ? fixture_random(-1, 1) : 1e3;
            s->v[d][p] = p < REAL ? fixture_random(-1, 1) : 1e3;
            s->points.X[d] = s->X[d], s->points.x[d] = s->x[d], s->points.v[d] = s->v[d];
        }
        for (int k = 0; k < NMAT; k++) {
            s->F[k][p] = (k % (DIM + 1) == 0) + (p < REAL ? fixture_random(-0.3, 0.3) : 9);
            s->samples.F[k] = s->F[k];
        }
    }
}

static double size_of(double v[DIM][N], int p)
{
    double square = 0;
    for (int d = 0; d < DIM; d++) square += v[d][p] * v[d][p];
    return sqrt(square);
}

/* max e, sqrt(sum w e^2 / sum w), sum w e / sum w over a scale of 1/2. */
static void test_norms(void)
{
    const Problem problem = {.exact = shift};
    const Scene scene = {.problem = &problem, .error_scale = 0.5};
    Scratch scratch = {0};
    Set s;
    double off[DIM][N], e[REAL];
    fill(&s);
    for (int p = 0; p < REAL; p++) {
        for (int d = 0; d < DIM; d++) off[d][p] = s.x[d][p] - 2 * s.X[d][p] - (d + 1);
        e[p] = size_of(off, p) / 0.5;
    }
    CU_ASSERT_FATAL(norm_scratch_fit(&scratch, N));
    const Errors now = norm_displacement(&scene, &s.points, 0, 1, &scratch);
    CHECK_CLOSE(now.linf, fmax(e[0], e[1]), 1e-14);
    CHECK_CLOSE(now.l2, sqrt((e[0] * e[0] + 3 * e[1] * e[1]) / 4), 1e-14);
    CHECK_CLOSE(now.l1, (e[0] + 3 * e[1]) / 4, 1e-14);
    s.x[0][0] = NAN;
    const Errors none = norm_displacement(&scene, &s.points, 0, 1, &scratch);
    CU_ASSERT(isnan(none.linf) && isnan(none.l2) && isnan(none.l1));
    norm_scratch_free(&scratch);
}

/* |v_i - v(x_i)|/|v(x_i)|, equal weights, over nodes with mass within the body. */
static void test_projection(void)
{
    const Problem problem = {.exact = shift};
    Scene scene = {.problem = &problem, .error_scale = 1};
    Scratch scratch = {0};
    Set s;
    double off[DIM][N], exact[DIM][N], e[REAL];
    fill(&s);
    for (int d = 0; d < DIM; d++) scene.body_lo[d] = -2, scene.body_hi[d] = 2;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < REAL; p++) {
            exact[d][p] = s.x[d][p] + d + 1;
            off[d][p] = s.v[d][p] - exact[d][p];
        }
    for (int p = 0; p < REAL; p++) e[p] = size_of(off, p) / size_of(exact, p);
    Nodes nodes = {.n = N, .m = (const double[]){1, 9, 0, 1}}; /* 2: no mass; 3: outside */
    for (int d = 0; d < DIM; d++) nodes.x[d] = s.x[d], nodes.v[d] = s.v[d];
    CU_ASSERT_FATAL(norm_scratch_fit(&scratch, N));
    const Errors now = norm_projection(&scene, &nodes, &scratch);
    CHECK_CLOSE(now.linf, fmax(e[0], e[1]), 1e-14);
    CHECK_CLOSE(now.l2, sqrt((e[0] * e[0] + e[1] * e[1]) / 2), 1e-14);
    CHECK_CLOSE(now.l1, (e[0] + e[1]) / 2, 1e-14);
    norm_scratch_free(&scratch);
}

static void test_sums(void)
{
    Set s;
    Scratch scratch = {0};
    Volumes v;
    double kinetic = 0, speeds = 0, own[DIM] = {0}, J[REAL];
    fill(&s);
    for (int k = 0; k < REAL; k++) {
        Mat F;
        kinetic += 0.5 * mass[k] * pow(size_of(s.v, k), 2);
        speeds += mass[k] * size_of(s.v, k);
        for (int d = 0; d < DIM; d++) own[d] += mass[k] * s.v[d][k];
        for (int c = 0; c < NMAT; c++) F[c] = s.F[c][k];
        J[k] = determinant(F);
    }
    CU_ASSERT_FATAL(norm_scratch_fit(&scratch, CHUNK));
    const Side now = ledger_motion(&s.points, 1, &scratch);
    CHECK_CLOSE(now.kinetic, kinetic, 1e-14);
    CHECK_CLOSE(now.mv, speeds, 1e-14);
    for (int d = 0; d < DIM; d++) CHECK_CLOSE(now.p[d], own[d], 1e-14);
    norm_scratch_free(&scratch);
    v = ledger_volumes(&s.samples);
    CHECK_CLOSE(v.sum, weight[0] * J[0] + weight[1] * J[1], 1e-14);
    CHECK_CLOSE(v.least, fmin(J[0], J[1]), 0);
    CHECK_CLOSE(v.most, fmax(J[0], J[1]), 0);
}

/* Of two bodies: m r x v of their relative motion, reduced mass 10/7. */
static void test_turning(void)
{
    enum { Y = DIM - 1 };
    Set s;
    fill(&s);
    const double r[] = {s.x[0][1] - s.x[0][0], s.x[Y][1] - s.x[Y][0]};
    const double v[] = {s.v[0][1] - s.v[0][0], s.v[Y][1] - s.v[Y][0]};
    double about[3];
    ledger_angular_momentum(&s.points, about);
    if (DIM == 2) CHECK_CLOSE(about[2], 10.0 / 7 * (r[0] * v[1] - r[1] * v[0]), 1e-13);
    if (DIM == 1) CU_ASSERT(isnan(about[2]));
    if (DIM < 3) CU_ASSERT(isnan(about[0]) && isnan(about[1]));
}

/* sum V0 psi, psi one sample at a time. */
static void test_strain(void)
{
    const Scene scene = {.mat = material_make(NEO_HOOKEAN, 7, DIM == 1 ? 0 : 0.3, 1)};
    Scratch scratch = {0};
    Set s;
    double sum = 0;
    fill(&s);
    for (int k = 0; k < REAL; k++) {
        const double *F[NMAT];
        double psi;
        for (int c = 0; c < NMAT; c++) F[c] = &s.F[c][k];
        material_stored_energy(&scene.mat, 1, F, &psi);
        sum += weight[k] * psi;
    }
    CU_ASSERT_FATAL(norm_scratch_fit(&scratch, CHUNK));
    CHECK_CLOSE(ledger_strain(&scene, &s.samples, 1, &scratch), sum, 1e-14);
    norm_scratch_free(&scratch);
}

/* The columns of --particles are those of the state, in order of id. */
static void check_file(const State *now, const char *path)
{
    Table *t = table_read(path, NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    CU_ASSERT_FATAL(t->nrow == now->n);
    for (int k = 0; k < t->nrow; k++) {
        const double *F = now->F[k], *s = now->sigma[k];
        CHECK_CLOSE(table_number(t, k, "id"), k, 0);
        CHECK_CLOSE(table_number(t, k, "X"), now->X[k][0], 0);
        CHECK_CLOSE(table_number(t, k, "x"), now->x[k][0], 0);
        CHECK_CLOSE(table_number(t, k, "vx"), now->v[k][0], 0);
        CHECK_CLOSE(table_number(t, k, "Fxx"), F[0], 0);
        CHECK_CLOSE(table_number(t, k, "sxx"), s[0], 0);
        CHECK_CLOSE(table_number(t, k, "von_mises"), now->von_mises[k], 0);
        CHECK_CLOSE(table_number(t, k, "mass"), now->m[k], 0);
        CHECK_CLOSE(table_number(t, k, "energy"), now->energy[k], 0);
        if (DIM == 1) continue;
        CHECK_CLOSE(table_number(t, k, "Y"), now->X[k][1], 0);
        CHECK_CLOSE(table_number(t, k, "y"), now->x[k][1], 0);
        CHECK_CLOSE(table_number(t, k, "vy"), now->v[k][1], 0);
        CHECK_CLOSE(table_number(t, k, "Fxy"), F[1], 0);
        CHECK_CLOSE(table_number(t, k, "Fyx"), F[3], 0);
        CHECK_CLOSE(table_number(t, k, "Fyy"), F[4], 0);
        CHECK_CLOSE(table_number(t, k, "syy"), s[4], 0);
        CHECK_CLOSE(table_number(t, k, "sxy"), s[1], 0);
        CHECK_CLOSE(table_number(t, k, "szz"), s[8], 0);
    }
    table_free(t);
}

/* sqrt(3/2 s : s), s = sigma - tr sigma/3 over all nine components, out-of-plane stress included;
 * in 1D the stress is uniaxial. */
static void test_von_mises(void)
{
    const Case c = {DIM, "free_block", 8, 0, 0, NULL};
    Fixture r;
    State now;
    CU_ASSERT_FATAL(fixture_plan(&r, &c, "gimp", CD, NULL));
    void *core = particle_solver.make(&r.plan.setup, &r.fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(core);
    for (int k = 0; k < 20; k++)
        CU_ASSERT(particle_solver.step(core, k * r.dt, r.dt, k == 0).code == OK);
    CU_ASSERT_FATAL(state_of_points(&now, &r.plan.scene, &particle_solver, core, NULL) == 0);
    CU_ASSERT(now.n >= 16);
    for (int k = 0; k < now.n; k++) {
        const double *s = now.sigma[k], mean = (s[0] + s[4] + s[8]) / 3;
        double square = 0;
        for (int a = 0; a < 9; a++) square += pow(s[a] - (a % 4 == 0 ? mean : 0), 2);
        CHECK_CLOSE(now.von_mises[k], sqrt(1.5 * square), 1e-10);
        CU_ASSERT(DIM == 1 || (fabs(s[1]) > 0 && fabs(s[8]) > 0));
    }
    CU_ASSERT(output_particles("measures.csv", &r.plan.scene, &particle_solver, core, NULL) == 0);
    check_file(&now, "measures.csv");
    remove("measures.csv");
    state_free(&now);
    particle_solver.free(core);
}

/* A scene with an exact motion says its formula and its scale, one without says neither. */
static void test_formulas(void)
{
    for (const Problem *const *p = problems; *p; p++) {
        CU_ASSERT(!(*p)->exact == !(*p)->info.formula);
        CU_ASSERT(!(*p)->exact == !(*p)->info.scale);
    }
    for (const Info *const *m = method_infos; *m; m++)
        CU_ASSERT((*m)->formula && *(*m)->formula && !(*m)->scale);
}

/* Every column but the timings. */
static void test_thread_rows(void)
{
    static const Case blocks[] = {{1, "free_block", 200, 2, 0, NULL},
                                  {2, "free_block", 20, 4, 0, NULL},
                                  {3, "free_block", 6, 8, 0, "dim=3"}};
    FOR_METHODS(m)
    {
        Row one, many;
        Fault fault;
        char a[ROW_TEXT], b[ROW_TEXT];
        RunSpec spec =
            fixture_spec(&blocks[DIM - 1], (*m)->info.name, NULL, DIM < 3 ? "steps=20" : "steps=8");
        CU_ASSERT_FATAL(run_spec(&spec, &one, &fault) == 0);
        spec.threads = 3;
        CU_ASSERT_FATAL(run_spec(&spec, &many, &fault) == 0);
        CHECK_TEXT(one.status, "ok");
        for (int k = 0; k < row_columns(); k++) {
            row_cell(&one, k, a), row_cell(&many, k, b);
            if (!row_column_is_timing(k)) CHECK_TEXT(a, b);
        }
    }
}

static const TestCase tests[] = {
    {"error norms", test_norms},
    {"errors of a projection", test_projection},
    {"kinetic energy, momentum, volumes", test_sums},
    {"angular momentum about the centre of mass", test_turning},
    {"strain energy", test_strain},
    {"formulas and error scales of scenes, formulas of methods", test_formulas},
    {"von Mises stress; columns of --particles", test_von_mises},
    {"rows of several threads", test_thread_rows},
    {NULL, NULL},
};
CHECK_SUITE(tests)
