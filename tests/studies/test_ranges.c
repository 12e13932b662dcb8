/* test_ranges.c: every claim's range can fail. A study's tables are made from sound numbers, then
 * from others: those of rows a thousand times as large or as small, all runs lost, the numbers of
 * the runs' files or of the page's own tables changed. With one of these each claim must have its
 * number, and that outside its range. */
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "common/base/info.h"
#include "studies/engine/claims.h"
#include "studies/engine/results.h"
#include "studies/select.h"
#include "tests/check.h"
#include "trial.h"
#include "trial_case.h"

static const char dir[] = "scratch/ranges";

/* Formulas of the program itself: in no table. */
static const char *const formulas[] = {"W11-2.masks", "W11-2.smooth",   "W11-3.circular",
                                       "T-9.cases",   "T-9.complement", NULL};

/* Columns by which rows are chosen; x and y only where there is no X. */
static const char *const keys[] = {
    "t",       "id",      "cell",   "k",        "x",         "y",       "X",       "Y",
    "r",       "angle",   "cells",  "ppc",      "cfl",       "dim",     "column",  "row",
    "station", "norm",    "depth",  "place",    "amplitude", "refresh", "default", "pair",
    "line",    "runs",    "meshes", "mass",     "case",      "grading", "nodes",   "at",
    "periods", "step",    "nu",     "offset_x", "target",    "weight",  "Fyy",     "pixels",
    "fill",    "trigger", "ratio",  "jitter",   "strain",    "Z",       NULL};

enum { MOST_COLUMNS = 64 };

/* How a number of a table changes: times a factor, times 10 to a power of the file's own and to one
 * of the number's own, both between -scatter and scatter; then more is added. */
typedef struct Change {
    double factor, scatter, more;
} Change;

/* 10^-scatter to 10^scatter, the same for the same k. */
static double scattered(double scatter, int k)
{
    return pow(10, scatter * (2 * spread(k) - 1));
}

static bool is_key(const Table *t, const char *name)
{
    const bool position = strcmp(name, "x") == 0 || strcmp(name, "y") == 0;
    return trial_is_one(name, keys) && !(position && table_column(t, "X") >= 0);
}

/* Rewrites a table: numbers of all columns but the keys. */
static void change_table(const char *path, const Change *by)
{
    Table *t = table_read(path, NULL);
    CU_ASSERT_FATAL(t && t->ncol <= MOST_COLUMNS);
    FILE *f = fopen(path, "w");
    bool key[MOST_COLUMNS];
    int name = 0;
    for (const char *p = path; *p; p++) name += *p * (int)(p - path);
    const double factor = by->factor * scattered(by->scatter, name);
    for (int c = 0; c < t->ncol; c++) key[c] = is_key(t, t->name[c]);
    for (int row = -1; f && row < t->nrow; row++)
        for (int c = 0; c < t->ncol; c++) {
            double x;
            const int cell = row * t->ncol + c;
            const char *text = row < 0 ? t->name[c] : t->cell[cell];
            if (row >= 0 && !key[c] && info_number_parse(text, &x) == 0)
                fprintf(f, "%.6g", x * factor * scattered(by->scatter, cell) + by->more);
            else
                table_put_cell(f, text);
            putc(c + 1 < t->ncol ? ',' : '\n', f);
        }
    if (f) fclose(f);
    table_free(t);
}

typedef struct Trial {
    const Study *study;
    Cases cases;
    unsigned *seen; /* verdicts [study->page->claims], a bit each */
} Trial;

static void judge(Trial *t, bool tables)
{
    Check c = {0};
    Fault fault = {0};
    if (tables && t->study->page->tables) results_tables(t->study, dir, false, &fault);
    CU_ASSERT_FATAL(claims_judge_study(&c, t->study, dir, &fault) == 0 &&
                    c.n == t->study->page->claims);
    for (int k = 0; k < c.n; k++)
        if (c.list[k].judged) t->seen[k] |= 1U << c.list[k].verdict;
    free(c.list);
}

