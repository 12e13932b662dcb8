/* stopwatch.c: see stopwatch.h. */
#include "stopwatch.h"

#include <time.h>

static double seconds(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double stopwatch_wall(void)
{
    return seconds(CLOCK_MONOTONIC);
}

double stopwatch_cpu(void)
{
    return seconds(CLOCK_PROCESS_CPUTIME_ID);
}
