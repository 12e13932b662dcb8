/* test_stopwatch.c: a stopwatch counts a part of a loop, each turn once, and nothing that it did
 * not see. */
#include "common/base/stopwatch.h"
#include <math.h>
#include "tests/check.h"

static double busy(int n)
{
    double sum = 0;
    for (int k = 0; k < n; k++) sum += sqrt(k + sum);
    return sum;
}

static void test_part(void)
{
    /* turns from far below a millisecond to far above */
    for (int length = 10; length <= 1000000; length *= 10) {
        Stopwatch s = {0};
        double sum = 0;
        const double wall = stopwatch_wall(), cpu = stopwatch_cpu();
        for (int k = 0; k < 5; k++) {
            stopwatch_start(&s);
            sum += busy(length);
            stopwatch_stop(&s);
            sum += busy(length);
        }
        stopwatch_read(&s);
        const double all_wall = stopwatch_wall() - wall, all_cpu = stopwatch_cpu() - cpu;
        const Stopwatch before = s;
        stopwatch_read(&s);
        CU_ASSERT(sum > 0);
        CU_ASSERT(s.cpu > 0 && s.cpu < all_cpu);
        CU_ASSERT(s.wall > 0 && s.wall < all_wall);
        CU_ASSERT_EQUAL(s.cpu, before.cpu); /* no turn in between */
    }
}

static const TestCase tests[] = {
    {"a part of a loop, once", test_part},
    {NULL, NULL},
};
CHECK_SUITE(tests)
