/* pool.h: runs cases in several processes, which append their rows to a journal. */
#ifndef MPMLAB_POOL_H
#define MPMLAB_POOL_H

#include "cases.h"

/* Runs the n cases todo[] in `jobs` processes; title is for the progress line. 0; 130 if a signal
 * asked to stop; or a fault with code 1: a case left no row (the others went on), or the journal at
 * path cannot be written (all stopped). */
int pool_run(const Cases *cases, const int *todo, int n, int jobs, const Journal *journal,
             const char *path, const char *title, Fault *fault);

#endif
