/* test_tools.c: what does not know the dimension: numbers, names, specs, rows, tables, journals. */
#define _GNU_SOURCE
#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "../common/info.h"
#include "../common/row.h"
#include "../common/spec.h"
#include "../common/table.h"
#include "../studies/journal.h"
#include "../studies/study.h"
#include "check.h"

/* A path in a folder of our own below the build folder (the working folder of the tests). */
static const char *scratch(const char *name)
{
    static char path[128];
    mkdir("scratch", 0777);
    snprintf(path, sizeof path, "scratch/%s.%d", name, (int)getpid());
    unlink(path);
    return path;
}

static void put_file(const char *path, const char *text)
{
    FILE *f = fopen(path, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    fputs(text, f);
    CU_ASSERT(fclose(f) == 0);
}

static void test_number_parse(void)
{
    static const char *const wrong[] = {"",  " 1",  "1 ", "nan", "inf",  "-inf", "0x10",
                                        "1e", "1,5", "--1", "1e999", "1.2.3", "e5", "+"};
    double x = 7;
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++)
        CU_ASSERT(number_parse(wrong[k], &x) == -1 && x == 7);
    CU_ASSERT(number_parse("-1.5e-3", &x) == 0 && x == -1.5e-3);
    CU_ASSERT(number_parse("+.5", &x) == 0 && x == .5);
}

static void test_number_print(void)
{
    const double values[] = {0, .1, 1. / 3, 1e300, DBL_MIN, 4.9e-324, DBL_MAX, -2, 1e22, M_PI};
    char text[64];
    double back;
    for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
        number_print(values[k], text);
        CU_ASSERT(number_parse(text, &back) == 0 && back == values[k]);
    }
    number_print(.1, text);
    CHECK_TEXT(text, "0.1");
    number_print(.1 + .2, text);
    CHECK_TEXT(text, "0.30000000000000004");
}

static void test_param(void)
{
    const Param law = {.name = "law", .choices = "linear|neo_hookean|log"};
    const Param E = {.name = "E", .min = 1, .max = 1e12};
    char takes[128], text[64];
    double x = -1;
    CU_ASSERT(param_parse(&law, "neo_hookean", &x, takes) == 0 && x == 1);
    CU_ASSERT(param_parse(&law, "lo", &x, takes) == -1);
    CHECK_TEXT(takes, "linear|neo_hookean|log");
    param_print(&law, 2, text);
    CHECK_TEXT(text, "log");
    CU_ASSERT(param_parse(&E, "1e12", &x, takes) == 0 && x == 1e12);
    CU_ASSERT(param_parse(&E, "0.5", &x, takes) == -1);
    CHECK_TEXT(takes, "a number in [1, 1000000000000]");
}

static void test_nearest_name(void)
{
    static const char *const names[] = {"bar", "ring", "squeeze", "sine_bar"};
    CHECK_TEXT(nearest_name("squeze", names, 4), "squeeze");
    CHECK_TEXT(nearest_name("rnig", names, 4), "ring");
    CHECK_TEXT(nearest_name("sine", names, 4), "sine_bar");
    CHECK_TEXT(nearest_name("", names, 4), "bar");
    CU_ASSERT_PTR_NULL(nearest_name("bar", names, 0));
}

static void test_fault(void)
{
    Fault f;
    CU_ASSERT(fault_set(&f, FAULT_USAGE, "got '%s'", "a\nb") == FAULT_USAGE);
    CHECK_TEXT(f.text, "got 'a b'");
    CU_ASSERT(fault_set(NULL, FAULT_MACHINE, "x") == FAULT_MACHINE);
}

static void test_spec_set(void)
{
    RunSpec spec = {0};
    Fault f;
    static const char *const wrong[] = {"", "E", "E=", "=1", "E 1", "E=1 2", "E=a,b", "E=\"",
                                        "a_name_that_is_far_too_long_for_us=1"};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++)
        CU_ASSERT(spec_set(&spec, wrong[k], &f) == FAULT_USAGE);
    CU_ASSERT(spec.nset == 0);
    CU_ASSERT(spec_set(&spec, "E=1", &f) == 0 && spec_set(&spec, "E=2", &f) == 0);
    CU_ASSERT(spec.nset == 1);
    CHECK_TEXT(spec_get(&spec, "E"), "2");
    CU_ASSERT_PTR_NULL(spec_get(&spec, "nu"));
}

