/* stopwatch.h: wall time and CPU time. */
#ifndef MPMLAB_STOPWATCH_H
#define MPMLAB_STOPWATCH_H

double stopwatch_wall(void); /* [s] since some fixed instant */
double stopwatch_cpu(void);  /* [s] that all threads of this process have spent computing */

/* Sums the wall and CPU time of a part of a loop, from start to stop in each pass. Reading the CPU
 * clock is a system call, which can cost more than the part. So it is read over intervals: from a
 * start to the first stop that is a millisecond later, or to stopwatch_read. The CPU time of an
 * interval is multiplied by (wall time of the part)/(wall time of the interval). If one pass takes
 * a millisecond, the interval is that pass and cpu is exact. Otherwise it is an estimate, too low
 * if the rest of the loop waits for a disk, or if the part alone uses several threads. */
typedef struct Stopwatch {
    double wall, cpu;              /* [s] so far; cpu: as of the last reading */
    double start;                  /* [s] of this pass, wall */
    double from, cpu_from, inside; /* the interval: its start; wall time of the part in it */
} Stopwatch;

void stopwatch_start(Stopwatch *s);
void stopwatch_stop(Stopwatch *s);
void stopwatch_read(Stopwatch *s); /* brings cpu up to date; only while stopped */

#endif
