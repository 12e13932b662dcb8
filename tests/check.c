/* check.c: the one place that talks to CUnit. */
#include "check.h"

int check_run(const char *suite, const TestCase *tests)
{
    CU_pSuite s = CU_initialize_registry() == CUE_SUCCESS ? CU_add_suite(suite, NULL, NULL) : NULL;
    for (; s && tests->name; tests++)
        if (!CU_add_test(s, tests->name, tests->run)) s = NULL;
    if (s) CU_basic_run_tests();
    int failed = !s || CU_get_number_of_failures() > 0;
    CU_cleanup_registry();
    return failed;
}
