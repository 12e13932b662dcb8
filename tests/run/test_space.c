/* test_space.c: runs in three dimensions against the plane, symmetry, exact solutions and numbers
 * measured on an independent code. */
#include <string.h>
#include "studies/runs/run_args.h"
#include "tests/check.h"

/* The row of a run given as its command line. */
static Row run_text(const char *format, const char *method)
{
    char text[512];
    RunSpec spec;
    const Engine *engine;
    Fault fault = {0};
    Row row = row_empty();
    snprintf(text, sizeof text, format, method);
    CU_ASSERT_FATAL(run_args_resolve(text, &spec, &engine, &fault) == 0);
    check_context_of(engine->dim, &spec);
    CU_ASSERT_FATAL(engine->run(&spec, &row, &fault) == 0);
    return row;
}

/* The same of a run that must come to its end. */
static Row run_whole(const char *format, const char *method)
{
    const Row row = run_text(format, method);
    CHECK_TEXT(row.status, "ok");
    return row;
}

/* Tolerance of the momentum: round-off; for WLS (the only methods with a number of fallbacks) that
 * of dt sum_i (M_i - m_i) a_i: M_i and the integrated m_i differ at nodes near the surface only,
 * whose share of the mass is of order h. Measured: .044 h on the shell, .09 h for a block of four
 * cells. */
static double drift_of(const Row *row)
{
    return row->fallbacks >= 0 ? 0.1 * row->h : 1e-12;
}

static void check_equal(const Row *a, const Row *b, double tolerance)
{
    CHECK_CLOSE(a->error_linf / b->error_linf, 1, tolerance);
    CHECK_CLOSE(a->error_l2 / b->error_l2, 1, tolerance);
    CHECK_CLOSE(a->error_l1 / b->error_l1, 1, tolerance);
}

/* A ring between two symmetry planes is the plane ring. */
static void test_ring(void)
{
    static const char *const same[] = {"mpm", "gimp", "ge_gimp", "bspline", "apic", "tpic"};
    for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
        const Row plane = run_whole("run ring --cells 10 --method %s", same[k]);
        const Row space = run_whole("run ring --cells 10 --method %s --set dim=3", same[k]);
        CHECK_CLOSE(space.particles, 4 * plane.particles, 0);
        check_equal(&space, &plane, 1e-11);
    }
}

/* The same with WLS. Its trigger weight is a product over axes, and along z all particles lie h/4
 * from their node, where the spline is .6875: .12 in the plane is .12 * .6875 = .0825 here. (WLS2
 * has another quadrature in 3D, and GE-WLS curves its surface across the thickness.) */
static void test_wls_ring(void)
{
    for (int cells = 8; cells <= 10; cells++) {
        char plane[64], space[96];
        snprintf(plane, sizeof plane, "run ring --cells %d --method %%s", cells);
        snprintf(space, sizeof space, "%s --set dim=3 --set trigger=.0825", plane);
        const Row a = run_whole(space, "wls"), b = run_whole(plane, "wls");
        check_equal(&a, &b, 1e-10);
    }
}

/* Three symmetry planes stand for the other seven octants. */
static void test_octant(void)
{
    static const char *const each[] = {"gimp", "ge_gimp", "apic", "fem", "wls", "wls2", "ge_wls"};
    for (size_t k = 0; k < sizeof each / sizeof *each; k++) {
        const Row octant = run_whole("run shell --cells 6 --method %s", each[k]);
        const Row whole = run_whole("run shell --cells 6 --method %s --set sector=full", each[k]);
        CHECK_CLOSE(whole.elements > 0 ? whole.elements : whole.particles,
                    8 * (octant.elements > 0 ? octant.elements : octant.particles), 0);
        check_equal(&octant, &whole, 1e-10);
    }
}

/* Largest errors of the shell in one period: measured once on an independent code. */
static void test_shell(void)
{
    static const struct {
        const char *method, *text;
        double error, within;
    } known[] = {
        {"gimp", "run shell --cells 8 --method %s", 0.00898, 0.1},
        {"ge_gimp", "run shell --cells 8 --method %s", 0.00811, 0.1},
        {"bspline", "run shell --cells 8 --method %s", 0.0110, 0.1},
        {"fem", "run shell --cells 8 --cfl .6 --method %s", 0.00664, 0.05},
        {"fem", "run shell --cells 16 --cfl .6 --method %s", 0.00166, 0.05},
        {"fem", "run shell --cells 8 --cfl .6 --set body=elements --method %s", 0.00466, 0.05},
        {"wls", "run shell --cells 8 --method %s", 0.0191, 0.15},
        {"wls", "run shell --cells 16 --method %s", 0.00481, 0.15},
        {"wls2", "run shell --cells 8 --method %s", 0.0114, 0.1},
        {"wls2", "run shell --cells 16 --method %s", 0.00299, 0.1},
        {"ge_wls", "run shell --cells 8 --method %s", 0.00517, 0.05}, /* of this program */
        {"ge_wls", "run shell --cells 16 --method %s", 0.00128, 0.05}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        const Row row = run_whole(known[k].text, known[k].method);
        CHECK_CLOSE(row.error_linf / known[k].error, 1, known[k].within);
        CU_ASSERT(row.momentum_drift < drift_of(&row));
    }
}

/* Second order on the cube of standing waves. */
static void test_order(void)
{
    const Row coarse = run_whole("run axis_mms --cells 6 --set dim=3 --method %s", "ge_gimp");
    const Row fine = run_whole("run axis_mms --cells 12 --set dim=3 --method %s", "ge_gimp");
    CU_ASSERT(log2(coarse.error_linf / fine.error_linf) > 1.9);
}

