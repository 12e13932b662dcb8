/* test_trial.c: no claim holds on nothing. Every study's claims are judged on tables that are
 * whole, header-only, of lost runs, with one run lost, and with a table missing. No number matters
 * here: a claim is `judged` if all its rows were there, whatever its range. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "studies/engine/claims.h"
#include "studies/engine/results.h"
#include "tests/check.h"
#include "trial.h"

static const char dir[] = "scratch/trial";

/* Lists of claims for trial_is_one. Of formulas: no run needed. */
static const char *const formulas[] = {"W07-2.",
                                       "T-9.cases",
                                       "T-9.complement",
                                       "W11-2.masks",
                                       "W11-2.smooth",
                                       "W11-3.circular",
                                       "H-5.tent-omega",
                                       "H-5.gimp-omega",
                                       "H-5.bspline-omega",
                                       "T-15.jump-centroid",
                                       "T-15.jump-exact",
                                       "T-15.jump-gauss16",
                                       "T-15.jump-samples16",
                                       "T-17.exact",
                                       "T-17.cells-mpm",
                                       "T-17.sizes-mpm",
                                       "T-17.order-mpm",
                                       "T-17.cells-gimp",
                                       "T-17.sizes-gimp",
                                       "T-17.order-gimp",
                                       "T-17.order-ge_gimp",
                                       "T-17.order-wls",
                                       "T-17.program",
                                       NULL};
/* Those of them that read no table either. */
static const char *const no_table[] = {"W11-2.masks", "W11-2.smooth",   "W11-3.circular",
                                       "T-9.cases",   "T-9.complement", NULL};
/* Claims that no run is lost, or on the value of a lost run: one lost run must change their number.
 */
static const char *const none_lost[] = {"T-12.wls2",
                                        "T-18d.lost",
                                        "W07-12.gimp-lost",
                                        "W07-12.ge-gimp-lost",
                                        "W11-6.cell-size",
                                        "W11-10.whole",
                                        "H-1.wls-bar",
                                        "T-1b.lost",
                                        "T-5.plane-gimp",
                                        "H-7.gimp",
                                        "H-8a.growth-all",
                                        "H-8b.stretch",
                                        "H-10.defined",
                                        "H-13.smooth",
                                        "H-13.disk",
                                        "H-15.vortex-stretch",
                                        "H-15.vortex-fixed-functions",
                                        "H-15.vortex-wls",
                                        "H-15.vortex-convected",
                                        "H-15.bar-fem",
                                        "H-15.bar-stretch",
                                        "H-15.bar-wls",
                                        "H-2.wls",
                                        NULL};
/* Claims that some runs are lost, or from where on; or on the best of many runs, or on those not
 * lost, of which a least number is required. */
static const char *const some_lost[] = {"T-8.ge-wls-time",
                                        "T-18e.h5-tent",
                                        "T-18e.h5-gimp",
                                        "T-18e.h5-ge_wls",
                                        "T-8.ge-wls-steps",
                                        "T-12.determinant",
                                        "T-12.count",
                                        "T-12.low",
                                        "T-12.usual",
                                        "T-10.vortex-wls2",
                                        "T-19.wls2",
                                        "T-10.bar",
                                        "W07-12.mpm-lost-2",
                                        "W07-12.mpm-lost-5",
                                        "W07-12.mpm-grown-5",
                                        "W07-12.mpm-ok-5",
                                        "W07-12.ge-mpm-unstable",
                                        "W07-12.low-ppc",
                                        "T-1.literal",
                                        "T-5.stale",
                                        "T-5.plane-stale",
                                        "H-7.tent",
                                        "H-7.plane",
                                        "H-7.wls",
                                        "H-8b.exponential",
                                        "H-15.vortex-gimp",
                                        "H-15.bar-gimp",
                                        "T-2.",
                                        "H-4.beam-all",
                                        "H-4.beam-worst",
                                        "H-3.pieces",
                                        "T-4.",
                                        "H-5.",
                                        NULL};
/* Those of some_lost that say that all runs are lost. */
static const char *const all_lost[] = {"W07-12.mpm-ok-5", "W07-12.ge-mpm-unstable",
                                       "T-1.literal",     "T-4.stale",
                                       "T-5.stale",       "T-5.plane-stale",
                                       "H-7.wls",         "H-15.vortex-gimp",
                                       "H-15.bar-gimp",   NULL};

typedef struct Trial {
    const Study *study;
    Cases cases;
    Check whole; /* on sound tables */
} Trial;

static void complain(const Claim *c, const char *what)
{
    printf("%s: %s: %s, %.6g on %d rows: %s\n", c->id, what, claim_verdict_name(c->verdict),
           c->measured, c->rows, c->reason);
}

static Check judge(const Trial *t, bool again)
{
    Check c = {0};
    Fault fault = {0};
    if (again && t->study->page->tables) results_tables(t->study, dir, false, &fault);
    if (claims_judge_study(&c, t->study, dir, &fault)) {
        printf("%s: %s\n", t->study->name, fault.text);
        CU_FAIL("claims are not made");
    }
    CU_ASSERT(c.n == t->study->page->claims);
    return c;
}

