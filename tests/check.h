/* check.h: tests as tables of functions; one main an executable, which ends with CUnit's summary:
 *   static void test_x(void) { CU_ASSERT(...); }
 *   static const TestCase some_tests[] = {{"what holds", test_x}, {NULL, NULL}};
 *   int main(void) { ... suites[] = {{"some", some_tests}, {NULL, NULL}}; return check_run(suites);
 */
#ifndef MPMLAB_CHECK_H
#define MPMLAB_CHECK_H

#include <CUnit/Basic.h>
#include <math.h>

typedef struct TestCase {
    const char *name;
    void (*run)(void);
} TestCase;

typedef struct TestSuite {
    const char *name;
    const TestCase *tests;
} TestSuite;

/* Runs the suites (ended by a NULL name), or of their tests only those whose "suite: test" contains
 * the environment's ONLY. The exit status: 0, 1 if anything failed, 2 if no test was run. */
int check_run(const TestSuite *suites);

/* What the assertions that follow are about; a failure names it. Until the next call or test. NULL:
 * unknown, or its default. Fixtures call it for every run they set up. */
void check_context(int dim, const char *scene, const char *method, const char *integrator,
                   const char *settings);

/* Assertions of CUnit go through check_assert, which adds the context to what they print. */
CU_BOOL check_assert(CU_BOOL holds, unsigned line, const char *condition, const char *file,
                     const char *function, CU_BOOL fatal);
#define CU_assertImplementation check_assert

/* |a - b| <= tolerance; NAN is never close. */
#define CHECK_CLOSE(a, b, tolerance) CU_ASSERT(fabs((a) - (b)) <= (tolerance))
#define CHECK_TEXT(a, b)             CU_ASSERT_STRING_EQUAL((a), (b))

#endif
