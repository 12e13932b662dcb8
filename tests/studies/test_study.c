/* test_study.c: the study engine on a small study of its own, and what pages share. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "studies/engine/cases.h"
#include "studies/engine/claims.h"
#include "studies/tables/curves.h"
#include "studies/engine/sidecar.h"
#include "studies/engine/run_study.h"
#include "studies/runs/run_args.h"
#include "tests/check.h"

static const char dir[] = "scratch/study";

static void cases(Cases *list, bool quick)
{
    case_add_with(list, "history", "history", "run bar --cells 8 --set steps=%d", 3);
    case_add(list, "run bar --cells 8 --set steps=3");
    case_add(list, "run bar --cells 8 --set steps=3 --method mpm");
    if (!quick) case_add(list, "run bar --cells 16 --set steps=3 --threads=1");
}

static void check(Check *c, const Results *r)
{
    double steps[4];
    CHECK_TEXT(r->dir, dir);
    claim(c, "T.rows", "a repeated case is a row each time",
          measure(select_all(r->rows, "steps", 4, steps, "cells=8 method=%s", "gimp"), 2, 2), 2, 2);
    claim(c, "T.fails", "out of bounds", measure(3, 1, 1), 0, 2);
    claim(c, "T.nan", "not there", measure(NAN, 1, 1), -INFINITY, INFINITY);
    claim_differs(c, "T.holds", "holds", measure(1, 3, 2), 0, 2, 5, 6, "reason");
    claim_differs(c, "T.differs", "as seen", measure(5.5, 1, 1), 0, 2, 5, 6, "reason");
    claim_differs(c, "T.neither", "neither", measure(4, 1, 1), 0, 2, 5, 6, "reason");
    claim_differs(c, "T.nan-too", "not there", measure(NAN, 1, 1), 0, 2, 5, 6, "reason");
    claim(c, "T.few", "within bounds, on too few rows", measure(1, 1, 2), 0, 2);
    claim_note(c, "a-note", .1);
}

static const StudyPage tiny_page = {.cases = cases, .check = check, .claims = 8};
static const Study tiny = {"tiny", "T", "a test", &tiny_page, NULL, NULL};
static const StudyOptions options = {.dir = dir, .jobs = 2};

static void test_verdicts(void)
{
    static const Verdict expected[] = {PASS, FAIL, FAIL, PASS, DIFFERS, FAIL, FAIL, FAIL};
    Check c = {0};
    Fault f;
    CU_ASSERT_FATAL(run_study(&tiny, &options, &f) == 0);
    CU_ASSERT_FATAL(claims_judge_study(&c, &tiny, dir, &f) == 0);
    CU_ASSERT_FATAL(c.n == 8);
    for (int k = 0; k < c.n; k++) CU_ASSERT(c.list[k].verdict == expected[k]);
    CHECK_TEXT(c.list[4].reason, "reason");
    CU_ASSERT(strlen(c.list[2].reason) > 0);
    CHECK_TEXT(c.list[7].reason, "the tables have numbers in 1 rows, the claim needs 2");
    CU_ASSERT(c.list[3].rows == 3 && c.list[7].rows == 1 && c.list[7].judged == false);
    free(c.list);
}

static void test_notes(void)
{
    char text[512] = "";
    FILE *f = fopen("scratch/study/tiny.var", "r");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    size_t n = fread(text, 1, sizeof text - 1, f);
    fclose(f);
    CU_ASSERT(n > 0 && strstr(text, "T_rows = 2\n") && strstr(text, "T_nan = NaN\n"));
    CU_ASSERT_PTR_NOT_NULL(strstr(text, "a_note = 0.1\n"));
}

static off_t size_of(const char *path)
{
    struct stat s;
    return stat(path, &s) == 0 ? s.st_size : -1;
}

static void test_file_comes_back(void)
{
    const char history[] = "scratch/study/tiny.history.csv", rows[] = "scratch/study/tiny.rows";
    const off_t before = size_of(rows), length = size_of(history);
    CU_ASSERT(before > 0 && length > 0);
    CU_ASSERT(run_study(&tiny, &options, NULL) == 0 && size_of(rows) == before);
    unlink(history);
    CU_ASSERT(run_study(&tiny, &options, NULL) == 0);
    CU_ASSERT(size_of(history) == length && size_of(rows) > before);
    Table *t = table_read("scratch/study/tiny.csv", NULL);
    CU_ASSERT(t && t->nrow == 4);
    table_free(t);
}

static void test_counts(void)
{
    CU_ASSERT(study_case_count(&tiny, false) == 4);
    CU_ASSERT(study_case_count(&tiny, true) == 3);
}

/* Steps 3, then as many as the last row had and one more, up to 6. */
static void first_case(Cases *list, bool quick)
{
    (void)quick;
    case_add(list, "run bar --cells 8 --set steps=3");
}

