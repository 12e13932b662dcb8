/* check.c: the one place that talks to CUnit. */
#include "check.h"

static int add_suite(const TestSuite *suite)
{
    CU_pSuite s = CU_add_suite(suite->name, NULL, NULL);
    for (const TestCase *t = suite->tests; s && t->name; t++)
        if (!CU_add_test(s, t->name, t->run)) return 0;
    return s != NULL;
}

int check_run(const TestSuite *suites)
{
    int ready = CU_initialize_registry() == CUE_SUCCESS;
    for (; ready && suites->name; suites++) ready = add_suite(suites);
    if (ready) CU_basic_run_tests();
    int failed = !ready || CU_get_number_of_failures() > 0;
    CU_cleanup_registry();
    return failed;
}
