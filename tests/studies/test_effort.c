/* test_effort.c: what accuracy costs, on tables made by hand: best and median of repeats, Pareto
 * fronts, and the cost to reach an error. */
#include <stdio.h>
#include <sys/stat.h>
#include <math.h>
#include "studies/engine/results.h"
#include "studies/tables/effort.h"
#include "tests/check.h"

static const char dir[] = "scratch/effort";

/* Error (4/N)^p, CPU time N^3/1000 s, work N^2: straight lines in log-log. */
static Effort point(const char *method, double cells, double p)
{
    return (Effort){.problem = "ring",
                    .method = method,
                    .integrator = "cd",
                    .layout = "cartesian",
                    .status = "ok",
                    .ppc = 4,
                    .cells = cells,
                    .error = pow(4 / cells, p),
                    .cpu = 1e-3 * pow(cells, 3),
                    .work = cells * cells,
                    .instructions = NAN,
                    .usable = true};
}

static Table *reach(const Effort *list, int n)
{
    Effort own[12];
    mkdir("scratch", 0777), mkdir(dir, 0777);
    for (int k = 0; k < n; k++) own[k] = list[k];
    FILE *f = fopen("scratch/effort/e.reach.csv", "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    fputs("problem,target,method,how,seconds,work,instructions,cells,integrator,layout,ppc\n", f);
    effort_reach_write(f, &(Efforts){n, own});
    fclose(f);
    Table *t = table_read_part(dir, "e", "reach", NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    return t;
}

/* A straight line is met where it lies, wherever the target is between two meshes, or beyond the
 * finest by less than a factor of 2. */
static void check_cost(const Table *t, int row, const char *how, double p)
{
    const double cells = 4 * pow(table_number(t, row, "target"), -1 / p);
    CHECK_TEXT(table_text(t, row, "how"), how);
    CHECK_CLOSE(table_number(t, row, "cells") / cells, 1, 1e-5); /* six digits are written */
    CHECK_CLOSE(table_number(t, row, "seconds") / (1e-3 * pow(cells, 3)), 1, 1e-5);
    CHECK_CLOSE(table_number(t, row, "work") / (cells * cells), 1, 1e-5);
}

/* Targets 1e-2, 1e-3, 3e-4, 1e-4; order 2 takes 40, 126, 231 and 400 cells. */
static void test_reach(void)
{
    const Effort list[] = {point("a", 64, 2),  point("a", 128, 2), point("a", 256, 2),
                           point("b", 8, 2),   point("b", 16, 2),  point("c", 32, 0.4),
                           point("c", 64, 0.4)};
    Table *t = reach(list, 7);
    CU_ASSERT_FATAL(t->nrow == 12);
    CHECK_TEXT(table_text(t, 0, "how"), "below");
    check_cost(t, 1, "reached", 2);
    check_cost(t, 2, "reached", 2);
    check_cost(t, 3, "extrapolated", 2);
    for (int row = 4; row < 12; row++) CHECK_TEXT(table_text(t, row, "how"), "never");
    table_free(t);
}

/* The coarsest mesh is better already; a lost run is passed over; an order that drops is not
 * prolonged. */
static void test_reach_ends(void)
{
    Effort list[] = {point("a", 512, 2), point("b", 64, 2),  point("b", 100, 2),
                     point("b", 256, 2), point("c", 64, 2),  point("c", 128, 2),
                     point("d", 64, 2),  point("d", 128, 2), point("d", 256, 2)};
    list[2].usable = false;
    list[5].error = 0.5 * list[4].error; /* of order 1 */
    list[8].error = 0.5 * list[7].error; /* of order 1 after 2 */
    Table *t = reach(list, 9);
    CU_ASSERT_FATAL(t->nrow == 16);
    CHECK_TEXT(table_text(t, 0, "how"), "below");
    CHECK_CLOSE(table_number(t, 0, "cells"), 512, 0);
    check_cost(t, 5, "reached", 2);
    CHECK_TEXT(table_text(t, 9, "how"), "extrapolated");
    CHECK_CLOSE(table_number(t, 9, "cells") / (128 * list[5].error / 1e-3), 1, 1e-5);
    CHECK_TEXT(table_text(t, 11, "how"), "never");
    check_cost(t, 13, "reached", 2);
    CHECK_TEXT(table_text(t, 14, "how"), "never");
    table_free(t);
}

static void thrice(const Results *r)
{
    effort_tables(r, 3);
}

static const Study page = {.name = "e", .page = &(StudyPage){.tables = thrice}};

/* Three repeats of three cases: the cheapest counts, the median stands beside it. Case 2 costs more
 * and errs more than case 1. */
static void test_points(void)
{
    static const char head[] = "problem,method,integrator,layout,status,ppc,cells,error_linf,"
                               "elements,particles,steps,cpu_s\n";
    static const struct {
        const char *method;
        double error, cpu[3];
    } cases[] = {{"gimp", 0.1, {3, 1, 2}}, {"gimp", 0.01, {5, 9, 7}}, {"mpm", 0.02, {8, 6, 10}}};
    static const int front[] = {1, 1, 0};
    mkdir("scratch", 0777), mkdir(dir, 0777);
    FILE *f = fopen("scratch/effort/e.csv", "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    fputs(head, f);
    for (int k = 0; k < 9; k++)
        fprintf(f, "ring,%s,cd,cartesian,ok,4,%d,%g,,%d,10,%g\n", cases[k % 3].method, 8 << k % 3,
                cases[k % 3].error, 100, cases[k % 3].cpu[k / 3]);
    fclose(f);
    CU_ASSERT_FATAL(results_tables(&page, dir, false, NULL) == 0);
    Table *t = table_read_part(dir, "e", "points", NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    CU_ASSERT_FATAL(t->nrow == 3);
    static const double least[] = {1, 5, 6}, middle[] = {2, 7, 8};
    for (int k = 0; k < 3; k++) {
        CHECK_CLOSE(table_number(t, k, "cpu_s"), least[k], 0);
        CHECK_CLOSE(table_number(t, k, "cpu_median"), middle[k], 0);
        CHECK_CLOSE(table_number(t, k, "work"), 1000, 0);
        CHECK_CLOSE(table_number(t, k, "front"), front[k], 0);
        CHECK_CLOSE(table_number(t, k, "front_own"), 1, 0);
    }
    table_free(t);
}

static const TestCase tests[] = {
    {"the cost to reach an error", test_reach},
    {"the cost where no line leads there", test_reach_ends},
    {"best of repeats, fronts", test_points},
    {NULL, NULL},
};
CHECK_SUITE(tests)
