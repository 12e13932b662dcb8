/* stopwatch.h: wall time and CPU time. */
#ifndef MPMLAB_STOPWATCH_H
#define MPMLAB_STOPWATCH_H

double stopwatch_wall(void); /* [s] since some fixed instant */
double stopwatch_cpu(void);  /* [s] that all threads of this process have spent computing */

/* The time of a part of a loop, from start to stop in each turn. The clock of CPU time is a system
 * call, which can cost more than the part: it is read when at least a millisecond has passed since
 * the first start, and the CPU time in between is shared by the part and the rest of the loop as
 * the wall time is. So cpu is exact where the part itself takes a millisecond; below that it is an
 * estimate: too low if the rest waits for a disk, or if the part alone uses several threads. */
typedef struct Stopwatch {
    double wall, cpu;              /* [s] so far; cpu: as of the last reading */
    double start;                  /* [s] of this turn, wall */
    double from, cpu_from, inside; /* since the last reading: its first start; wall of the part */
} Stopwatch;

void stopwatch_start(Stopwatch *s);
void stopwatch_stop(Stopwatch *s);
void stopwatch_read(Stopwatch *s); /* brings cpu up to date; between stop and start */

#endif
