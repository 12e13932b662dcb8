/* test_readers.c: the row of a run as it is typed; what is read of a run's points and polygons; and
 * cells that have no number. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "studies/phrase.h"
#include "studies/runs/run_args.h"
#include "studies/runs/run_row.h"
#include "studies/tables/cloud.h"
#include "studies/tables/curves.h"
#include "studies/tables/patches.h"
#include "studies/tables/points.h"
#include "tests/check.h"

static const char path[] = "scratch/readers.csv";

static void write_file(const char *text)
{
    FILE *f = fopen(path, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    fputs(text, f);
    fclose(f);
}

/* A row of the ring at N = 16 with these settings. */
static const char *ring_row(const char *settings, const char *cfl, const char *rest)
{
    RunSpec spec;
    const Engine *engine;
    const char *text = phrase("run ring --method gimp --cells 16%s", settings);
    CU_ASSERT_FATAL(run_args_resolve(text, &spec, &engine, NULL) == 0);
    const char *params = "";
    for (int k = 0; k < spec.nset; k++)
        params =
            phrase("%s%s%s=%s", params, *params ? ";" : "", spec.set[k].name, spec.set[k].value);
    return phrase("ring,gimp,%s,16,%.17g,%s,%.17g,%s,%s\n", spec.integrator, spec.ppc, cfl,
                  spec.t_end, params, rest);
}

static void test_run_row(void)
{
    const char *rows =
        phrase("problem,method,integrator,cells,ppc,cfl,t_end,params,status,e\n%s%s%s%s",
               ring_row("", "0.3", "ok,1"), ring_row("", "0.1", "ok,2"),
               ring_row(" --set domain=stretch", "0.3", "ok,3"),
               ring_row(" --set refresh=1", "0.3", "inverted,4"));
    static const char *const none[] = {"--set refresh=1", "--set domain=undeformed",
                                       "--integrator uvf", "--set no=1", "--t-end .01"};
    Table *t = check_table(rows);
    const Measure kept = run_row_value(t, "e", "run ring --cells 16 --cfl %g", 0.1);
    CU_ASSERT(kept.value == 2 && kept.rows == 1 && kept.needs == 1);
    CU_ASSERT(run_row_value(t, "e", "run ring --method gimp --cells %d", 16).value == 1);
    CU_ASSERT(run_row_value(t, "e", "run ring --cells 16 --set domain=stretch").value == 3);
    for (size_t k = 0; k < sizeof none / sizeof *none; k++)
        CU_ASSERT(run_row_value(t, "e", "run ring --cells 16 %s", none[k]).rows == 0);
    table_free(t);
}

static void test_points(void)
{
    Table *t = check_table("x,y,sxx,sxy,sxz,syy,syz,szz\n1,2,5,1,0,3,0,2\n3,,0,0,0,0,0,0\n");
    double row[2], *all = points_all(t, "y x");
    points_row(t, 0, " x  y ", row);
    CU_ASSERT(row[0] == 1 && row[1] == 2);
    CU_ASSERT(all[0] == 2 && all[1] == 1 && isnan(all[2]) && all[3] == 3);
    CHECK_CLOSE(points_stress_along(t, 0, (const double[3]){2, 0, 0}), 5, 1e-15);
    CHECK_CLOSE(points_stress_along(t, 0, (const double[3]){1, 1, 0}), 5, 1e-15);
    CHECK_CLOSE(points_stress_along(t, 0, (const double[3]){0, 1, 1}), 2.5, 1e-15);
    free(all);
    table_free(t);
}

static void test_patches(void)
{
    write_file("cell,k,x,y,cut,z,face\n0,0,1,2,0,3,0\n0,1,4,5,0,6,0\n\n1,0,7,8,1,9,0\n");
    Patches p = patches_open(path);
    CU_ASSERT(patches_next(&p) && p.k == 0 && p.x[0] == 1 && p.x[2] == 3 && !p.cut);
    CU_ASSERT(patches_next(&p) && p.k == 1 && p.x[1] == 5);
    CU_ASSERT(patches_next(&p) && p.k == 0 && p.x[0] == 7 && p.cut);
    CU_ASSERT(!patches_next(&p) && !patches_next(&p) && p.corners == 3 && !p.f);
    write_file("cell,k,x,y,cut\n0,0,1,2,1\n");
    p = patches_open(path);
    CU_ASSERT(patches_next(&p) && p.x[1] == 2 && p.x[2] == 0 && p.cut && !patches_next(&p));
    unlink(path);
    p = patches_open(path);
    CU_ASSERT(!patches_next(&p) && p.corners == 0);
    p = patches_open(NULL);
    CU_ASSERT(!patches_next(&p));
}

/* The node at 0 lies among particles, that at 1 beyond them; the nearest particle is the second. */
static void test_cloud(void)
{
    Table *mesh = check_table("X,Y,error,weight\n0,0,3,1\n1,0,7,1\n");
    Table *particles =
        check_table("X,Y,error,weight\n-.4,-.4,1,1\n.1,.1,2,1\n-.4,.4,5,1\n.4,-.4,4,1\n");
    const CloudErrors e = cloud_compare(mesh, particles, 0.9);
    CU_ASSERT(e.nodes == 2 && e.pairs == 1);
    CU_ASSERT(e.all[0] == 7 && e.all[1] == 5 && e.linf[0] == 3 && e.linf[1] == 2);
    CU_ASSERT(e.l1[0] == 3 && e.l1[1] == 2);
    CU_ASSERT(cloud_compare(mesh, particles, 0.5).pairs == 0);
    table_free(mesh);
    table_free(particles);
}

static void test_measures(void)
{
    const Measure m[] = {measure(2, 1, 1), measure(3, 1, 2), measure(1, 2, 1)};
    CU_ASSERT(measure_largest(3, m).value == 3 && measure_least(3, m).value == 1);
    CU_ASSERT(measure_largest(3, m).rows < measure_largest(3, m).needs);
    CU_ASSERT(measure_least(1, m).value == 2);
    Curve c = {0};
    for (int k = 0; k < 3; k++) curve_add(&c, k, m[k]);
    CU_ASSERT(c.n == 2 && c.x[1] == 2 && c.y[1] == 1); /* the second lacks a row */
}

static void test_cells(void)
{
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    results_print(f, "%s,%d,%g,%.3g,%.2f,%.17g\n", "nan", 7, 0.5, 1234.5, 2.0, 0.1);
    results_print(f, "%g,%.3g,%.2f,%.10g\n", NAN, INFINITY, -NAN, -INFINITY);
    fclose(f);
    CHECK_TEXT(text, "nan,7,0.5,1.23e+03,2.00,0.10000000000000001\n,,,\n");
    free(text);
    Table *t = check_table("a,b\n1,\n");
    CU_ASSERT(isnan(select_number(t, 0, "b")) && select_max(t, "b", 1, " ").rows == 0);
    table_free(t);
}

static const TestCase tests[] = {
    {"rows of runs as they are typed", test_run_row},
    {"numbers of points", test_points},
    {"corners of polygons", test_patches},
    {"errors at the same points", test_cloud},
    {"ends of measures", test_measures},
    {"cells without a number", test_cells},
    {NULL, NULL},
};
CHECK_SUITE(tests)
