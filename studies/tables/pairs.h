/* pairs.h: methods with time integrators, published or not, as the tables of studies show them. */
#ifndef MPMLAB_PAIRS_H
#define MPMLAB_PAIRS_H

#include "studies/study.h"

/* A column of such a table. refresh: with L taken anew before the second projection. */
typedef struct Pair {
    const char *integrator;
    bool refresh;
} Pair;

enum { PAIRS = 7 }; /* those with refresh come last */
extern const Pair pairs[PAIRS];

/* Is it run without being asked to allow it? */
bool pair_is_allowed(const Engine *engine, const char *problem, const char *method, Pair pair);

/* Is there such a run at all, with allow_unstable=1? With refresh only where that lifts a refusal.
 */
bool pair_is_run(const Engine *engine, const char *problem, const char *method, Pair pair);

/* The index into pairs[] of a row; or -1. */
int pair_of_row(const Table *rows, int row);

/* What `--integrator` is if it is not given. */
void pair_default_integrator(const Engine *engine, const char *problem, const char *method,
                             char out[16]);

#endif
