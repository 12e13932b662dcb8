/* check.h: tests as tables of functions; one main an executable, which ends with CUnit's summary.
 *   static void test_x(void) { CU_ASSERT(...); }
 *   const TestCase some_tests[] = {{"what holds", test_x}, {NULL, NULL}};
 *   int main(void) { return check_run("tools", some_tests); }                                   */
#ifndef MPMLAB_CHECK_H
#define MPMLAB_CHECK_H

#include <CUnit/Basic.h>
#include <math.h>

typedef struct TestCase {
    const char *name;
    void (*run)(void);
} TestCase;

/* Runs the table as one suite. The process's exit status: 0, or 1 if anything failed. */
int check_run(const char *suite, const TestCase *tests);

/* |a - b| <= tolerance; NAN is never close. */
#define CHECK_CLOSE(a, b, tolerance) CU_ASSERT(fabs((a) - (b)) <= (tolerance))
#define CHECK_TEXT(a, b)             CU_ASSERT_STRING_EQUAL((a), (b))

#endif