/* W11's eq 17 at walls: nodes there lie on the surface, and the mean of their surface points is off
 * along it, by the strain; its length counts as a distance, with either sign. Energy grows in the
 * plane as in space; along normals it does not, and the error is GIMP's. */
static void test_walls(void)
{
    static const char *const each[] = {"run axis_mms --cells 8 --method %s",
                                       "run axis_mms --cells 8 --set dim=3 --method %s"};
    for (int k = 0; k < 2; k++) {
        char normals[96];
        snprintf(normals, sizeof normals, "%s --set distance=normals", each[k]);
        const Row mean = run_text(each[k], "wls"), along = run_whole(normals, "wls");
        CU_ASSERT(mean.energy_drift > 0.2 && mean.energy_drift < 0.31);
        CHECK_TEXT(mean.status, "energy_growth");
        CU_ASSERT(fabs(along.energy_drift) < 0.03);
        CHECK_CLOSE(along.error_linf / run_whole(each[k], "gimp").error_linf, 1, 0.25);
    }
}

/* Every method that runs in 3D keeps the momentum of a free block that drifts along all axes. The
 * drift of WLS falls with h at least. */
static void test_momentum(void)
{
    for (const Info *const *m = engine_3d.methods; *m; m++) {
        RunSpec spec = {.problem = "block"};
        strcpy(spec.method, (*m)->name);
        spec_set(&spec, "dim=3", NULL);
        if (engine_3d.resolve(&spec, NULL)) continue;
        static const char block[] = "run block --set dim=3 --set stretch=.95 --set angle=20 --set "
                                    "drift_x=.1 --set drift_y=-.05 --set drift_z=.07 --set "
                                    "offset_x=.3 --set offset_z=.2 --method %s";
        char coarse[320], fine[320];
        snprintf(coarse, sizeof coarse, "%s --cells 4 --set steps=20", block);
        snprintf(fine, sizeof fine, "%s --cells 8 --set steps=40", block);
        const Row row = run_text(coarse, (*m)->name);
        CU_ASSERT(row.momentum_drift < drift_of(&row));
        if (row.fallbacks >= 0 && row.momentum_drift > 1e-12) /* IMPM keeps it */
            CU_ASSERT(run_text(fine, (*m)->name).momentum_drift < 0.5 * row.momentum_drift);
    }
}

/* Neither threads nor empty space around the body change a bit of a row. */
static void test_same(void)
{
    static const char *const each[] = {"mpm", "gimp", "apic", "fem", "wls", "wls2", "ge_wls"};
    for (size_t k = 0; k < sizeof each / sizeof *each; k++) {
        static const char one[] = "run shell --cells 10 --set steps=15 --method %s";
        static const char two[] = "run shell --cells 10 --set steps=15 --threads 3 --method %s";
        const Row a = run_whole(one, each[k]), b = run_whole(two, each[k]);
        CU_ASSERT(a.error_linf == b.error_linf && a.error_l2 == b.error_l2);
        CU_ASSERT(a.energy_drift == b.energy_drift && a.momentum_drift == b.momentum_drift);
    }
    const Row near = run_whole("run block --set dim=3 --cells 8 --set drift_z=.1 --set stretch=.99 "
                               "--set box=2 --set steps=10 --method %s",
                               "gimp");
    const Row far = run_whole("run block --set dim=3 --cells 8 --set drift_z=.1 --set stretch=.99 "
                              "--set box=6 --set steps=10 --method %s",
                              "gimp");
    CHECK_CLOSE(near.energy_drift, far.energy_drift, 1e-12);
    CHECK_CLOSE(near.nodes, far.nodes, 0);
}

static int dim_of(const char *text)
{
    RunSpec spec;
    const Engine *engine;
    CU_ASSERT_FATAL(run_args_resolve(text, &spec, &engine, NULL) == 0);
    return engine->dim;
}

/* Commands of the time before 3D keep their meaning, and the key says dim=3 where it is not the
 * scene's own. */
static void test_dimension(void)
{
    RunSpec spec;
    const Engine *engine;
    char command[SPEC_TEXT];
    CU_ASSERT_EQUAL(dim_of("run free_block"), 2);
    CU_ASSERT_EQUAL(dim_of("run free_block --set dim=1"), 1);
    CU_ASSERT_EQUAL(dim_of("run ring"), 2);
    CU_ASSERT_EQUAL(dim_of("run ring --set dim=3"), 3);
    CU_ASSERT_EQUAL(dim_of("run shell"), 3);
    CU_ASSERT_EQUAL(dim_of("run bar"), 1);
    CU_ASSERT_FATAL(run_args_resolve("run ring --set dim=3", &spec, &engine, NULL) == 0);
    CHECK_CLOSE(spec.ppc, 8, 0);
    spec_command(&spec, command);
    CU_ASSERT_PTR_NOT_NULL(strstr(command, "--set dim=3"));
}

static const TestCase tests[] = {
    {"a ring between symmetry planes is the plane ring", test_ring},
    {"so it is with WLS", test_wls_ring},
    {"an octant of the shell is the whole", test_octant},
    {"errors of the shell as measured elsewhere", test_shell},
    {"second order of GE-GIMP on standing waves", test_order},
    {"eq 17 at walls", test_walls},
    {"momentum of a free block", test_momentum},
    {"threads and empty space change nothing", test_same},
    {"default dimension of a scene", test_dimension},
    {NULL, NULL},
};
CHECK_SUITE(tests)
