/* test_adaptive.c: steps that change during a run (W11 eq 34): which step is taken, that velocities
 * stay in the middle between positions, and that nothing is lost by it. */
#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include "common/base/table.h"
#include "common/run/loop.h"
#include "tests/fixture.h"

static const Case scenes[] = {
    {1, "sine_bar", 20, 0, 0.4, ""}, {2, "ring", 8, 0, 0, ""}, {3, "shell", 6, 0, 0, ""}};

static Row run(const char *method, const char *more, double cfl, const char *history)
{
    Row row;
    Fault fault = {0};
    RunSpec spec = fixture_spec(&scenes[DIM - 1], method, "cd", more);
    if (cfl > 0) spec.cfl = cfl;
    spec.history = history;
    CU_ASSERT_FATAL(run_spec(&spec, &row, &fault) == 0);
    return row;
}

/* dt = CFL h/(v_max + max |v|), in the first step of a scene at rest CFL h/v_max; never more; the
 * last step ends at t_end exactly; the row's dt is the mean. */
static void test_steps(void)
{
    char path[64];
    Fault fault = {0};
    Fixture r;
    snprintf(path, sizeof path, "adaptive_%d.csv", (int)getpid());
    const Row row = run("gimp", "dt=adaptive", 0, path);
    CU_ASSERT_FATAL(fixture_plan(&r, &scenes[DIM - 1], "gimp", CD, NULL));
    const double most =
        r.plan.cfl * r.plan.scene.cell / material_wave_speed_bound(&r.plan.scene.mat);
    Table *h = table_read(path, &fault);
    CU_ASSERT_FATAL(h != NULL);
    unlink(path);
    double least = INFINITY;
    for (int k = 0; k + 1 < h->nrow; k++) {
        const double dt = table_number(h, k, "dt"), t = table_number(h, k, "t");
        CHECK_CLOSE(table_number(h, k + 1, "t") - t, dt, 1e-14 * row.t_end);
        CU_ASSERT(dt <= most * (1 + 1e-12));
        if (k + 3 < h->nrow) least = fmin(least, dt);
    }
    if (DIM > 1) CHECK_CLOSE(table_number(h, 0, "dt"), most, 1e-12 * most);
    CU_ASSERT(DIM == 1 || least < 0.9 * most);
    CU_ASSERT(table_number(h, h->nrow - 1, "t") == row.t_end);
    CHECK_CLOSE(row.dt, row.t_end / row.steps, 1e-15 * row.t_end);
    table_free(h);
}

/* The error is that of a constant step of the same mean, within 10 %. */
static void test_same_error(void)
{
    static const char *const names[] = {"gimp", "fem", "wls2"};
    for (int m = 0; m < COUNT(names) - (DIM > 2); m++) {
        if (DIM == 1 && m == 1) continue;
        const Row changing = run(names[m], "dt=adaptive", 0, NULL);
        const Row usual = run(names[m], NULL, 0, NULL);
        const Row constant = run(names[m], NULL, usual.cfl * changing.dt / usual.dt, NULL);
        CU_ASSERT(fabs(changing.error_linf / constant.error_linf - 1) < 0.1);
        CU_ASSERT(fabs(changing.error_l2 / constant.error_l2 - 1) < 0.1);
    }
}

/* Largest error at t_end in steps that alternate between (1 - odd) and (1 + odd) times their mean.
 */
static double alternating(double odd)
{
    Fixture r;
    Points p;
    Samples q;
    Scratch scratch = {0};
    const Case c = {1, "sine_bar", 80, 0, 0.4, "law=linear"};
    CU_ASSERT_FATAL(fixture_plan(&r, &c, "gimp", CD, NULL));
    void *core = particle_solver.make(&r.plan.setup, &r.fault);
    CU_ASSERT_FATAL(core != NULL);
    double t = 0;
    for (int k = 0; k < 200; k++) {
        const double dt = r.plan.t_end / 200 * (1 + (k % 2 ? odd : -odd));
        CU_ASSERT_FATAL(particle_solver.step(core, t, dt, k == 0).code == OK);
        t += dt;
    }
    particle_solver.view(core, &p, &q);
    CU_ASSERT_FATAL(norm_scratch_fit(&scratch, p.n));
    const double error = norm_displacement(&r.plan.scene, &p, t, 1, &scratch).linf;
    norm_scratch_free(&scratch);
    particle_solver.free(core);
    return error;
}

static void test_centred(void)
{
    if (DIM > 1) return;
    const double constant = alternating(0), uneven = alternating(0.5);
    CU_ASSERT(constant < 1e-3);
    CU_ASSERT(uneven < 1.2 * constant);
}

/* Threads change no step. */
static void test_threads(void)
{
    Row row[2];
    for (int k = 0; k < 2; k++) {
        Fault fault = {0};
        RunSpec spec = fixture_spec(&scenes[DIM - 1], "gimp", "cd", "dt=adaptive;steps=20");
        spec.threads = 1 + 2 * k;
        CU_ASSERT_FATAL(run_spec(&spec, &row[k], &fault) == 0);
    }
    CU_ASSERT(row[0].dt == row[1].dt);
    CU_ASSERT(row[0].error_linf == row[1].error_linf);
}

static const TestCase tests[] = {{"the step follows the fastest particle", test_steps},
                                 {"the error is that of equal steps", test_same_error},
                                 {"velocities stay centred when the step changes", test_centred},
                                 {"threads change no adaptive step", test_threads},
                                 {NULL, NULL}};
CHECK_SUITE(tests)
