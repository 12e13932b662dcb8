/* stopwatch.h: wall time and CPU time. */
#ifndef MPMLAB_STOPWATCH_H
#define MPMLAB_STOPWATCH_H

double stopwatch_wall(void); /* [s] since some fixed instant */
double stopwatch_cpu(void);  /* [s] that all threads of this process have spent computing */

#endif
