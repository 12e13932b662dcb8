/* test_hard.c: the block of the hard cases: what is imposed is what happens, and what should not
 * change does not; particles exactly on nodes; the order of walls. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/fixture.h"

static const double speed = 100; /* the block's c [m/s] */
enum { COARSE = IN_THIS_DIM(12, 12, 6), RUN_CELLS = IN_THIS_DIM(16, 16, 8) };

/* J that every particle with mass must have: of the methods that project linear fields exactly. */
static void check_imposed(const Method *m, const char *set, double per_step)
{
    enum { STEPS = IN_THIS_DIM(40, 40, 20) }; /* to a stretch of two */
    Fixture r;
    CU_ASSERT_FATAL(fixture_plan(&r, &(Case){DIM, "block", COARSE, 0, 0, set}, m->info.name, CD,
                                 "allow_unstable=1"));
    Sim *sim = fixture_sim(&r);
    CU_ASSERT_FATAL(fixture_steps(&r, sim, 0, STEPS));
    double *s = fixture_state(sim), most = 0;
    const int n = sim->p.count;
    for (int p = 0; p < n; p++) {
        Mat F;
        for (int k = 0; k < NMAT; k++) F[k] = s[(AT_F + k) * n + p];
        if (s[AT_M * n + p] > 0) most = fmax(most, fabs(determinant(F) / pow(per_step, STEPS) - 1));
    }
    CU_ASSERT(most < 1e-10);
    free(s);
    sim_free(sim);
}

static void test_imposed(void)
{
    const double dt = 0.3 / ((double)COARSE * speed), rate = 0.7 * speed * dt,
                 spin = 0.9 * speed * dt;
    int tried = 0;
    FOR_METHODS(m)
    {
        if (!(*m)->linear_exact) continue;
        check_imposed(*m, "rate=0.7;box=4", 1 + rate);
        if (DIM > 1) check_imposed(*m, "spin=0.9", 1 + spin * spin);
        tried++;
    }
    CU_ASSERT(tried >= 3);
}

/* Mass and momentum of velocities that alternate: each has the same size, their sum is nothing. */
static void test_ripple(void)
{
    Fixture r;
    CU_ASSERT_FATAL(
        fixture_plan(&r, &(Case){DIM, "block", 8, 0, 0, "ripple=0.01"}, "gimp", CD, NULL));
    Sim *sim = fixture_sim(&r);
    double *s = fixture_state(sim), sum = 0;
    for (int p = 0; p < sim->p.count; p++) {
        const double v = s[AT_V * sim->p.count + p];
        CHECK_CLOSE(fabs(v), 0.01 * speed, 1e-12);
        sum += v;
    }
    CU_ASSERT(s[AT_V * sim->p.count] * s[AT_V * sim->p.count + 1] < 0);
    CHECK_CLOSE(sum, 0, 1e-10);
    free(s);
    sim_free(sim);
}

static Row run(const char *set, const char *method, const char *integrator, const char *history)
{
    Row row = row_empty();
    Fault fault = {0};
    RunSpec spec =
        fixture_spec(&(Case){DIM, "block", RUN_CELLS, 0, 0, set}, method, integrator, "steps=30");
    spec.history = history;
    CU_ASSERT_FATAL(run_spec(&spec, &row, &fault) == 0);
    return row;
}

/* An error only where there is an answer. */
static void test_answers(void)
{
    CU_ASSERT(run("drift_x=0.2;offset_x=0.3", "gimp", "cd", NULL).error_linf < 1e-13);
    CU_ASSERT(run("gravity=5000", "gimp", "cd", NULL).error_linf < 1e-12);
    CU_ASSERT(run("gravity=5000", "gimp", "usl", NULL).error_linf > 1e-4);
    CU_ASSERT(isnan(run("stretch=1.1", "gimp", "cd", NULL).error_linf));
    CU_ASSERT(isnan(run("rate=0.1", "gimp", "cd", NULL).error_linf));
}

/* The last eight columns of a line of history: volume, extremes of J, angular momentum; those of
 * 3D. */
