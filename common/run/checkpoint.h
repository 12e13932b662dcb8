/* checkpoint.h: a run's state out to a file every few seconds, and in again: --checkpoint FILE
 * --every-s N, --resume FILE. The rows, histories and particles of a run that was resumed have the
 * bits of those of the whole run. */
#ifndef MPMLAB_CHECKPOINT_H
#define MPMLAB_CHECKPOINT_H

#include "loop.h"

/* Between two steps: writes the state if it is time, or `now`. *m, *before: the instant reached. A
 * fault goes to l->code. */
void checkpoint_write(Loop *l, Moment *m, Side *before, bool now);

/* The state from the file that the run resumes from. 0 or a fault. */
int checkpoint_read(Loop *l, Moment *m, Side *before);

#endif