static void test_spec_full(void)
{
    RunSpec spec = {0};
    Fault f;
    char text[64];
    for (int k = 0; k < SPEC_SETS; k++) {
        snprintf(text, sizeof text, "name%d=%d", k, k);
        CU_ASSERT(spec_set(&spec, text, &f) == 0);
    }
    CU_ASSERT(spec_set(&spec, "one_more=1", &f) == FAULT_USAGE);
    CU_ASSERT(spec_set(&spec, "name3=5", &f) == 0);
}

static void test_spec_command(void)
{
    RunSpec a = {.problem = "bar", .method = "gimp", .cells = 40, .ppc = 2.5, .cfl = .1}, b;
    char x[SPEC_TEXT], y[SPEC_TEXT];
    b = a;
    spec_set(&a, "nu=.3", NULL);
    spec_set(&a, "E=1", NULL);
    spec_set(&b, "E=1", NULL);
    spec_set(&b, "nu=.3", NULL);
    a.history = "file";
    a.threads = 1;
    spec_command(&a, x);
    spec_command(&b, y);
    CHECK_TEXT(x, y);
    CHECK_TEXT(x, "run bar --method gimp --cells 40 --ppc 2.5 --cfl 0.1 --set E=1 --set nu=.3");
}

static void test_spec_longest(void)
{
    RunSpec spec = {0};
    char out[SPEC_TEXT], text[80];
    memset(spec.problem, 'p', sizeof spec.problem - 1);
    memset(spec.method, 'm', sizeof spec.method - 1);
    memset(spec.integrator, 'i', sizeof spec.integrator - 1);
    spec.cells = spec.ppc = spec.cfl = spec.t_end = 1. / 3;
    for (int k = 0; k < SPEC_SETS; k++) {
        snprintf(text, sizeof text, "%031d=%031d", k, k);
        CU_ASSERT(spec_set(&spec, text, NULL) == 0);
    }
    spec_command(&spec, out);
    CU_ASSERT(strlen(out) < SPEC_TEXT - 1);
    CU_ASSERT(out[strlen(out) - 1] == '1'); /* the last setting is whole: ...31 */
}

static int commas(const char *text)
{
    int n = 0;
    for (; *text; text++) n += *text == ',';
    return n;
}

static void test_row(void)
{
    Row row = row_empty();
    char text[ROW_TEXT], header[ROW_TEXT];
    CU_ASSERT(row_print(&row, text) == row_columns() - 1); /* nothing but commas */
    CU_ASSERT(row_header(header) == (int)strlen(header));
    CU_ASSERT(commas(header) == row_columns() - 1);
    strcpy(row.problem, "bar");
    strcpy(row.reason, "a, \"b\"\nc");
    row.h = .1;
    CU_ASSERT(row_print(&row, text) == (int)strlen(text));
    CU_ASSERT(strncmp(text, "bar,,,,0.10000000000000001,,", 28) == 0);
    CU_ASSERT(commas(text) == row_columns() - 1);
    CU_ASSERT_PTR_NOT_NULL(strstr(text, ",a;  b  c,"));
}

static void test_row_longest(void)
{
    Row row = row_empty();
    char text[ROW_TEXT];
    memset(row.params, 'x', sizeof row.params - 1);
    memset(row.reason, 'y', sizeof row.reason - 1);
    row.cells = row.error_l1 = -1. / 3e300;
    CU_ASSERT(row_print(&row, text) < ROW_TEXT - 20 * 24);
}

static void test_row_timing(void)
{
    int n = 0;
    for (int k = 0; k < row_columns(); k++) n += row_column_is_timing(k) != 0;
    CU_ASSERT(n == 3);
}

