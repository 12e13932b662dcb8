/* test_status.c: how a run that goes wrong ends: what is named, what is written. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/run/loop.h"
#include "tests/fixture.h"

static Row run(const RunSpec *spec)
{
    Row row = row_empty();
    Fault fault = {0};
    CU_ASSERT_FATAL(run_spec(spec, &row, &fault) == 0);
    return row;
}

/* The status that a particle's own state calls for. */
static StatusCode verdict(const Fixture *r, const double *s, int n, int k)
{
    const Scene *scene = &r->plan.scene;
    Mat F;
    StatusCode code = OK;
    for (int j = 0; j < NMAT; j++) F[j] = s[(AT_F + j) * n + k];
    if (!(determinant(F) > 0)) code = isnan(determinant(F)) ? NOT_A_NUMBER : INVERTED;
    for (int d = 0; d < DIM; d++) {
        const double x = s[(AT_X + d) * n + k];
        if (isnan(x)) return NOT_A_NUMBER;
        if (x < scene->lo[d] - scene->cell || x > scene->hi[d] + scene->cell) code = LEFT_GRID;
    }
    return code;
}

static const struct {
    Case scene;
    StatusCode code;
    const char *name;
} ends[] = {{{1, "free_block", 20, 2, 0, "drift=10;box=1"}, LEFT_GRID, "left_grid"},
            {{2, "free_block", 10, 4, 0, "drift=10;box=1"}, LEFT_GRID, "left_grid"},
            {{1, "bar", 20, 2, 0, "v0=-3000"}, INVERTED, "inverted"},
            {{2, "free_block", 10, 4, 0, "swing=10;box=3"}, INVERTED, "inverted"}};

/* Steps until something is wrong: the lowest id with a fault is named, and no step before had one.
 */
static int step_to_end(Fixture *r, StatusCode code, Status *end)
{
    Sim *sim = fixture_sim(r);
    const int n = sim->p.count;
    int step = 0;
    do {
        *end = sim_step(sim, step * r->dt, r->dt, step == 0);
        step++;
    } while (end->code == OK && step < 500);
    double *s = fixture_state(sim);
    int lowest = 0;
    while (lowest < n && verdict(r, s, n, lowest) == OK) lowest++;
    CU_ASSERT(end->code == code);
    CU_ASSERT_FATAL(lowest < n);
    CU_ASSERT(end->point == lowest);
    CU_ASSERT(verdict(r, s, n, lowest) == code);
    free(s);
    sim_free(sim);
    return step;
}

/* The row names status, step, time, particle, and counts the steps that were finished. */
static void test_ends(void)
{
    for (int k = 0; k < COUNT(ends); k++) {
        Fixture r;
        Status end;
        char start[64], particle[32];
        if (ends[k].scene.dim != DIM) continue;
        CU_ASSERT_FATAL(fixture_plan(&r, &ends[k].scene, "gimp", CD, NULL));
        const int step = step_to_end(&r, ends[k].code, &end);
        RunSpec spec = fixture_spec(&ends[k].scene, "gimp", "cd", NULL);
        spec.t_end = 500 * r.dt;
        const Row row = run(&spec);
        CHECK_TEXT(row.status, ends[k].name);
        CU_ASSERT(row.steps == step - 1);
        snprintf(start, sizeof start, "step %d t=%.6g ", step, step * row.dt);
        snprintf(particle, sizeof particle, "particle %d ", end.point);
        CU_ASSERT(strncmp(row.reason, start, strlen(start)) == 0);
        CU_ASSERT_PTR_NOT_NULL(strstr(row.reason, particle));
    }
}

