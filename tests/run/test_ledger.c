/* test_ledger.c: work of body forces, growth of energy, and columns of what was never measured. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/run/loop.h"
#include "common/base/table.h"
#include "tests/fixture.h"

static char *const files[] = {"ledger_a.csv", "ledger_b.csv"};

/* Runs a command's worth; false: this pair is refused. */
static bool run(RunSpec *spec, Row *row)
{
    Fault fault = {0};
    *row = row_empty();
    return run_spec(spec, row, &fault) == 0;
}

static Table *table_of(const char *path)
{
    Table *t = table_read(path, NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    return t;
}

/* m b . (x - X) of all particles, b downwards along the last axis. */
static double fallen(const Table *t, double gravity)
{
    static const char *const X[] = {"X", "Y", "Z"}, *const x[] = {"x", "y", "z"};
    double work = 0;
    for (int k = 0; k < t->nrow; k++)
        work += table_number(t, k, "mass") * gravity *
                (table_number(t, k, X[DIM - 1]) - table_number(t, k, x[DIM - 1]));
    return work;
}

static const struct {
    Case scene;
    double gravity;
} falls[] = {{{2, "hanging_bar", 8, 4, 0, "steps=40"}, 1000},
             {{2, "block", 7, 4, 0, "gravity=1000;steps=20;stretch=1.01;dim=2"}, 1000},
             {{1, "block", 7, 2, 0, "gravity=1000;steps=20;stretch=1.01;dim=1"}, 1000}};

/* External work is weight times the drop of the particles, whatever they call their velocity. */
static void check_fall(int k, const char *method, const char *integrator)
{
    RunSpec spec = fixture_spec(&falls[k].scene, method, integrator, NULL);
    Row row;
    spec.history = files[0];
    spec.particles = files[1];
    if (!run(&spec, &row)) return;
    Table *history = table_of(files[0]), *points = table_of(files[1]);
    const double drop = fallen(points, falls[k].gravity);
    CU_ASSERT(drop > 0 && row.steps >= 20);
    CHECK_CLOSE(table_number(history, history->nrow - 1, "external_work") / drop, 1, 1e-11);
    table_free(history);
    table_free(points);
}

static void test_work(void)
{
    static const char *const valid[] = {"mpm", "gimp", "bspline", "apic", "xpic", "wls2", "fem"};
    for (int k = 0; k < COUNT(falls); k++)
        for (int m = 0; m < COUNT(valid) && falls[k].scene.dim == DIM; m++)
            FOR_INTEGRATORS(i) check_fall(k, valid[m], step_integrators[i].name);
}

/* Starts from rest, stressed or not, or nearly from rest, under a force at once or one that rises
 * from nothing: what steps of time leave open is no growth, even where it would end the run. */
static void test_starts(void)
{
    static const Case starts[] = {
        {2, "block", 8, 4, 0, "gravity=1000;dim=2"},
        {2, "block", 8, 4, 0, "gravity=1000;dim=2;drift_x=.01;drift_y=-.02"},
        {1, "block", 8, 2, 0, "gravity=1000;dim=1"},
        {1, "block", 8, 2, 0, "gravity=1000;dim=1;drift_x=-.02"},
        {1, "block", 7, 2, 0, "gravity=1000;dim=1;stretch=1.1"},
        {2, "block", 7, 4, 0, "gravity=1000;dim=2;stretch=1.1"},
        {2, "hanging_bar", 8, 4, 0, NULL},
        {2, "hole_plate", 8, 4, 0, NULL},
        {2, "cantilever", 4, 4, 0, NULL}};
    for (int k = 0; k < COUNT(starts); k++) FOR_INTEGRATORS(i)
    for (int m = 0; m < 3 && starts[k].dim == DIM; m++) {
        RunSpec spec = fixture_spec(&starts[k], (const char *[]){"gimp", "apic", "fem"}[m],
                                    step_integrators[i].name, "stop_growth=1;steps=30");
        Row row;
        if (!run(&spec, &row)) continue;
        CHECK_TEXT(row.status, "ok");
        CU_ASSERT(row.steps == 30);
    }
}

/* K grows by a factor a step from next to nothing on top of a stored energy: seen as soon as it is
 * 5 % of it, or the step after; with usf one step later, when F has followed. */
static void check_growth(Loop *l, double factor)
{
    const double stored = 1;
    const bool late = step_strain_first(l->plan->setup.integrator);
    Side before = {.kinetic = 1e-9}, after = before;
    double known = before.kinetic;
    *l = (Loop){.plan = l->plan, .self = l->self, .growth_step = -1};
    loop_record_start(l, &before, &after, stored);
    for (; l->growth_step < 0 && known < 10; l->done++) {
        after.kinetic = before.kinetic * (l->done ? factor : 1);
        Moment m = {.t = (double)l->done,
                    .kinetic = 0.5 * (before.kinetic + after.kinetic),
                    .strain = stored};
        loop_record_energy(l, &m, &before, &after);
        if (m.kinetic < 0.04) CU_ASSERT(l->growth_step < 0);
        if (l->growth_step < 0) CU_ASSERT(known < 0.07);
        known = late ? before.kinetic : after.kinetic;
        before = after;
    }
    CU_ASSERT(l->growth_step > 0);
}

static void test_growth(void)
{
    static const double factors[] = {1.001, 1.1, 1.5, 2, 4, 10, 100, 1000};
    const Case c = {DIM, "free_block", 4, 0, 0, NULL};
    FOR_INTEGRATORS(i)
    for (int k = 0; k < COUNT(factors); k++) {
        Fixture r;
        CU_ASSERT_FATAL(fixture_plan(&r, &c, "gimp", i, NULL));
        Loop l = {.plan = &r.plan, .self = particle_solver.make(&r.plan.setup, &r.fault)};
        CU_ASSERT_PTR_NOT_NULL_FATAL(l.self);
        check_growth(&l, factors[k]);
        particle_solver.free(l.self);
    }
}

/* Of a method that is known to gain energy, too. */
static void test_real_growth(void)
{
    const Case c = {2, "vortex", 8, 4, 0, "stop_growth=1"};
    RunSpec spec = fixture_spec(&c, "ge_wls", "cd", NULL);
    Row row;
    if (DIM != 2) return;
    CU_ASSERT_FATAL(run(&spec, &row));
    CHECK_TEXT(row.status, "energy_growth");
    CU_ASSERT(row.steps > 10 && row.steps < 60 && row.energy_drift > 0.05);
}

/* Lost in the first step, nothing to measure, no motion: empty cells, not 0. */
static const struct {
    Case scene;
    const char *method, *status, *reason;
} nothings[] = {
    {{2, "ring", 8, 4, 10, NULL}, "gimp", "inverted", "step 1 t=0.01 particle 0 J=-2.10826"},
    {{2, "free_block", 10, 4, 100, "box=1;drift=10"}, "gimp", "left_grid", "step 1"},
    {{1, "squeeze", 1, 2, 0, NULL}, "gimp", "empty", "no node with mass"},
    {{2, "patch", 4, 4, 0, NULL}, "gimp", "empty", "no node with mass"},
    {{2, "patch", 1, 4, 0, NULL}, "gimp", "empty", "no particle"},
    {{2, "ring", 8, 4, 0, "A=0"}, "gimp", "ok", ""},
    {{2, "ring", 8, 4, 0, "A=0"}, "fem", "ok", ""},
    {{2, "axis_mms", 8, 4, 0, "A=0"}, "gimp", "ok", ""},
    {{2, "plate_vibration", 8, 4, 0, "A=0"}, "gimp", "ok", ""},
    {{2, "plate_vibration", 7, 4, 0, "A=0"}, "fem", "ok", ""},
    {{2, "vortex", 8, 4, 0, "G=0;steps=3"}, "gimp", "ok", ""},
    {{1, "sine_bar", 8, 2, 0, "A=0"}, "gimp", "ok", ""},
    {{1, "bar", 8, 2, 0, "v0=0"}, "gimp", "ok", ""},
};

static void test_nothing(void)
{
    for (int k = 0; k < COUNT(nothings); k++) {
        RunSpec spec = fixture_spec(&nothings[k].scene, nothings[k].method, NULL, NULL);
        Row row;
        if (nothings[k].scene.dim != DIM) continue;
        CU_ASSERT_FATAL(run(&spec, &row));
        CHECK_TEXT(row.status, nothings[k].status);
        CU_ASSERT(strncmp(row.reason, nothings[k].reason, strlen(nothings[k].reason)) == 0);
        CU_ASSERT(isnan(row.error_linf) && isnan(row.error_l2) && isnan(row.error_l1));
        const bool lost = strcmp(row.status, "ok") != 0;
        if (lost) CU_ASSERT(isnan(row.energy_drift) && isnan(row.momentum_drift));
    }
}

/* The positions of a run after `steps` steps, by id. */
static Table *positions(const Case *c, const char *integrator, double steps, const char *errors)
{
    char set[32];
    Row row;
    snprintf(set, sizeof set, "steps=%.0f", steps);
    RunSpec spec = fixture_spec(c, NULL, integrator, steps > 0 ? set : NULL);
    spec.particles = files[0];
    spec.errors = errors;
    CU_ASSERT_FATAL(run(&spec, &row));
    return table_of(files[0]);
}

/* Exact solutions at the time that the states of a failed run have: that of the failed step if it
 * moved the particles (most do), else the one before (USF strains them first). */
static void check_failed(const Case *c, const char *integrator, bool moves)
{
    RunSpec spec = fixture_spec(c, NULL, integrator, NULL);
    Plan plan;
    Row row;
    Fault fault;
    CU_ASSERT_FATAL(plan_make(&spec, &plan, &fault) == 0);
    spec = fixture_spec(c, NULL, integrator, NULL);
    CU_ASSERT_FATAL(run(&spec, &row));
    CHECK_TEXT(row.status, "inverted");
    CU_ASSERT_FATAL(row.steps > 0);
    Table *last = positions(c, integrator, row.steps, NULL);
    Table *end = positions(c, integrator, 0, files[1]), *errors = table_of(files[1]);
    double moved = 0, off = 0, t = row.dt * (row.steps + moves);
    CU_ASSERT(errors->nrow == end->nrow);
    for (int k = 0; k < end->nrow; k++) {
        const double X[2] = {table_number(end, k, "X"), table_number(end, k, "Y")};
        const double x[2] = {table_number(end, k, "x"), table_number(end, k, "y")};
        double u[2], e = 0;
        plan.scene.problem->exact(&plan.scene, 1, (const double *const[]){&X[0], &X[DIM - 1]}, t,
                                  (double *const[]){&u[0], &u[DIM - 1]});
        for (int d = 0; d < DIM; d++) e += pow(x[d] - X[d] - u[d], 2);
        e = fabs(table_number(errors, k, "error") - sqrt(e) / plan.scene.error_scale);
        off = e <= off ? off : e;
        moved = fmax(moved, fabs(x[0] - table_number(last, k, "x")));
    }
    CU_ASSERT((moved > 0) == moves && off <= 1e-12);
    table_free(last), table_free(end), table_free(errors);
}

static void test_failed_errors(void)
{
    static const Case ring = {2, "ring", 8, 4, 3, NULL};
    if (DIM != 2) return;
    check_failed(&ring, "cd", true);
    check_failed(&ring, "usf", false);
}

static const TestCase tests[] = {
    {"work of body forces", test_work},
    {"starts from rest", test_starts},
    {"growth by any factor", test_growth},
    {"growth of a method", test_real_growth},
    {"nothing is not zero", test_nothing},
    {"errors of a failed run", test_failed_errors},
    {NULL, NULL},
};
CHECK_SUITE(tests)
