/* check.c: the one place that talks to CUnit. */
#include "check.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Is the test to be run: is the value of ONLY a part of "suite: test"? */
static int is_chosen(const TestSuite *suite, const TestCase *test)
{
    const char *only = getenv("ONLY");
    char name[256];
    snprintf(name, sizeof name, "%s: %s", suite->name, test->name);
    return !only || strstr(name, only);
}

static int add_suite(const TestSuite *suite)
{
    CU_pSuite s = NULL;
    for (const TestCase *t = suite->tests; t->name; t++) {
        if (!is_chosen(suite, t)) continue;
        if (!s && !(s = CU_add_suite(suite->name, NULL, NULL))) return 0;
        if (!CU_add_test(s, t->name, t->run)) return 0;
    }
    return 1;
}

int check_run(const TestSuite *suites)
{
    int ready = CU_initialize_registry() == CUE_SUCCESS;
    for (; ready && suites->name; suites++) ready = add_suite(suites);
    if (ready) CU_basic_run_tests();
    int failed = !ready || CU_get_number_of_failures() > 0;
    const int nothing = ready && CU_get_number_of_tests_run() == 0;
    CU_cleanup_registry();
    return nothing ? 2 : failed;
}
