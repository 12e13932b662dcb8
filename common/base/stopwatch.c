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

void stopwatch_start(Stopwatch *s)
{
    s->start = stopwatch_wall();
    if (s->inside > 0) return;
    s->from = s->start;
    s->cpu_from = stopwatch_cpu();
}

static void read_at(Stopwatch *s, double now)
{
    if (s->inside > 0) s->cpu += (stopwatch_cpu() - s->cpu_from) * s->inside / (now - s->from);
    s->inside = 0;
}

void stopwatch_stop(Stopwatch *s)
{
    const double now = stopwatch_wall(), turn = now - s->start;
    s->wall += turn;
    s->inside += turn;
    if (now - s->from >= 1e-3) read_at(s, now);
}

void stopwatch_read(Stopwatch *s)
{
    read_at(s, stopwatch_wall());
}
