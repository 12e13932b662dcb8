/* test_trial.c: no claim holds on nothing. Every study's claims are judged on tables that are
 * whole, header-only, of lost runs, with one run lost, and with a table missing. No number matters
 * here: a claim is `judged` if all its rows were there, whatever its range. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "../studies/claims.h"
#include "check.h"
#include "trial.h"

static const char dir[] = "scratch/trial";

/* Of formulas alone: they need no run. */
static const char *const formulas[] = {"W07-2.",        "W11-2.",           "H5.tent-omega",
                                       "H5.gimp-omega", "H5.bspline-omega", NULL};
/* About runs that are lost, or about where runs start to be: a lost run is their number. */
static const char *const about_losses[] = {
    "W07-12.mpm-lost",
    "W07-12.gimp-lost",
    "W07-12.ge-gimp-lost",
    "W07-12.ge-mpm-unstable",
    "W07-12.low-ppc",
    "W11-10.whole",
    "T-1b.lost",
    "T-1.literal",
    "T-4.",
    "T-5.stale",
    "T-5.plane-gimp",
    "T-5.plane-stale",
    "H2.wls",
    "H5.",
    "H7.",
    "H8a.growth-all",
    "H8b.stretch",
    "H8b.exponential",
    "H10.defined",
    "H13.",
    "H-15.",
    "T-2.", /* the best of many runs: lost ones are none of them */
    NULL};
/* Those of them that hold if all runs are lost: so many must be. */
static const char *const all_lost[] = {"T-1.literal",
                                       "T-5.stale",
                                       "T-5.plane-stale",
                                       "H7.wls",
                                       "H-15.vortex-gimp",
                                       "H-15.bar-gimp",
                                       "W07-12.ge-mpm-unstable",
                                       "T-4.stale",
                                       NULL};

static bool is_one(const char *id, const char *const list[])
{
    for (; *list; list++)
        if (strncmp(id, *list, strlen(*list)) == 0) return true;
    return false;
}

typedef struct Trial {
    const Study *study;
    Cases cases;
    Check whole; /* on sound tables */
} Trial;

static void complain(const Claim *c, const char *what)
{
    printf("%s: %s: %s, %.6g on %d rows: %s\n", c->id, what, verdict_name(c->verdict), c->measured,
           c->rows, c->reason);
}

static Check judge(const Trial *t, bool again)
{
    Check c = {0};
    Fault fault = {0};
    if (again && t->study->tables) t->study->tables(dir, false, &fault);
    if (check_study(&c, t->study, dir, &fault)) {
        printf("%s: %s\n", t->study->name, fault.text);
        CU_FAIL("claims are not made");
    }
    CU_ASSERT(c.n == t->study->claims);
    return c;
}

static void make(Trial *t)
{
    trial_clear(dir);
    trial_rows(t->study, &t->cases, dir, -2, SOUND);
    trial_files(&t->cases);
}

static void check_whole(Trial *t)
{
    make(t);
    t->whole = judge(t, true);
    for (const Claim *c = t->whole.list; c < t->whole.list + t->whole.n; c++) {
        if (!c->judged) complain(c, "on whole tables");
        CU_ASSERT(c->judged);
    }
}

/* Fails for each claim that is judged but in none of the lists, and for each that passes but is in
 * neither of the last two. */
static void expect_none(const Check *check, const char *what, const char *const may_be_judged[],
                        const char *const may_pass[])
{
    for (const Claim *c = check->list; c < check->list + check->n; c++) {
        const bool judged = c->judged && !is_one(c->id, formulas) && !is_one(c->id, may_be_judged);
        const bool passes =
            c->verdict == PASS && !is_one(c->id, formulas) && !is_one(c->id, may_pass);
        if (judged || passes) complain(c, what);
        CU_ASSERT(!judged && !passes);
    }
    free(check->list);
}

static const char *const nothing[] = {NULL};

static void check_empty(Trial *t)
{
    Check c;
    make(t);
    if (t->study->tables) t->study->tables(dir, false, NULL);
    trial_empty(dir);
    c = judge(t, false);
    for (int k = 0; k < c.n; k++)
        CU_ASSERT(!c.list[k].judged || is_one(c.list[k].id, formulas + 1));
    expect_none(&c, "on tables without rows", nothing, nothing);
    c = judge(t, true);
    expect_none(&c, "on runs without rows", nothing, nothing);
}

static void check_all_lost(Trial *t)
{
    make(t);
    trial_rows(t->study, &t->cases, dir, -1, LOST_RUN);
    Check c = judge(t, true);
    expect_none(&c, "with all runs lost", about_losses, all_lost);
}

static bool is_same(const Claim *a, const Claim *b)
{
    return a->rows == b->rows &&
           (a->measured == b->measured || (isnan(a->measured) && isnan(b->measured)));
}

static void spoil(const Trial *t, int row, Spoiled how, bool stands[])
{
    const char *file = t->cases.list[row].file;
    char aside[TRIAL_PATH];
    trial_rows(t->study, &t->cases, dir, row, how);
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
        const bool wrong = stands[k] && one->judged && !is_one(one->id, about_losses);
        if (wrong) {
            complain(one, "with one run lost");
            printf("  %s\n", t->cases.list[row].command);
        }
        CU_ASSERT(!wrong);
    }
    free(c.list);
}

/* A claim stands on a row if it changes with the row's numbers, or without the row. */
static void check_one_lost(Trial *t)
{
    enum { TRIED = 4 };
    const int n = t->cases.n, apart = n > TRIED ? n / TRIED : 1;
    make(t);
    for (int row = 0; row < n; row += apart) {
        bool *stands = calloc((size_t)t->whole.n + 1, sizeof *stands);
        CU_ASSERT_PTR_NOT_NULL_FATAL(stands);
        spoil(t, row, LARGER, stands);
        spoil(t, row, SMALLER, stands);
        spoil(t, row, ABSENT, stands);
        spoil(t, row, LOST_RUN, stands);
        free(stands);
    }
}

static void each_study(void (*act)(Trial *t), bool whole)
{
    mkdir("scratch", 0777);
    mkdir(dir, 0777);
    for (const Study *const *s = studies; *s; s++) {
        Trial t = {.study = *s};
        if (!(*s)->check || (*s)->claims == 0) continue;
        CU_ASSERT_FATAL(cases_build(&t.cases, *s, false, NULL, dir, NULL) == 0);
        if (whole) check_whole(&t);
        act(&t);
        free(t.whole.list);
        cases_free(&t.cases);
    }
    trial_clear(dir);
}

static void test_whole(void)
{
    each_study(check_empty, true);
}

static void test_all_lost(void)
{
    each_study(check_all_lost, false);
}

static void test_one_lost(void)
{
    each_study(check_one_lost, true);
}

const TestCase trial_tests[] = {
    {"claims on whole tables and on tables without rows", test_whole},
    {"claims on lost runs", test_all_lost},
    {"claims with one run lost", test_one_lost},
    {NULL, NULL},
};