static void last_line(const char *path, double out[8])
{
    char line[512], last[512] = "";
    FILE *in = fopen(path, "r");
    CU_ASSERT_PTR_NOT_NULL_FATAL(in);
    while (fgets(line, sizeof line, in)) strcpy(last, line);
    fclose(in);
    for (int k = 7; k >= 0; k--) {
        char *comma = strrchr(last, ',');
        CU_ASSERT_PTR_NOT_NULL_FATAL(comma);
        out[k] = comma[1] && comma[1] != '\n' ? strtod(comma + 1, NULL) : NAN;
        *comma = 0;
    }
    remove(path);
}

/* A lattice of N points per axis has the second moment (1 - 1/N^2)/12 about its centre. */
static void test_history(void)
{
    enum { VOLUME, LEAST, MOST, ANGULAR };
    static const char path[] = "hard_history.csv";
    double end[8];
    const double w = 0.5 * speed, J = pow(1 + 0.3 / (double)RUN_CELLS * 0.5, 30);
    const double turned = pow(1 + pow(0.3 / (double)RUN_CELLS * 0.5, 2), 30);
    run("rate=0.5", "ge_gimp", "cd", path);
    last_line(path, end);
    CHECK_CLOSE(end[VOLUME], J, 1e-12);
    CHECK_CLOSE(end[LEAST], J, 1e-12);
    CHECK_CLOSE(end[MOST], J, 1e-12);
    CU_ASSERT((DIM == 2) == isfinite(end[ANGULAR]));
    if (DIM != 2) return;
    run("spin=0.5", "ge_gimp", "cd", path);
    last_line(path, end);
    CHECK_CLOSE(end[VOLUME], turned, 1e-12);
    CHECK_CLOSE(end[ANGULAR] / (w * (1 - 1.0 / (32 * 32)) / 6), turned, 1e-2);
}

/* Every other particle exactly on a node (four per axis, stretch 2), in tension; mirrored.
 * (WLS may return through the cell above a node: no image, but the run must go on.) */
static double *on_nodes(const Method *m, double sign, int *n)
{
    char set[128];
    Fixture r;
    snprintf(set, sizeof set, "stretch=2;offset_x=%g;drift_x=%g;allow_unstable=1", 0.25 * sign,
             0.05 * sign);
    CU_ASSERT_FATAL(fixture_plan(&r,
                                 &(Case){DIM, "block", IN_THIS_DIM(8, 8, 4), pow(4, DIM), 0.1, set},
                                 m->info.name, CD, NULL));
    Sim *sim = fixture_sim(&r);
    *n = sim->p.count;
    CU_ASSERT(fixture_steps(&r, sim, 0, 10) ||
              m->surface); /* cut cells may invert under such a shock */
    double *s = fixture_state(sim);
    sim_free(sim);
    return s;
}

/* Largest |x + x' - 3| [m] of the pairs X + X' = 3; y alike. */
static double mirror_gap(const double *a, const double *b, int n)
{
    double gap = 0;
    for (int p = 0; p < n; p++)
        for (int q = 0; q < n; q++) {
            double apart = fabs(a[AT_X0 * n + p] + b[AT_X0 * n + q] - 3);
            for (int d = 1; d < DIM; d++)
                apart += fabs(a[(AT_X0 + d) * n + p] - b[(AT_X0 + d) * n + q]);
            if (apart > 1e-9) continue;
            gap = fmax(gap, fabs(a[AT_X * n + p] + b[AT_X * n + q] - 3));
            for (int d = 1; d < DIM; d++)
                gap = fmax(gap, fabs(a[(AT_X + d) * n + p] - b[(AT_X + d) * n + q]));
        }
    return gap;
}

static void test_on_nodes(void)
{
    int compared = 0;
    FOR_METHODS(m)
    {
        int n;
        double *a = on_nodes(*m, 1, &n), *b = on_nodes(*m, -1, &n);
        if (!(*m)->assemble) {
            CU_ASSERT(mirror_gap(a, b, n) < 1e-12);
            compared++;
        }
        free(a), free(b);
    }
    CU_ASSERT(compared >= 7);
}

