/* stability.h: the stability maps of T-4: which runs, and their tables.
 *
 * NAME.map.csv: one line per run, its outcome and its place in the figure.
 * NAME.limits.csv: one line per series of CFL numbers, its limits and what ends them.
 * NAME.worst.csv: the least of them over PPC. NAME.safe.csv: over PPC and amplitudes, of each
 * method with its default integrator. */
#ifndef MPMLAB_STABILITY_H
#define MPMLAB_STABILITY_H

#include "pairs.h"

enum { MAP_MOST = 5, MAP_RUNGS = 10, MAPS = 2 };

typedef struct Map {
    const Engine *engine;
    const char *problem;
    int cells[2];                      /* per metre; [1]: with the default integrator */
    unsigned pairs;                    /* bit k: pairs[k]; the default integrator in any case */
    double period;                     /* [s] */
    double ppc[MAP_MOST], A[MAP_MOST]; /* 0: no more */
    int usual_ppc, usual_A;            /* indices: all that --quick runs */
} Map;

extern const Map stability_maps[MAPS];
extern const double stability_rungs[MAP_RUNGS]; /* CFL numbers */

/* Is this the method's default integrator? */
bool stability_is_usual(const Map *map, const char *method, Pair pair);

const Map *stability_of_row(const Table *rows, int row);

/* Does the map show this method with pairs[k]? */
bool stability_has_pair(const Map *map, const char *method, int k);

/* Writes the four tables. */
void stability_tables(const Results *results);

#endif