/* All tables beside that of the runs. */
static void change_files(const Study *study, const Change *by)
{
    char path[TRIAL_PATH], rows[TRIAL_PATH];
    snprintf(rows, sizeof rows, "%s.csv", study->page->cases ? study->name : "");
    DIR *d = opendir(dir);
    for (struct dirent *e; d && (e = readdir(d));) {
        snprintf(path, sizeof path, "%s/%.200s", dir, e->d_name);
        if (strstr(e->d_name, ".csv") && strcmp(e->d_name, rows) != 0) change_table(path, by);
    }
    if (d) closedir(d);
}

/* Did the claim fail in some trial, or pass in one and differ in another? */
static bool can_fail(unsigned seen)
{
    const unsigned both = 1U << PASS | 1U << DIFFERS;
    return seen & 1U << FAIL || (seen & both) == both;
}

static bool all_can_fail(const Trial *t)
{
    int n = 0;
    while (n < t->study->page->claims && can_fail(t->seen[n])) n++;
    return n == t->study->page->claims;
}

/* Graded methods were run, and no note says nan or inf. */
static void check_grades(const Study *study)
{
    Table *rows = table_read_part(dir, study->name, NULL, NULL);
    Table *grades = table_read_part(dir, study->name, "grades", NULL);
    for (int k = 0; rows && grades && k < grades->nrow; k++) {
        const char *method = table_text(grades, k, "method"), *note = table_text(grades, k, "note");
        const bool ran = select_next(rows, -1, "method=%s", method) >= 0;
        const bool wrong = !ran || strstr(note, "nan") || strstr(note, "inf ");
        if (wrong) printf("%s: grade of %s: %s\n", study->name, method, note);
        CU_ASSERT(!wrong);
    }
    table_free(rows);
    table_free(grades);
}

/* Changes the rows of the runs; then, one change upon the other, their files, and judges before and
 * after the page's tables are made of them. Stops when every claim can fail. */
static void try_all(Trial *t)
{
    static const Change changes[] = {{1, 3, 0}, {-1e3, 0, 1}, {1, 0, -1e9}};
    static const Spoiled rows[] = {LOST_RUN, LARGER, SMALLER, UNEVEN, UNEVEN_TOO, SOUND};
    trial_clear(dir);
    trial_files(&t->cases);
    for (size_t k = 0; k < sizeof rows / sizeof *rows && !all_can_fail(t); k++) {
        trial_rows(t->study, &t->cases, dir, rows[k]);
        judge(t, true);
        if (rows[k] == LOST_RUN) check_grades(t->study);
    }
    for (size_t k = 0; k < sizeof changes / sizeof *changes && !all_can_fail(t); k++) {
        change_files(t->study, &changes[k]);
        judge(t, false);
        if (t->study->page->tables) judge(t, true);
    }
}

static void test_ranges(void)
{
    mkdir("scratch", 0777);
    mkdir(dir, 0777);
    for (const Study *s = studies; s->name; s++) {
        Trial t = {.study = s, .seen = calloc((size_t)s->page->claims + 1, sizeof(unsigned))};
        CU_ASSERT_FATAL(t.seen && cases_build(&t.cases, s, false, NULL, dir, NULL) == 0);
        if (s->page->check && s->page->claims > 0) try_all(&t);
        Check c = {0};
        if (s->page->check) claims_judge_study(&c, s, dir, NULL);
        for (int k = 0; k < c.n; k++) {
            const bool wrong = !can_fail(t.seen[k]) && !trial_is_one(c.list[k].id, formulas);
            if (wrong) printf("%s: no change makes it fail\n", c.list[k].id);
            CU_ASSERT(!wrong);
        }
        free(c.list);
        free(t.seen);
        cases_free(&t.cases);
    }
    trial_clear(dir);
}

static const TestCase tests[] = {
    {"a changed number fails each claim", test_ranges},
    {NULL, NULL},
};
CHECK_SUITE(tests)
