/* team.h: loops that threads share. Only team.c starts threads (OpenMP's parallel regions);
 * elsewhere a pragma only guards what several threads write. One thread runs a plain loop: libgomp
 * would allocate memory and call the system for each region, which costs more than a whole step of
 * a few particles. */
#ifndef MPMLAB_TEAM_H
#define MPMLAB_TEAM_H

/* Does the turns first ... last - 1 of a loop; there may be none. No turn may write what another
 * one reads or writes, unless it guards it. */
typedef void TeamWork(void *own, int first, int last);

/* Does n turns: each of `threads` threads gets one contiguous part. */
void team_share(int threads, int n, TeamWork *work, void *own);

/* Does n turns one by one, each by the next thread that is free: for turns of unequal cost. */
void team_take(int threads, int n, TeamWork *work, void *own);

#endif
