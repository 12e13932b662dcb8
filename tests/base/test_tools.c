/* test_tools.c: what knows neither the dimension nor the disk: numbers, names, specs, rows. */
#include <float.h>
#include <stdio.h>
#include <string.h>
#include "common/base/info.h"
#include "common/base/row.h"
#include "common/base/spec.h"
#include "studies/engine/journal.h"
#include "tests/check.h"

static void test_number_parse(void)
{
    static const char *const wrong[] = {"",   " 1",  "1 ",  "nan",   "inf",   "-inf", "0x10",
                                        "1e", "1,5", "--1", "1e999", "1.2.3", "e5",   "+"};
    double x = 7;
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++)
        CU_ASSERT(info_number_parse(wrong[k], &x) == -1 && x == 7);
    CU_ASSERT(info_number_parse("-1.5e-3", &x) == 0 && x == -1.5e-3);
    CU_ASSERT(info_number_parse("+.5", &x) == 0 && x == .5);
}

static void test_number_print(void)
{
    const double values[] = {0, .1, 1. / 3, 1e300, DBL_MIN, 4.9e-324, DBL_MAX, -2, 1e22, M_PI};
    char text[64];
    double back;
    for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
        info_number_print(values[k], text);
        CU_ASSERT(info_number_parse(text, &back) == 0 && back == values[k]);
    }
    info_number_print(.1, text);
    CHECK_TEXT(text, "0.1");
    info_number_print(.1 + .2, text);
    CHECK_TEXT(text, "0.30000000000000004");
    info_number_print(0.29999999999999999, text);
    CHECK_TEXT(text, "0.3");
    info_number_print(4.9e-324, text);
    CHECK_TEXT(text, "5e-324");
}

static void test_param(void)
{
    const Param law = {.name = "law", .choices = "linear|neo_hookean|log"};
    const Param E = {.name = "E", .min = 1, .max = 1e12};
    char takes[128], text[64];
    double x = -1;
    CU_ASSERT(info_param_parse(&law, "neo_hookean", &x, takes) == 0 && x == 1);
    CU_ASSERT(info_param_parse(&law, "lo", &x, takes) == -1);
    CHECK_TEXT(takes, "linear|neo_hookean|log");
    info_param_print(&law, 2, text);
    CHECK_TEXT(text, "log");
    CU_ASSERT(info_param_parse(&E, "1e12", &x, takes) == 0 && x == 1e12);
    CU_ASSERT(info_param_parse(&E, "0.5", &x, takes) == -1);
    CHECK_TEXT(takes, "a number in [1, 1000000000000]");
}

static void check_hint(const char *got, const char *hint)
{
    static const char *const names[] = {"bar", "ring", "squeeze", "sine_bar"};
    Fault f;
    fault_set(&f, FAULT_USAGE, "wrong");
    CU_ASSERT(fault_did_you_mean(&f, "--", got, names, 4) == FAULT_USAGE);
    CHECK_TEXT(f.text + strlen("wrong"), hint);
}

static void test_nearest_name(void)
{
    check_hint("squeze", "; did you mean '--squeeze'?");
    check_hint("rnig", "; did you mean '--ring'?");
    check_hint("sine", "; did you mean '--sine_bar'?");
    check_hint("abr", "; did you mean '--bar'?");
    check_hint("BAR", "; did you mean '--bar'?");
    check_hint("xyz", "; did you mean '--bar'?"); /* none is near: the first of equals */
    check_hint("", "");
    CU_ASSERT(fault_did_you_mean(NULL, "", "bar", NULL, 0) == FAULT_USAGE);
}

/* One number in several spellings is one word of a key; the last word, a checksum, is text. */
static void test_keys(void)
{
    static const char *const order[] = {
        "run ring --cfl 0.3 --set A=1e-1 00012345", "run ring --cfl 0.30000000000000004 1f",
        "run ring --cfl 2 --set A=0.1 1f",          "run ring --cfl 10 --set A=0.1 00012345",
        "run ring --cfl 10 --set A=1 12345",        "run ring --cfl 1o --set A=0.1 1f"};
    enum { KEYS = sizeof order / sizeof *order };
    for (int k = 0; k < KEYS; k++)
        for (int i = 0; i < KEYS; i++) {
            const int got = journal_compare_keys(order[k], order[i]);
            CU_ASSERT((got > 0) - (got < 0) == (k > i) - (k < i));
        }
    CU_ASSERT(journal_compare_keys("a 1e1 b=0.50 1f", "a 10 b=.5 1f") == 0);
    CU_ASSERT(journal_compare_keys("a 10 1e1", "a 10 10") != 0);
}

static void test_fault(void)
{
    Fault f;
    CU_ASSERT(fault_set(&f, FAULT_USAGE, "got '%s'", "a\nb") == FAULT_USAGE);
    CHECK_TEXT(f.text, "got 'a b'");
    CU_ASSERT(fault_set(NULL, FAULT_MACHINE, "x") == FAULT_MACHINE);
    CU_ASSERT(fault_set(&f, FAULT_MACHINE, "%0*d: no room", 5000, 1) == FAULT_MACHINE);
    CU_ASSERT(strlen(f.text) < sizeof f.text && strstr(f.text, "1: no room"));
    fault_set(&f, FAULT_MACHINE, "%0*d", (int)sizeof f.text - 1, 1);
    CU_ASSERT(strlen(f.text) == sizeof f.text - 1 && !strchr(f.text, '.'));
}

static void test_spec_set(void)
{
    RunSpec spec = {0};
    Fault f;
    static const char *const wrong[] = {"",      "E",    "E=",
                                        "=1",    "E 1",  "E=1 2",
                                        "E=a,b", "E=\"", "a_name_that_is_far_too_long_for_us=1"};
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
    CU_ASSERT(spec_set(&spec, "must_grow=1", &f) == FAULT_USAGE);
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
    CU_ASSERT(strncmp(text, "bar,,,,0.1,,", 12) == 0);
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
    CU_ASSERT(n == 4);
}

static const TestCase tests[] = {
    {"numbers are read strictly", test_number_parse},
    {"numbers are printed so that they read back the same", test_number_print},
    {"parameters: ranges and words", test_param},
    {"nearest name", test_nearest_name},
    {"keys", test_keys},
    {"a fault is one line", test_fault},
    {"settings", test_spec_set},
    {"settings: room", test_spec_full},
    {"a run's command is its key", test_spec_command},
    {"the longest command fits", test_spec_longest},
    {"rows split at their commas", test_row},
    {"the longest row fits", test_row_longest},
    {"timing columns", test_row_timing},
    {NULL, NULL},
};
CHECK_SUITE(tests)