static void next_case(Cases *list, const Table *rows, bool quick)
{
    const double steps = table_number(rows, rows->nrow - 1, "steps");
    (void)quick;
    if (steps < 6) case_add(list, "run bar --cells 8 --set steps=%g", steps + 1);
}

static void test_refine(void)
{
    const char rows[] = "scratch/study/refined.rows";
    char reason[128];
    const StudyPage work = {.cases = first_case, .refine = next_case};
    const Study page = {"refined", "T", "", &work, NULL, NULL};
    CU_ASSERT_FATAL(run_study(&page, &options, NULL) == 0);
    const off_t length = size_of(rows);
    Table *t = table_read("scratch/study/refined.csv", NULL);
    CU_ASSERT(t && t->nrow == 4 && table_number(t, 3, "steps") == 6);
    table_free(t);
    CU_ASSERT(run_study(&page, &options, NULL) == 0 && size_of(rows) == length);
    CU_ASSERT(sidecar_is_current(&page, dir, reason));
    const StudyPage others = {.cases = cases, .refine = next_case};
    const Study other = {"refined", "T", "", &others, NULL, NULL};
    CU_ASSERT(!sidecar_is_current(&other, dir, reason));
}

static void wrong_run(Cases *list, bool quick)
{
    case_add(list, "run bar --cells %d", quick ? 0 : -1);
    case_add(list, "run baar");
}

static void wrong_kind(Cases *list, bool quick)
{
    (void)quick;
    case_add_with(list, "histories", "x", "run bar");
}

static void test_wrong_pages(void)
{
    StudyPage work = {.cases = wrong_run};
    const Study page = {.name = "wrong", .page = &work};
    Fault f = {0};
    CU_ASSERT(run_study(&page, &options, &f) == FAULT_USAGE);
    CU_ASSERT(strstr(f.text, "study wrong") && strstr(f.text, "'-1'"));
    work.cases = wrong_kind;
    CU_ASSERT(run_study(&page, &options, &f) == FAULT_USAGE && strstr(f.text, "'histories'"));
    CU_ASSERT(size_of("scratch/study/wrong.csv") == -1);
}

/* ---- curves.h */

