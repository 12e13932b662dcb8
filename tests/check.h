/* check.h: tests as tables of functions, a suite per file. test_NAME.c ends with
 *   static void test_x(void) { CU_ASSERT(...); }
 *   static const TestCase tests[] = {{"what holds", test_x}, {NULL, NULL}};
 *   CHECK_SUITE(tests)
 * and stands in tests.def with the programs that it is linked into; each ends with CUnit's summary.
 */
#ifndef MPMLAB_CHECK_H
#define MPMLAB_CHECK_H

#include <CUnit/Basic.h>
#include <math.h>
#include "common/base/spec.h"
#include "common/base/table.h"

typedef struct TestCase {
    const char *name;
    void (*run)(void);
} TestCase;

/* Adds the tests of this file to the program, as suite NAME. Only those are run whose "NAME: test"
 * contains the environment's ONLY. The exit status of the program: 0, 1 if anything failed, 2 if no
 * test was run. */
#define CHECK_SUITE(tests)                                                                         \
    static void __attribute__((constructor)) check_this_file(void)                                 \
    {                                                                                              \
        check_add(__FILE__, tests);                                                                \
    }
void check_add(const char *file, const TestCase *tests);

/* What the assertions that follow are about; a failure names it. Until the next call or test. NULL:
 * unknown, or its default. Fixtures call it for every run they set up. */
void check_context(int dim, const char *scene, const char *method, const char *integrator,
                   const char *settings);

/* The same for a run that is given as a spec. */
void check_context_of(int dim, const RunSpec *spec);

/* Assertions of CUnit go through check_assert, which adds the context to what they print. */
CU_BOOL check_assert(CU_BOOL holds, unsigned line, const char *condition, const char *file,
                     const char *function, CU_BOOL fatal);
#define CU_assertImplementation check_assert

/* The table of a CSV text; to be freed. */
Table *check_table(const char *text);

/* |a - b| <= tolerance; NAN is never close. */
#define CHECK_CLOSE(a, b, tolerance) CU_ASSERT(fabs((a) - (b)) <= (tolerance))
#define CHECK_TEXT(a, b)             CU_ASSERT_STRING_EQUAL((a), (b))

#endif