/* One bad particle: all near it are NaN a step later, and the status names the lowest id. */
static void test_nan(void)
{
    FOR_METHODS(m)
    {
        const Case c = {DIM, "free_block", 12, 0, 0, NULL};
        Fixture r;
        CU_ASSERT_FATAL(fixture_plan(&r, &c, (*m)->info.name, CD, NULL));
        Sim *sim = fixture_sim(&r);
        CU_ASSERT_FATAL(fixture_steps(&r, sim, 0, 2));
        const int n = sim->p.count;
        for (int s = 0; s < sim->p.n; s++)
            if (sim->p.id[s] == n / 2) sim->p.field[AT_V][s] = NAN;
        const Status end = sim_step(sim, 0, r.dt, false);
        double *s = fixture_state(sim);
        int lowest = 0;
        while (lowest < n && verdict(&r, s, n, lowest) == OK) lowest++;
        CU_ASSERT(end.code == NOT_A_NUMBER && end.point == lowest && lowest < n / 2);
        free(s);
        sim_free(sim);
    }
}

/* Padding follows a real particle of its chunk through large strains, next to walls, where nodes of
 * round-off mass have any velocity. */
static void check_padding(const Sim *sim)
{
    const Particles *p = &sim->p;
    for (int s = 1; s < p->n; s++)
        for (int f = 0; p->id[s] < 0 && f < FIELDS; f++)
            if (p->field[f] && f != AT_M && f != AT_VOL)
                CU_ASSERT(memcmp(&p->field[f][s], &p->field[f][s - 1], sizeof(double)) == 0);
}

static void test_padding(void)
{
    const Case walls[] = {{1, "sine_bar", 8, 2, 0.4, "A=.05"}, {2, "axis_mms", 7, 4, 0.4, "A=.05"}};
    FOR_METHODS(m)
    {
        Fixture r;
        if (DIM > 2) continue;
        CU_ASSERT_FATAL(fixture_plan(&r, &walls[DIM - 1], (*m)->info.name, CD, "allow_unstable=1"));
        Sim *sim = fixture_sim(&r);
        CU_ASSERT(fixture_steps(&r, sim, 0, 100));
        CU_ASSERT(sim->p.n > sim->p.count);
        check_padding(sim);
        sim_free(sim);
    }
}

/* After a failure nothing moves any more, whatever is asked for; nothing reads beyond the grid. */
static void test_after(void)
{
    const Case c = {DIM, "free_block", IN_THIS_DIM(8, 8, 4), 0, 0, "drift=10;box=1"};
    FOR_METHODS(m) FOR_INTEGRATORS(i)
    {
        Fixture r;
        int steps = 0;
        CU_ASSERT_FATAL(fixture_plan(&r, &c, (*m)->info.name, i, "allow_unstable=1"));
        Sim *sim = fixture_sim(&r);
        while (sim_step(sim, 0, r.dt, false).code == OK && steps < 500) steps++;
        const Status end = sim->status;
        double *before = fixture_state(sim);
        for (int k = 0; k < 3; k++) {
            const Status again = sim_step(sim, 0, r.dt, k == 0);
            CU_ASSERT(again.code == end.code && again.point == end.point && end.code != OK);
            CU_ASSERT(sim_project(sim).code == end.code);
        }
        double *after = fixture_state(sim);
        CU_ASSERT(memcmp(before, after, sizeof(double) * (size_t)(FIELDS * sim->p.count)) == 0);
        free(before), free(after), sim_free(sim);
    }
}

/* Displaced out of the grid. */
static void far_away(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)X, (void)v, (void)F, (void)L;
    for (int p = 0; p < n; p++) u[DIM - 1][p] = p < n / 2 ? 0 : 1e9 * s->hi[0];
}

static int unit_box(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 1, 0, 1);
    for (int d = 0; d < DIM; d++) s->hi[d] = s->body_hi[d] = 1;
    s->c = 1;
    return 0;
}

static void test_bad_start(void)
{
    static const Problem away = {.cfl = 0.1, .init = unit_box, .start = far_away};
    FOR_METHODS(m)
    {
        Fixture r;
        fixture_scene(&r, &away, *m, CD, 8, 1);
        if (DIM == 1) r.plan.setup.count = 8;
        Sim *sim = fixture_sim(&r);
        const Status end = sim_step(sim, 0, r.dt, true);
        CU_ASSERT(end.code == LEFT_GRID && end.point == sim->p.count / 2);
        CU_ASSERT(sim_project(sim).code == LEFT_GRID);
        sim_free(sim);
    }
}

