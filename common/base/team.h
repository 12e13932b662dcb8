/* team.h: loops that threads share. Only team.c starts threads (OpenMP's parallel regions);
 * elsewhere a pragma only guards what several threads write. One thread runs a plain loop: libgomp
 * would allocate memory and call the system for each region, which costs more than a whole step of
 * a few particles. */
#ifndef MPMLAB_TEAM_H
#define MPMLAB_TEAM_H

/* Does the iterations first ... last - 1 of a loop; there may be none. No iteration may write what
 * another one reads or writes, unless that is guarded. */
typedef void TeamWork(void *own, int first, int last);

/* Does n iterations: each of `threads` threads gets one contiguous part. With one thread or fewer
 * than two iterations work is called once, for all of them; so it is in team_take. */
void team_share(int threads, int n, TeamWork *work, void *own);

/* The same, but each iteration is done by the next free thread: for iterations of unequal cost. */
void team_take(int threads, int n, TeamWork *work, void *own);

#endif
