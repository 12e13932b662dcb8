/* team.h: loops that threads share. OpenMP's regions stand in team.c alone: libgomp pays for each,
 * of one thread too, with an allocation and a system call, which is more than a whole step of a few
 * particles; a team of one is a plain loop here. */
#ifndef MPMLAB_TEAM_H
#define MPMLAB_TEAM_H

/* The turns first ... last - 1 of a loop. What two turns write must not meet. */
typedef void TeamWork(void *own, int first, int last);

/* n turns, a contiguous part of them for each of `threads` threads. */
void team_share(int threads, int n, TeamWork *work, void *own);

/* n turns, each for the thread that is free next: for turns that differ in cost. */
void team_take(int threads, int n, TeamWork *work, void *own);

#endif