/* Step, time and point of every way to end. */
static void test_reasons(void)
{
    static const struct {
        StatusCode code;
        const char *status, *reason;
    } told[] = {
        {LEFT_GRID, "left_grid", "step 5 t=0.5 particle 3 x=7"},
        {INVERTED, "inverted", "step 5 t=0.5 particle 3 J=7"},
        {NOT_A_NUMBER, "nan", "step 5 t=0.5 particle 3 x=7"},
        {SINGULAR, "singular",
         "step 5 t=0.5 particle 3 and all others: no node under them has mass"},
        {OK, "energy_growth", "step 2 t=0.2 energy 5 % above its start; fastest particle 9 v=6"}};
    const Case c = {DIM, "free_block", 8, 0, 0, NULL};
    Fixture r;
    CU_ASSERT_FATAL(fixture_plan(&r, &c, "gimp", CD, NULL));
    for (int k = 0; k < COUNT(told); k++) {
        Row row = row_empty();
        const Loop l = {.plan = &r.plan,
                        .status = {told[k].code, 3, 7},
                        .done = 4,
                        .dt = 0.1,
                        .failed_at = 0.5,
                        .growth_t = 0.2,
                        .growth_step = 2,
                        .fastest = 9,
                        .speed = 6};
        report_results(&l, &row);
        CHECK_TEXT(row.status, told[k].status);
        CHECK_TEXT(row.reason, told[k].reason);
    }
}

static bool nowhere(const Scene *s, const Vec X)
{
    (void)s, (void)X;
    return false;
}

static bool place_nothing(const Scene *s, double spacing, bool fitted, Layout *out)
{
    (void)s, (void)spacing, (void)fitted, (void)out;
    return true;
}

static const Problem empty[] = {{.cfl = 0.1, .init = unit_box, .inside = nowhere},
                                {.cfl = 0.1, .init = unit_box, .place = place_nothing}};

static void test_empty(void)
{
    FOR_METHODS(m) for (int k = 0; k < COUNT(empty); k++)
    {
        Fixture r;
        Points points;
        Samples samples;
        fixture_scene(&r, &empty[k], *m, CD, 8, 1);
        void *core = particle_solver.make(&r.plan.setup, &r.fault);
        CU_ASSERT_PTR_NOT_NULL_FATAL(core);
        const Status end = particle_solver.step(core, 0, r.dt, true);
        CU_ASSERT(end.code == EMPTY && end.point == -1);
        CU_ASSERT(particle_solver.project(core).code == EMPTY);
        particle_solver.view(core, &points, &samples);
        CU_ASSERT(points.n == 0 && samples.n == 0);
        particle_solver.free(core);
    }
}

/* Too large for any machine: refused before it is taken, as the machine's fault. */
static void test_too_large(void)
{
    const Case c = {DIM, "free_block", DIM == 1 ? 9e7 : 1e6, DIM < 3 ? 4 : 8, 0, "box=1000"};
    Fixture r;
    CU_ASSERT_FATAL(fixture_plan(&r, &c, "gimp", CD, NULL));
    CU_ASSERT_PTR_NULL(sim_new(&r.plan.setup, &r.fault));
    CU_ASSERT(r.fault.code == FAULT_MACHINE);
    CU_ASSERT_PTR_NOT_NULL(strstr(r.fault.text, "GB"));
}

static const TestCase tests[] = {
    {"left_grid, inverted", test_ends},
    {"nan", test_nan},
    {"padding follows its particle", test_padding},
    {"after a failure", test_after},
    {"wrong from the start", test_bad_start},
    {"reasons name step, time and point", test_reasons},
    {"empty", test_empty},
    {"too large", test_too_large},
    {NULL, NULL},
};
CHECK_SUITE(tests)
