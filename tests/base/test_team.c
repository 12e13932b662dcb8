/* test_team.c: every turn of a shared loop is taken once, whatever the number of threads. */
#include "common/base/team.h"
#include "tests/check.h"

enum { MOST = 23 };

static void count(void *own, int first, int last)
{
    int *turns = own;
    for (int k = first; k < last; k++) turns[k]++;
}

static void test_once(void)
{
    for (int threads = 1; threads < 8; threads++)
        for (int n = 0; n <= MOST; n++) {
            int turns[MOST + 1] = {0};
            team_share(threads, n, count, turns);
            team_take(threads, n, count, turns);
            for (int k = 0; k <= MOST; k++) CU_ASSERT_EQUAL(turns[k], k < n ? 2 : 0);
        }
}

/* Notes, at the first turn of a part, where the part ends. */
static void mark(void *own, int first, int last)
{
    if (first < last) ((int *)own)[first] = last;
}

static void test_parts(void)
{
    int last[MOST + 1] = {0}, parts = 0;
    team_share(4, MOST, mark, last);
    for (int at = 0; at < MOST && last[at] > at; at = last[at]) parts++;
    CU_ASSERT_EQUAL(parts, 4);
}

static const TestCase tests[] = {
    {"every turn once", test_once},
    {"shares are contiguous, one a thread", test_parts},
    {NULL, NULL},
};
CHECK_SUITE(tests)
