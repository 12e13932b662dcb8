/* team.c: see team.h. */
#include "team.h"

void team_share(int threads, int n, TeamWork *work, void *own)
{
    if (threads < 2 || n < 2) {
        work(own, 0, n);
        return;
    }
#pragma omp parallel for schedule(static) num_threads(threads)
    for (int k = 0; k < threads; k++)
        work(own, (int)((long long)n * k / threads), (int)((long long)n * (k + 1) / threads));
}

void team_take(int threads, int n, TeamWork *work, void *own)
{
    if (threads < 2 || n < 2) {
        work(own, 0, n);
        return;
    }
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (int k = 0; k < n; k++) work(own, k, k + 1);
}
