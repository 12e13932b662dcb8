/* check.c: the main of every test program, and the one place that talks to CUnit. */
#include "check.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#undef CU_assertImplementation

static char context[512];

void check_context(int dim, const char *scene, const char *method, const char *integrator,
                   const char *settings)
{
    snprintf(context, sizeof context, " [%dD: scene %s, method %s, integrator %s%s%s]", dim,
             scene ? scene : "of the test", method && *method ? method : "default",
             integrator && *integrator ? integrator : "default", settings ? ", " : "",
             settings ? settings : "");
}

void check_context_of(int dim, const RunSpec *spec)
{
    char settings[256];
    int n = snprintf(settings, sizeof settings, "cells %g, ppc %g", spec->cells, spec->ppc);
    for (int k = 0; k < spec->nset && n < (int)sizeof settings; k++)
        n += snprintf(settings + n, sizeof settings - (size_t)n, ", %s=%s", spec->set[k].name,
                      spec->set[k].value);
    check_context(dim, spec->problem, spec->method, spec->integrator, settings);
}

static void clear_context(void)
{
    context[0] = 0;
}

CU_BOOL check_assert(CU_BOOL holds, unsigned line, const char *condition, const char *file,
                     const char *function, CU_BOOL fatal)
{
    char text[2048];
    snprintf(text, sizeof text, "%s%s", condition, context);
    return (CU_assertImplementation)(holds, line, text, file, function, fatal);
}

/* ---- suites */

enum { MOST_SUITES = 64 };

static struct Suite {
    char name[64];
    const TestCase *tests;
} suites[MOST_SUITES];
static int suite_count;

/* NAME of .../test_NAME.c */
void check_add(const char *file, const TestCase *tests)
{
    const char *slash = strrchr(file, '/'), *name = slash ? slash + 1 : file;
    if (strncmp(name, "test_", 5) == 0) name += 5;
    if (suite_count == MOST_SUITES) abort();
    struct Suite *s = &suites[suite_count++];
    snprintf(s->name, sizeof s->name, "%.*s", (int)strcspn(name, "."), name);
    s->tests = tests;
}

/* Is the test to be run: is the value of ONLY a part of "suite: test"? */
static int is_chosen(const struct Suite *suite, const TestCase *test)
{
    const char *only = getenv("ONLY");
    char name[256];
    snprintf(name, sizeof name, "%.63s: %s", suite->name, test->name);
    return !only || strstr(name, only);
}

static int enter(const struct Suite *suite)
{
    CU_pSuite s = NULL;
    for (const TestCase *t = suite->tests; t->name; t++) {
        if (!is_chosen(suite, t)) continue;
        if (!s && !(s = CU_add_suite_with_setup_and_teardown(suite->name, NULL, NULL, clear_context,
                                                             NULL)))
            return 0;
        if (!CU_add_test(s, t->name, t->run)) return 0;
    }
    return 1;
}

int main(void)
{
    int ready = CU_initialize_registry() == CUE_SUCCESS;
    for (int k = 0; ready && k < suite_count; k++) ready = enter(&suites[k]);
    if (ready) CU_basic_run_tests();
    const int failed = !ready || CU_get_number_of_failures() > 0;
    const int nothing = ready && CU_get_number_of_tests_run() == 0;
    CU_cleanup_registry();
    return nothing ? 2 : failed;
}

Table *check_table(const char *text)
{
    static const char path[] = "scratch/check.csv";
    mkdir("scratch", 0777);
    FILE *f = fopen(path, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    fputs(text, f);
    fclose(f);
    Table *t = table_read(path, NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    unlink(path);
    return t;
}
