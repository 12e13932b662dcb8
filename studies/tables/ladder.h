/* ladder.h: the largest stable time step, from runs that differ in nothing but their CFL number.
 *
 * Stability is not always monotone in CFL (tents that cross cells are lost at one and kept at the
 * next larger one), so that a limit is not where a bisection happens to land: coarse rungs are run
 * first, all of them; the limit lies between the lowest one that fails and the next below it, and
 * only this gap is bisected. Below a lowest rung that fails, halves of it are tried. */
#ifndef MPMLAB_LADDER_H
#define MPMLAB_LADDER_H

#include "grades.h"

enum { MOST_RUNGS = 48 };

typedef struct Ladder {
    int n;                  /* rungs, in ascending order of CFL */
    int row[MOST_RUNGS];    /* of the table */
    double cfl[MOST_RUNGS]; /* [-] as asked for */
    Mark grade[MOST_RUNGS]; /* weak: finished, but energy was 5 % and more above its start */
} Ladder;

/* All ladders of a table in order of their first rows; the caller frees *out. How many. */
int ladder_read_all(const Table *rows, Ladder **out);

/* The largest CFL number of a run that is at most `worst`, as all below it are; 0 if the lowest is
 * not. *first is the rung that is worse, or -1 if none is: then the limit is what was tried. */
double ladder_limit(const Ladder *l, Mark worst, int *first);

/* The uninterrupted sequence of stable rungs that ends at the largest stable one: from *low to
 * *high. False if no rung is stable. */
bool ladder_window(const Ladder *l, int *low, int *high);

/* Adds the run in the middle between rungs k and k + 1, unless the gap is at most so much of its
 * upper end. k -1: half of the lowest rung, unless that is below `least`. */
void ladder_split(Cases *list, const Table *rows, const Ladder *l, int k, double relative,
                  double least);

/* Of every ladder with stable rungs: splits the gaps above and below its window, unless they are at
 * most so much of their upper ends. */
void ladder_refine_windows(Cases *list, const Table *rows, double above, double below);

#endif