static void test_csv_round_trip(void)
{
    static const char *const cells[] = {"plain", "a,b", "say \"hi\"", "two\nlines", "", "\""};
    const char *path = scratch("csv");
    Fault f;
    FILE *out = file_begin(path, &f);
    CU_ASSERT_PTR_NOT_NULL_FATAL(out);
    fputs("number,text\n", out);
    for (int k = 0; k < 6; k++) {
        fprintf(out, "%d,", k);
        csv_cell(out, cells[k]);
        putc('\n', out);
    }
    CU_ASSERT(file_commit(out, path, &f) == 0);
    Table *t = table_read(path, &f);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    CU_ASSERT(t->ncol == 2 && t->nrow == 6);
    for (int k = 0; k < t->nrow; k++) {
        CHECK_TEXT(table_text(t, k, "text"), cells[k]);
        CU_ASSERT(table_number(t, k, "number") == k);
    }
    CU_ASSERT(isnan(table_number(t, 0, "text")) && isnan(table_number(t, 0, "absent")));
    CU_ASSERT(table_column(t, "absent") == -1);
    table_free(t);
    unlink(path);
}

static void test_csv_damaged(void)
{
    static const char *const wrong[] = {"", "\n1\n", "a,b\n1\n", "a,b\n1,2,3\n", "a,b\n1,\"2\n",
                                        "a,b\n1,\"2\"3\n", "a\n1\n2,3\n"};
    const char *path = scratch("damaged");
    Fault f;
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        put_file(path, wrong[k]);
        Table *t = table_read(path, &f);
        CU_ASSERT(k == 1 ? t != NULL : t == NULL && f.code == FAULT_MACHINE);
        table_free(t);
    }
    put_file(path, "a,b\r\n1,2\r\n3,4"); /* foreign line ends, and none at the last */
    Table *t = table_read(path, &f);
    CU_ASSERT(t && t->nrow == 2 && table_number(t, 1, "b") == 4);
    table_free(t);
    unlink(path);
    CU_ASSERT_PTR_NULL(table_read(path, &f));
}

static void test_file_commit(void)
{
    char path[128];
    struct stat before, after;
    Fault f;
    snprintf(path, sizeof path, "%s", scratch("whole"));
    put_file(path, "old");
    CU_ASSERT(stat(path, &before) == 0);
    FILE *out = file_begin(path, &f);
    CU_ASSERT_PTR_NOT_NULL_FATAL(out);
    fputs("new", out);
    fflush(out);
    CU_ASSERT(stat(path, &after) == 0 && after.st_size == 3 && after.st_ino == before.st_ino);
    file_abandon(out, path);
    out = file_begin(path, &f);
    fputs("old", out);
    CU_ASSERT(file_commit(out, path, &f) == 0);
    CU_ASSERT(stat(path, &after) == 0 && after.st_ino == before.st_ino); /* same bytes: kept */
    out = file_begin(path, &f);
    fputs("newer", out);
    CU_ASSERT(file_commit(out, path, &f) == 0);
    CU_ASSERT(stat(path, &after) == 0 && after.st_size == 5);
    unlink(path);
    CU_ASSERT_PTR_NULL(file_begin("/nowhere/at/all", &f));
    CU_ASSERT(f.code == FAULT_MACHINE && strstr(f.text, "/nowhere/at/all"));
}

static void test_order_fit(void)
{
    double x[9], y[9], err;
    for (int k = 0; k < 9; k++) {
        x[k] = k + 1;
        y[k] = 3 * pow(x[k], -2.5);
    }
    CHECK_CLOSE(order_fit(9, x, y, &err), -2.5, 1e-12);
    CU_ASSERT(err < 1e-6);
    y[3] = NAN;
    y[4] = 0;
    x[5] = -1;
    CHECK_CLOSE(order_fit(9, x, y, NULL), -2.5, 1e-12);
    CU_ASSERT(isnan(order_fit(1, x, y, NULL)) && isnan(order_fit(0, x, y, NULL)));
}

