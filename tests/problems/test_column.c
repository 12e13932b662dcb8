/* test_column.c: the exact solution of the bar under its own weight: the wave equation by finite
 * differences, its ends, free fall before the first wave arrives, the period; and that methods find
 * it. In one dimension and in two. */
#include "tests/fixture.h"

enum { Y = DIM - 1 };
static const Case column = {.dim = DIM, .problem = "column", .cells = 16};
static const double top = 2, c = 100, g = 100;

/* Downwards displacement at s from the top. */
static double sunk(const Fixture *r, double s, double t)
{
    Vec X = {0}, u;
    const double *in[DIM];
    double *out[DIM];
    for (int d = 0; d < DIM; d++) X[d] = 1, in[d] = &X[d], out[d] = &u[d];
    X[Y] = top - s;
    r->plan.scene.problem->exact(&r->plan.scene, 1, in, t, out);
    for (int d = 0; d < Y; d++) CU_ASSERT(u[d] == 0);
    return -u[Y];
}

static void open_column(Fixture *r, const char *method, const char *more)
{
    char set[64];
    snprintf(set, sizeof set, "dim=%d;%s", DIM, more ? more : "");
    CU_ASSERT_FATAL(fixture_plan(r, &column, method, CD, set));
}

/* w_tt = c^2 w_ss + g away from the fronts (s = c t and its reflections), where w_ss jumps. */
static void test_wave_equation(void)
{
    Fixture r;
    const double ds = 1e-3, dt = ds / (2 * c);
    int checked = 0;
    open_column(&r, "gimp", NULL);
    for (double ct = 0.0513; ct < 5; ct += 0.0717)
        for (double s = 0.0131; s < 1; s += 0.0379) {
            const double front = fabs(remainder(ct, 2)), t = ct / c, w = sunk(&r, s, t);
            const double near = fmin(fabs(s - front), fabs(2 - s - front));
            if (near < 3 * ds || s < 2 * ds || s > 1 - 2 * ds) continue;
            const double wtt = (sunk(&r, s, t + dt) - 2 * w + sunk(&r, s, t - dt)) / (dt * dt);
            const double wss = (sunk(&r, s + ds, t) - 2 * w + sunk(&r, s - ds, t)) / (ds * ds);
            CHECK_CLOSE(wtt, c * c * wss + g, 1e-4 * g);
            checked++;
        }
    CU_ASSERT(checked > 1000);
}

static void test_ends(void)
{
    Fixture r;
    open_column(&r, "gimp", NULL);
    for (double ct = 0; ct < 8; ct += 0.0717) {
        const double t = ct / c, tip = sunk(&r, 1, t);
        CHECK_CLOSE(sunk(&r, 0, t), 0, 1e-15);
        CHECK_CLOSE(sunk(&r, 1 - 1e-6, t), tip, 1e-12); /* no strain at the free end */
        CHECK_CLOSE(sunk(&r, 0.3, t + 4 / c), sunk(&r, 0.3, t), 1e-15);
        if (ct < 1) CHECK_CLOSE(tip, 0.5 * g * t * t, 1e-15); /* free fall */
    }
    CHECK_CLOSE(sunk(&r, 1, 2 / c), g / (c * c), 1e-15);
    CHECK_CLOSE(sunk(&r, 0.5, 0), 0, 1e-16);
    CHECK_CLOSE(r.plan.scene.error_scale, g / (c * c), 1e-15);
}

static double error_of(const char *method, int cells)
{
    Row row = {0};
    Fault fault;
    Case fine = column;
    fine.cells = cells;
    char set[64];
    snprintf(set, sizeof set, "dim=%d", DIM);
    RunSpec spec = fixture_spec(&fine, method, "cd", set);
    CU_ASSERT_FATAL(ENGINE_NAME.run(&spec, &row, &fault) == 0);
    CHECK_TEXT(row.status, "ok");
    return row.error_linf;
}

/* Order 1.3 or so: w_ss jumps at fronts. Cut cells at the free end, which leaves its grid line at
 * once, cost WLS more than GIMP; GE-WLS keeps its energy all the same. */
static void test_methods_find_it(void)
{
    static const char *const names[] = {"gimp", "ge_gimp"};
    for (int m = 0; m < COUNT(names); m++) {
        const double coarse = error_of(names[m], 16), fine = error_of(names[m], 32);
        CU_ASSERT(fine < 7e-3);
        CHECK_CLOSE(log2(coarse / fine), 1.3, 0.2);
    }
    CU_ASSERT(error_of("ge_wls", 16) < 0.05);
}

static const TestCase tests[] = {
    {"its wave equation", test_wave_equation},
    {"ends, free fall, period", test_ends},
    {"methods converge to it", test_methods_find_it},
    {NULL, NULL},
};
CHECK_SUITE(tests)