static void check_whole(Trial *t)
{
    trial_clear(dir);
    trial_rows(t->study, &t->cases, dir, SOUND);
    trial_files(&t->cases);
    t->whole = judge(t, true);
    for (const Claim *c = t->whole.list; c < t->whole.list + t->whole.n; c++) {
        if (!c->judged) complain(c, "on whole tables");
        CU_ASSERT(c->judged);
    }
}

/* No claim may PASS but those of the list. */
static void expect_none(Check *check, const char *what, const char *const may[])
{
    for (const Claim *c = check->list; c < check->list + check->n; c++) {
        const bool wrong = c->verdict == PASS && !trial_is_one(c->id, may);
        if (wrong) complain(c, what);
        CU_ASSERT(!wrong);
    }
    free(check->list);
}

static void check_empty(const Trial *t)
{
    trial_rows(t->study, &t->cases, dir, SOUND);
    if (t->study->page->tables) results_tables(t->study, dir, false, NULL);
    trial_empty(dir);
    Check c = judge(t, false);
    for (int k = 0; k < c.n; k++) {
        const bool wrong = c.list[k].judged && !trial_is_one(c.list[k].id, no_table);
        if (wrong) complain(&c.list[k], "has a number in tables without rows");
        CU_ASSERT(!wrong);
    }
    expect_none(&c, "on tables without rows", no_table);
    c = judge(t, true);
    expect_none(&c, "on runs without rows", formulas);
}

static void check_all_lost(const Trial *t)
{
    trial_rows(t->study, &t->cases, dir, LOST_RUN);
    Check c = judge(t, true);
    for (int k = 0; k < c.n; k++) {
        const char *id = c.list[k].id;
        const bool wrong = c.list[k].judged && !trial_is_one(id, formulas) &&
                           !trial_is_one(id, none_lost) && !trial_is_one(id, some_lost);
        if (wrong) complain(&c.list[k], "has a number from lost runs");
        CU_ASSERT(!wrong);
        if (c.list[k].verdict == PASS && trial_is_one(id, formulas)) c.list[k].verdict = NOT_RUN;
    }
    expect_none(&c, "with all runs lost", all_lost);
}

static bool is_same(const Claim *a, const Claim *b)
{
    return a->rows == b->rows &&
           (a->measured == b->measured || (isnan(a->measured) && isnan(b->measured)));
}

static void spoil(const Trial *t, const char *sound, int row, Spoiled how, bool stands[])
{
    const char *file = t->cases.list[row].file;
    char aside[TRIAL_PATH];
    trial_one_row(t->study, &t->cases, sound, dir, row, how);
    snprintf(aside, sizeof aside, "%s.aside", file ? file : "");
    if (file && how == ABSENT) rename(file, aside);
    Check c = judge(t, true);
    if (file && how == ABSENT) rename(aside, file);
    for (int k = 0; k < c.n; k++) {
        const Claim *one = &c.list[k];
        if (how != LOST_RUN) {
            stands[k] = stands[k] || !is_same(one, &t->whole.list[k]);
            continue;
        }
        const bool bad = trial_is_one(one->id, none_lost) ? one->verdict == PASS : one->judged;
        const bool wrong = stands[k] && bad && !trial_is_one(one->id, some_lost);
        if (wrong) {
            complain(one, "with one run lost");
            printf("  %s\n", t->cases.list[row].command);
        }
        CU_ASSERT(!wrong);
    }
    free(c.list);
}

/* A claim uses a row if it changes with the row's numbers, or without the row. */
static void check_one_lost(const Trial *t)
{
    enum { TRIED = 4 };
    const int n = t->cases.n, tried = n < TRIED ? n : TRIED;
    char *sound = trial_text(&t->cases, SOUND);
    for (int k = 0; k < tried; k++) {
        const int row = k * n / tried;
        bool *stands = calloc((size_t)t->whole.n + 1, sizeof *stands);
        CU_ASSERT_PTR_NOT_NULL_FATAL(stands);
        spoil(t, sound, row, ABSENT, stands);
        spoil(t, sound, row, k % 2 ? SMALLER : LARGER, stands); /* whatever is an extreme */
        spoil(t, sound, row, LOST_RUN, stands);
        free(stands);
    }
    free(sound);
}

static void check_lost_and_empty(const Trial *t)
{
    check_all_lost(t);
    check_empty(t);
}

/* Judges each study on whole tables, then acts. */
static void each_study(void (*act)(const Trial *t))
{
    mkdir("scratch", 0777);
    mkdir(dir, 0777);
    for (const Study *s = studies; s->name; s++) {
        Trial t = {.study = s};
        if (!s->page->check || s->page->claims == 0) continue;
        CU_ASSERT_FATAL(cases_build(&t.cases, s, false, NULL, dir, NULL) == 0);
        check_whole(&t);
        act(&t);
        free(t.whole.list);
        cases_free(&t.cases);
    }
    trial_clear(dir);
}

static void test_whole(void)
{
    each_study(check_lost_and_empty);
}

static void test_one_lost(void)
{
    each_study(check_one_lost);
}

static const TestCase tests[] = {
    {"claims on whole tables, on those of lost runs, and on tables without rows", test_whole},
    {"claims with one run lost", test_one_lost},
    {NULL, NULL},
};
CHECK_SUITE(tests)