static void test_rows_pick(void)
{
    const char *path = scratch("pick"), *const where[] = {"method=gimp", "cells=40"};
    double out[4];
    put_file(path, "method,cells,e\ngimp,40,1\nmpm,40,2\ngimp,4e1,3\ngimp,80,4\n");
    Table *t = table_read(path, NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    CU_ASSERT(rows_pick(t, 2, where, "e", 4, out) == 2 && out[0] == 1 && out[1] == 3);
    CU_ASSERT(rows_pick(t, 2, where, "e", 1, out) == 1);
    CU_ASSERT(rows_pick(t, 0, NULL, "e", 4, out) == 4);
    const char *const absent[] = {"colour="};
    CU_ASSERT(rows_pick(t, 1, absent, "e", 4, out) == 0);
    table_free(t);
    unlink(path);
}

static void journal_of(const char *path, int n)
{
    Journal j;
    CU_ASSERT_FATAL(journal_open(&j, path, NULL) == 0);
    for (int k = 0; k < n; k++) {
        char key[32], row[32];
        snprintf(key, sizeof key, "key %d", k);
        snprintf(row, sizeof row, "row,%d", k);
        CU_ASSERT(journal_append(j.fd, key, row) == 0);
    }
    journal_close(&j);
}

static void test_journal(void)
{
    const char *path = scratch("journal");
    Journal j;
    journal_of(path, 5);
    CU_ASSERT_FATAL(journal_open(&j, path, NULL) == 0);
    CU_ASSERT(j.n == 5);
    CHECK_TEXT(journal_row(&j, "key 3"), "row,3");
    CU_ASSERT_PTR_NULL(journal_row(&j, "key"));
    CU_ASSERT(journal_append(j.fd, "key 3", "row,again") == 0);
    CU_ASSERT(journal_reload(&j, path, NULL) == 0 && j.n == 5); /* none doubled, the newest kept */
    CHECK_TEXT(journal_row(&j, "key 3"), "row,again");
    journal_close(&j);
    unlink(path);
}

/* Cuts the tail at every byte: the whole records before it stay, and the next one does not glue. */
static void test_journal_torn_tail(void)
{
    const char *path = scratch("torn");
    Journal j;
    struct stat s;
    journal_of(path, 3);
    CU_ASSERT_FATAL(stat(path, &s) == 0);
    const off_t record = s.st_size / 3;
    for (off_t cut = 1; cut < record; cut++) {
        journal_of(path, 3);
        CU_ASSERT(truncate(path, s.st_size - cut) == 0);
        CU_ASSERT_FATAL(journal_open(&j, path, NULL) == 0);
        CU_ASSERT(j.n == 2 && journal_row(&j, "key 1") && !journal_row(&j, "key 2"));
        CU_ASSERT(journal_append(j.fd, "key 2", "row,2") == 0);
        CU_ASSERT(journal_reload(&j, path, NULL) == 0 && j.n == 3);
        journal_close(&j);
        unlink(path);
    }
}

/* Any byte of the middle record damaged or lost: only that record goes. */
static void test_journal_torn_middle(void)
{
    const char *path = scratch("middle");
    char text[256] = "";
    Journal j;
    journal_of(path, 3);
    FILE *f = fopen(path, "r");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    const size_t n = fread(text, 1, sizeof text - 1, f), record = n / 3;
    fclose(f);
    for (size_t at = record; at < 2 * record; at++)
        for (int lost = 0; lost < 2; lost++) {
            char damaged[256];
            memcpy(damaged, text, sizeof damaged);
            damaged[at] = '~';
            if (lost) memmove(damaged + at, text + at + 1, n - at);
            put_file(path, damaged);
            CU_ASSERT_FATAL(journal_open(&j, path, NULL) == 0);
            CU_ASSERT(j.n == 2 && journal_row(&j, "key 0") && journal_row(&j, "key 2"));
            journal_close(&j);
        }
    unlink(path);
}

static const TestCase tools_tests[] = {
    {"numbers are read strictly", test_number_parse},
    {"numbers are printed so that they read back the same", test_number_print},
    {"parameters: ranges and words", test_param},
    {"nearest name", test_nearest_name},
    {"a fault is one line", test_fault},
    {"settings", test_spec_set},
    {"settings: room", test_spec_full},
    {"a run's command is its key", test_spec_command},
    {"the longest command fits", test_spec_longest},
    {"rows split at their commas", test_row},
    {"the longest row fits", test_row_longest},
    {"timing columns", test_row_timing},
    {"CSV round trip", test_csv_round_trip},
    {"CSV damaged", test_csv_damaged},
    {"files appear whole", test_file_commit},
    {"order fit", test_order_fit},
    {"rows picked", test_rows_pick},
    {"journal", test_journal},
    {"journal with a torn tail", test_journal_torn_tail},
    {"journal torn in the middle", test_journal_torn_middle},
    {NULL, NULL},
};

int main(void) { return check_run("tools", tools_tests); }