static Table *table_of(const char *text)
{
    mkdir("scratch", 0777), mkdir(dir, 0777);
    FILE *f = fopen("scratch/study/page.part.csv", "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    fputs(text, f);
    fclose(f);
    Table *t = table_read_part(dir, "page", "part", NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    return t;
}

static void test_curves(void)
{
    static const double printed[] = {8, 2.5, 1};
    Table *t = table_of("m,x,y\na,1,8.4\na,2,2\nb,2,99\na,4,1\n");
    Curve c;
    curve_pick(&c, t, "x", "y", "m=%s", "a");
    CU_ASSERT(c.n == 3);
    CHECK_CLOSE(curve_at(&c, 2).value, 2, 0);
    CU_ASSERT(isnan(curve_at(&c, 3).value) && curve_at(&c, 3).rows == 0);
    CHECK_CLOSE(curve_max(&c, 3).value, 8.4, 0);
    CHECK_CLOSE(curve_settles(&c, 2, 3).value, 2, 0);
    CHECK_CLOSE(curve_settles(&c, 10, 3).value, 1, 0);
    CU_ASSERT(isnan(curve_settles(&c, 0.5, 3).value));
    CHECK_CLOSE(curve_deviation(&c, 1, 3, printed, 10).value, 0.2, 1e-15); /* .05, .2, 0 */
    CHECK_CLOSE(curve_deviation(&c, 1, 2, printed, 0.5).value, 0.1, 1e-15);
    CU_ASSERT(isnan(curve_deviation(&c, 2, 3, printed, 1).value)); /* none at x = 8 */
    CU_ASSERT(curve_deviation(&c, 2, 3, printed, 1).rows == 2);
    CHECK_CLOSE(select_value(t, "y", "m=b x=%d", 2).value, 99, 0);
    CU_ASSERT(isnan(select_value(t, "y", "m=c").value) && select_value(t, "y", "m=c").rows == 0);
    table_free(t);
}

/* Once met, NAN stays, wherever it comes; rows count once. */
static void test_measures(void)
{
    for (int bad = 0; bad < 3; bad++) {
        Measure most = measure_max_of(3), low = measure_min_of(3), all = measure_sum_of(3);
        for (int k = 0; k < 3; k++) {
            measure_add_max(&most, k == bad ? (double)NAN : k);
            measure_add_min(&low, k == bad ? (double)NAN : k);
            measure_add(&all, k == bad ? (double)NAN : k);
        }
        CU_ASSERT(isnan(most.value) && isnan(low.value) && isnan(all.value));
        CU_ASSERT(most.rows == 2 && low.rows == 2 && all.rows == 2 && most.needs == 3);
    }
    CHECK_CLOSE(measure_worse(1, 2), 2, 0);
    CHECK_CLOSE(measure_lesser(1, 2), 1, 0);
    CU_ASSERT(isnan(measure_worse(NAN, 1)) && isnan(measure_worse(1, NAN)) &&
              isnan(measure_lesser(NAN, 1)));
    const Measure many = measure(6, 9, 2), few = measure(3, 1, 2), ratio = measure_ratio(many, few);
    CHECK_CLOSE(ratio.value, 2, 0);
    CU_ASSERT(ratio.rows == 3 && ratio.needs == 4); /* too many here are no help there */
    CU_ASSERT(measure_sum(many, many).rows == 18 && measure_formula(1).needs == 0);
}

/* An order is over all meshes that it names, or none. */
static void test_orders(void)
{
    Curve c = {.n = 4, .x = {1, 2, 4, 8}, .y = {1, 4, 16, 64}};
    CHECK_CLOSE(curve_order(&c, 1, 8, 4).value, 2, 1e-14);
    CU_ASSERT(curve_order(&c, 2, 8, 3).rows == 3);
    c.y[2] = NAN;
    CU_ASSERT(isnan(curve_order(&c, 1, 8, 4).value) && curve_order(&c, 1, 8, 4).rows == 3);
    CHECK_CLOSE(curve_order(&c, 1, 2, 2).value, 2, 1e-14);
    c.y[2] = 0;
    CU_ASSERT(isnan(curve_order(&c, 1, 8, 4).value));
}

static void one_claim(Check *c, const Results *r)
{
    CU_ASSERT(results_part(r, "absent")->nrow == 0);
    claim(c, "T.one", "needs no row of a table", measure(1, 1, 1), 0, 2);
}

/* A page whose table is missing still makes its claims; one that makes others than it declares is
 * a fault. */
static void test_declared(void)
{
    StudyPage work = {.check = one_claim, .claims = 1};
    const Study page = {"tiny", "T", "", &work, NULL, NULL};
    Check c = {0};
    Fault f = {0};
    CU_ASSERT_FATAL(claims_judge_study(&c, &page, dir, &f) == 0 && c.n == 1);
    CU_ASSERT(c.list[0].verdict == FAIL);
    CU_ASSERT_PTR_NOT_NULL(strstr(c.list[0].reason, "tiny.absent.csv"));
    work.claims = 2;
    CU_ASSERT(claims_judge_study(&c, &page, dir, &f) == FAULT_MACHINE);
    CU_ASSERT_PTR_NOT_NULL(strstr(f.text, "makes 1 claims, declares 2"));
    free(c.list);
}

static void test_median(void)
{
    double odd[] = {5, 1, 3}, even[] = {4, 1, 3, 2};
    CHECK_CLOSE(measure_median(3, odd), 3, 0);
    CHECK_CLOSE(measure_median(4, even), 2.5, 0);
    CU_ASSERT(isnan(measure_median(0, odd)));
}

static void test_lost(void)
{
    Table *t = table_of("status\nok\nenergy_growth\nnan\nleft_grid\n");
    for (int row = 0; row < t->nrow; row++) CU_ASSERT(select_is_lost(t, row) == (row >= 2));
    table_free(t);
}

/* Pages of all problems with an exact solution (T-2) ask for it by default: that of scan needs a
 * setting, and FEM has no mesh for it, which is said before a run. */
static void test_exact_by_default(void)
{
    RunSpec spec;
    Fault fault = {0};
    const Engine *engine;
    CU_ASSERT(engine_2d.has_exact("ring") && engine_3d.has_exact("shell"));
    CU_ASSERT(!engine_2d.has_exact("scan") && !engine_2d.has_exact("two_disks"));
    CU_ASSERT(!engine_2d.has_exact("nothing"));
    CU_ASSERT(run_args_resolve("run scan --method gimp", &spec, &engine, &fault) == 0);
    CU_ASSERT(run_args_resolve("run scan --method fem", &spec, &engine, &fault) == FAULT_USAGE);
    CHECK_TEXT(fault.text, "--method: got 'fem', which has no mesh for the body of scan");
}

static const TestCase tests[] = {
    {"verdicts", test_verdicts},
    {"notes for the figure", test_notes},
    {"a file that is gone is made again", test_file_comes_back},
    {"number of cases", test_counts},
    {"cases that rows ask for", test_refine},
    {"a wrong page is a fault", test_wrong_pages},
    {"curves out of tables", test_curves},
    {"numbers with their rows", test_measures},
    {"orders over all meshes", test_orders},
    {"claims that a page declares", test_declared},
    {"medians", test_median},
    {"lost runs", test_lost},
    {"exact by default", test_exact_by_default},
    {NULL, NULL},
};
CHECK_SUITE(tests)
