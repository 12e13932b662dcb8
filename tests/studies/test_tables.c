/* test_tables.c: what pages share, on tables made by hand: points with mass, nodal forces inside a
 * block, histories, options of methods, the frequency of a bar, windows of stable steps. */
#include <math.h>
#include "studies/tables/block_nodes.h"
#include "studies/tables/ladder.h"
#include "studies/tables/masses.h"
#include "studies/tables/omega.h"
#include "studies/tables/variants.h"
#include "tests/check.h"

/* Two points at distance 1 from the centre (1, 1) turn with 7 rad/s about their middle, which
 * moves; the third has no mass. */
static void test_sums(void)
{
    Table *t = check_table("X,Y,x,y,vx,vy,Fxx,Fxy,Fyx,Fyy,mass\n"
                           "2,1,5,3,3,12,2,1,0.5,1,0.5\n"
                           "0,1,3,3,3,-2,-0.25,0,0,-4,0.5\n"
                           "9,9,9,9,9,9,9,9,9,9,0\n");
    const MassSums s = masses_sum(t, (const double[2]){1, 1});
    CU_ASSERT(s.n == 2);
    CHECK_CLOSE(s.J, 1.25, 1e-15);
    CHECK_CLOSE(s.least_J, 1, 0);
    CHECK_CLOSE(s.most_J, 1.5, 0);
    CHECK_CLOSE(s.least_Fxx, 0.25, 0);
    CHECK_CLOSE(s.inertia, 1, 1e-15);
    CHECK_CLOSE(s.angular, 7, 1e-13);
    table_free(t);
}

/* The lowest layer, Y = 2, hangs from y = 4: it is 1.5 and 2 times as far from there. */
static void test_stretch(void)
{
    Table *t = check_table("Y,y,mass\n3,9,1\n2,1,1\n2,0,1\n1,1,0\n"),
          *none = check_table("Y,y,mass\n");
    CHECK_CLOSE(masses_hanging_stretch(t, 4), 1.75, 1e-15);
    CU_ASSERT(isnan(masses_hanging_stretch(none, 4)));
    table_free(none);
    table_free(t);
}

/* Pressures 3 + 2 and 3 - 2 of neighbours at a spacing of .5; the third point is too far away. */
static void test_checkerboard(void)
{
    Table *t = check_table("X,Y,sxx,syy,szz,mass\n0,0,-5,-5,-5,0.25\n0.5,0,-1,-1,-1,0.25\n"
                           "9,0,-8,-8,-8,0.5\n");
    Masses all = masses_read(t);
    CU_ASSERT(all.n == 3);
    CHECK_CLOSE(all.list[0].pressure, 5, 1e-15);
    CHECK_CLOSE(masses_checkerboard(&all, 1, 1.5), sqrt(2), 1e-15); /* half the mass is off by 2 */
    CHECK_CLOSE(masses_checkerboard(&all, 1, 0.5), 0, 0);           /* each point alone */
    masses_free(&all);
    table_free(t);
}

/* h = .1, dt = 3e-4 s; a bar stretched to twice its length has sigma = 7500 Pa, so that a force of
 * sigma A changes the velocity of .1 kg by 22.5 m/s. Its outer node does not count. */
static void test_forces(void)
{
    static const double shift[] = {0.5};
    const BlockNodes bar = {1, 10, 3, shift, 2, 0, 0.1, 0.25};
    Table *t = check_table("x,mass,vx\n1.55,0.1,32.5\n1.6,0.2,-1.25\n2.06,0.1,99\n");
    double x[3], f[3];
    CU_ASSERT(block_node_force(&bar, t, 1, x, f));
    CHECK_CLOSE(x[0], 0.05, 1e-14);
    CHECK_CLOSE(f[0], -1, 1e-13);
    CU_ASSERT(f[1] == 0 && f[2] == 0 && !block_node_force(&bar, t, 2, x, f));
    CHECK_CLOSE(block_nodes_largest(&bar, t), 1, 1e-13);
    t->nrow = 0;
    CU_ASSERT(isnan(block_nodes_largest(&bar, t)));
    t->nrow = 3; /* to free them */
    table_free(t);
}