/* Walls given in another order change no bit. */
static void test_wall_order(void)
{
    const Case walled[] = {{1, "sine_bar", 16, 0, 0, NULL},
                           {2, "axis_mms", 8, 0, 0, NULL},
                           {3, "axis_mms", 6, 0, 0, NULL}};
    FOR_METHODS(m)
    {
        double *s[2];
        Sim *sim = NULL;
        for (int k = 0; k < 2; k++) {
            Fixture r;
            CU_ASSERT_FATAL(
                fixture_plan(&r, &walled[DIM - 1], (*m)->info.name, CD, "allow_unstable=1"));
            Scene *scene = &r.plan.scene;
            for (int i = 0; k && i < scene->nwall / 2; i++) {
                const Wall w = scene->wall[i];
                scene->wall[i] = scene->wall[scene->nwall - 1 - i];
                scene->wall[scene->nwall - 1 - i] = w;
            }
            CU_ASSERT(scene->nwall >= 2);
            sim_free(sim);
            sim = fixture_sim(&r);
            CU_ASSERT(fixture_steps(&r, sim, 0, 20));
            s[k] = fixture_state(sim);
        }
        CU_ASSERT(memcmp(s[0], s[1], sizeof(double) * FIELDS * (size_t)sim->p.count) == 0);
        sim_free(sim);
        free(s[0]), free(s[1]);
    }
}

/* The patch's bodies have their areas, however graded; its field is exact where it should be. */
static void test_patch(void)
{
    static const struct {
        const char *set;
        double area, left; /* [cells], all and of its left half */
    } bodies[] = {{"body=block", 100, 50},
                  {"body=strip", 15, 7.5},
                  {"body=corner", 75, 50},
                  {"body=slit", 95, 47.5},
                  {"grading=2", 100, 50}};
    if (DIM != 2) return;
    for (int k = 0; k < COUNT(bodies); k++) { /* h = 1/16: a side is ten cells */
        Fixture r;
        CU_ASSERT_FATAL(
            fixture_plan(&r, &(Case){2, "patch", 16, 64, 0, bodies[k].set}, "gimp", CD, NULL));
        Sim *sim = fixture_sim(&r);
        double *s = fixture_state(sim), area = 0, left = 0;
        for (int p = 0; p < sim->p.count; p++) area += s[AT_VOL * sim->p.count + p] * 16 * 16;
        for (int p = 0; p < sim->p.count; p++)
            if (s[AT_X0 * sim->p.count + p] < (3.3 + 5) / 16)
                left += s[AT_VOL * sim->p.count + p] * 16 * 16;
        CHECK_CLOSE(area, bodies[k].area, 0.01 * bodies[k].area);
        CHECK_CLOSE(left, bodies[k].left, 0.03 * bodies[k].area);
        free(s);
        sim_free(sim);
    }
    FOR_METHODS(m)
    {
        Row row = row_empty();
        const Case c = {2, "patch", 16, 4, 0, "jitter=0.4;grading=1.5;edges=1"};
        RunSpec spec = fixture_spec(&c, (*m)->info.name, NULL, NULL);
        CU_ASSERT_FATAL(run_spec(&spec, &row, NULL) == 0);
        CU_ASSERT(row.error_linf < 1e-12 || !(*m)->linear_exact);
        CU_ASSERT(row.error_linf > 1e-12 || (*m)->linear_exact ||
                  (*m)->affine); /* may start exact */
    }
}

static const TestCase tests[] = {
    {"imposed motion", test_imposed},
    {"velocities that alternate", test_ripple},
    {"an error only where there is an answer", test_answers},
    {"volume, J and angular momentum in histories", test_history},
    {"particles on nodes", test_on_nodes},
    {"walls in any order", test_wall_order},
    {"bodies of uneven particles", test_patch},
    {NULL, NULL},
};
CHECK_SUITE(tests)
