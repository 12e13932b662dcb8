/* test_rules.c: the rules for times, particle counts, pairs of method and integrator, and defaults.
 */
#include <string.h>
#include "tests/fixture.h"

static Row run(const RunSpec *spec)
{
    Row row = row_empty();
    Fault fault = {0};
    CU_ASSERT_FATAL(run_spec(spec, &row, &fault) == 0);
    return row;
}

static const char *const any[] = {"", "bar", "free_block", "free_block"}; /* of each dimension */

static Case any_case(double cells, double ppc, double cfl)
{
    return (Case){DIM, any[DIM], cells, ppc, cfl, NULL};
}

/* n = ceil(t_end/dt0 - 1e-9), dt = t_end/n; an exact multiple of dt0 takes no step more. */
static void test_times(void)
{
    const double parts[] = {0.4, 1, 3, 6.5, 7, 19.999};
    for (int k = 0; k < COUNT(parts); k++) {
        const Case c = any_case(10, 0, 0.25);
        Fixture r;
        CU_ASSERT_FATAL(fixture_plan(&r, &c, "gimp", CD, NULL));
        RunSpec spec = fixture_spec(&c, "gimp", NULL, NULL);
        spec.t_end = parts[k] * 0.25 * 0.1 / r.plan.scene.c;
        const Row row = run(&spec);
        CU_ASSERT(row.steps == ceil(parts[k] - 1e-9));
        CHECK_CLOSE(row.dt * row.steps / spec.t_end, 1, 1e-14);
        CU_ASSERT(row.t_end == spec.t_end && row.cfl == 0.25 && row.h == 0.1 && row.cells == 10);
    }
}

/* steps=N stops early and leaves dt alone. */
static void test_steps(void)
{
    const Case c = any_case(10, 0, 0.25);
    RunSpec spec = fixture_spec(&c, "gimp", NULL, NULL);
    spec.t_end = 0.01;
    const Row full = run(&spec);
    CU_ASSERT(spec_set(&spec, "steps=3", NULL) == 0);
    const Row cut = run(&spec);
    CU_ASSERT(full.steps > 3 && cut.steps == 3 && cut.dt == full.dt && cut.t_end == full.t_end);
}

/* The column says what was used: 1D any real, rounded to whole particles; else n^DIM. */
static void test_ppc(void)
{
    const double ppc1[] = {0.7, 1, 2.34, 10}, cells = IN_THIS_DIM(16, 16, 4);
    for (int k = 0; k < COUNT(ppc1); k++) {
        const double ppc = DIM == 1 ? ppc1[k] : pow(k + 1, DIM);
        const Case c = any_case(cells, ppc, 0);
        const RunSpec spec = fixture_spec(&c, "gimp", NULL, "steps=1");
        const Row row = run(&spec);
        CU_ASSERT(row.particles == round(ppc * pow(cells, DIM)));
        CHECK_CLOSE(row.ppc, DIM == 1 ? round(ppc * 16) / 16 : ppc, 1e-12);
    }
}

/* What a refusal must say: exit code 2 and one line with these words. */
static void check_refused(const Case *c, const char *method, Integrator i, const char *more,
                          const char *const words[])
{
    Fixture r;
    CU_ASSERT_FATAL(!fixture_plan(&r, c, method, i, more));
    CU_ASSERT(r.fault.code == FAULT_USAGE);
    CU_ASSERT_PTR_NULL(strchr(r.fault.text, '\n'));
    for (; *words; words++) CU_ASSERT_PTR_NOT_NULL(strstr(r.fault.text, *words));
}

static void test_counts_refused(void)
{
    const Case both = any_case(16, 4, 0), none = any_case(16, 0, 0), odd = any_case(16, 3, 0);
    Fixture r;
    check_refused(&both, "gimp", CD, "particles=20", (const char *[]){"particles", NULL});
    if (DIM == 1) {
        CU_ASSERT_FATAL(fixture_plan(&r, &none, "gimp", CD, "particles=20"));
        CHECK_CLOSE(r.spec.ppc, 20.0 / 16, 1e-14);
        check_refused(&none, "gimp", CD, "particles=2.5",
                      (const char *[]){"particles", "2.5", NULL});
    } else
        check_refused(&odd, "gimp", CD, NULL, (const char *[]){"--ppc", "3", NULL});
    check_refused(&none, "gimp", CD, "no_such=1", (const char *[]){"no_such", NULL});
    check_refused(&none, "gimmp", CD, NULL, (const char *[]){"gimmp", "gimp", NULL});
}

/* Pairs of method and integrator: 0 refused, 1 runs, 2 runs with refresh=1. */
static const struct {
    const char *method;
    int cd, uvf, musl, usl, usf;
} pairs[] = {{"mpm", 1, 1, 1, 1, 1},
             {"gimp", 1, 1, 1, 1, 1},
             {"ge_mpm", 1, 2, 2, 1, 0},
             {"ge_gimp", 1, 2, 2, 1, 0}};

static void check_pair(const char *method, Integrator i, int wanted)
{
    const Case c = any_case(10, 0, 0);
    const char *const words[] = {method, step_integrators[i].name, "allow_unstable=1",
                                 wanted == 2 ? "refresh=1" : NULL, NULL};
    Fixture r;
    if (wanted == 1) CU_ASSERT(fixture_plan(&r, &c, method, i, NULL));
    if (wanted != 1) check_refused(&c, method, i, NULL, words);
    CU_ASSERT(fixture_plan(&r, &c, method, i, "refresh=1") == (wanted > 0));
    CU_ASSERT(fixture_plan(&r, &c, method, i, "allow_unstable=1"));
}

static void test_pairs(void)
{
    for (int k = 0; k < COUNT(pairs); k++) {
        const int wanted[] = {pairs[k].cd, pairs[k].uvf, pairs[k].musl, pairs[k].usl, pairs[k].usf};
        FOR_INTEGRATORS(i) check_pair(pairs[k].method, i, wanted[i]);
    }
}

static void test_defaults(void)
{
    FOR_METHODS(m)
    {
        const Case c = any_case(10, 0, 0);
        RunSpec spec = fixture_spec(&c, (*m)->info.name, NULL, NULL);
        Plan plan;
        CU_ASSERT_FATAL(plan_make(&spec, &plan, NULL) == 0);
        const bool tents = DIM > 1 && strcmp((*m)->info.name, "mpm") == 0;
        CHECK_TEXT(spec.integrator, tents ? "uvf" : "cd");
    }
    const Case c = any_case(10, 0, 0);
    RunSpec spec = fixture_spec(&c, NULL, NULL, NULL);
    Plan plan;
    CU_ASSERT_FATAL(plan_make(&spec, &plan, NULL) == 0);
    CHECK_TEXT(spec.method, "gimp");
}

static const TestCase tests[] = {
    {"number of steps and dt", test_times},
    {"steps=N", test_steps},
    {"particles per cell", test_ppc},
    {"particle counts that are refused", test_counts_refused},
    {"method x integrator pairs", test_pairs},
    {"defaults", test_defaults},
    {NULL, NULL},
};
CHECK_SUITE(tests)