/* A block turned by 90 degrees is long in y. */
static void test_turned(void)
{
    const BlockNodes lying = {2, 4, 3, NULL, 2, 0, 0, 0.25},
                     upright = {2, 4, 3, NULL, 2, 90, 0, 0.25};
    Table *t = check_table("x,y,mass,vx,vy\n1.5,1.9,1,0,0\n");
    double x[3], f[3];
    CU_ASSERT(!block_node_force(&lying, t, 0, x, f) && block_node_force(&upright, t, 0, x, f));
    table_free(t);
}

static void test_history(void)
{
    Table *t = check_table("t,px\n0,2\n1,2\n2,2.5\n4,8\n"), *none = check_table("t,px\n");
    CHECK_CLOSE(curve_first_change(t, "px", 0.1), 2, 0);
    CHECK_CLOSE(curve_rate(t, "px", 0.25), 2, 1e-15);
    CU_ASSERT(isnan(curve_first_change(t, "px", 9)) && isnan(curve_rate(none, "px", 0.25)));
    table_free(none);
    table_free(t);
}

static void test_variants(void)
{
    static const Variant variants[] = {
        {"usual", ""}, {"spline", "return=spline"}, {"boxes", "domain=stretch"}};
    CHECK_TEXT(variant_run(&variants[0], "run ring --method %s", "fem"), "run ring --method fem");
    CHECK_TEXT(variant_run(&variants[1], "run ring --method wls"),
               "run ring --method wls --set return=spline");
    CU_ASSERT_PTR_NULL(variant_run(&variants[1], "run ring --method gimp"));
    CU_ASSERT_PTR_NULL(variant_run(&variants[2], "run ring --method fem")); /* it has no grid */
    Table *t = check_table(
        "method,params\nwls,return=spline\nwls,A=1\nwls,domain=stretch;return=spline\n");
    CU_ASSERT(variant_of_row(variants, 3, t, 0) == 1 && variant_of_row(variants, 3, t, 1) == 0);
    CU_ASSERT(variant_of_row(variants, 3, t, 2) == 2);
    table_free(t);
}

/* Tents, the last particle eps inside a cell: 2 sqrt(eps). */
static void test_omega(void)
{
    CHECK_CLOSE(omega_step_limit("mpm", 10, 2, 1e-4) / 0.02, 1, 0.01);
    CU_ASSERT(omega_step_limit("gimp", 10, 2, 1e-4) > 0.7);
}

/* The lowest rung is stable, too, but below one that is not. */
static void test_window(void)
{
    Ladder l = {.n = 5, .grade = {MARK_OK, MARK_LOST, MARK_OK, MARK_OK, MARK_WEAK}};
    int low, high;
    CU_ASSERT(ladder_window(&l, &low, &high) && low == 2 && high == 3);
    for (int k = 0; k < l.n; k++) l.grade[k] = MARK_LOST;
    CU_ASSERT(!ladder_window(&l, &low, &high));
}

static void test_lost(void)
{
    Table *t =
        check_table("method,status,e\ngimp,ok,1\ngimp,inverted,2\nwls,left_grid,3\nmpm,ok,4\n");
    const Measure lost = curve_lost(t, "gimp wls", 1, "");
    CU_ASSERT(lost.value == 2 && lost.rows == 3 && lost.needs == 2);
    CU_ASSERT(curve_lost(t, "mpm apic", 1, "").rows < 2);
    CU_ASSERT(select_largest(t, "e", 4).rows == 2 && isnan(select_largest(t, "e", 4).value));
    CU_ASSERT(select_is_word("ge_mpm mpm", "mpm") && !select_is_word("ge_mpm", "mpm"));
    table_free(t);
}

static const TestCase tests[] = {
    {"sums over points with mass", test_sums},
    {"stretch of a hanging body", test_stretch},
    {"checkerboard of pressure", test_checkerboard},
    {"forces on nodes inside a bar", test_forces},
    {"nodes inside a turned block", test_turned},
    {"histories", test_history},
    {"options that a method takes", test_variants},
    {"frequency of a bar", test_omega},
    {"window of stable steps", test_window},
    {"lost runs of some methods", test_lost},
    {NULL, NULL},
};
CHECK_SUITE(tests)
