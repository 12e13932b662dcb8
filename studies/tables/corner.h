/* corner.h: a block in space whose corner reaches a distance eps into cells that are empty
 * otherwise (H-5): which of a few time steps are stable. */
#ifndef MPMLAB_CORNER_H
#define MPMLAB_CORNER_H

#include "studies/study.h"

/* A method, and how far the block reaches into empty cells: the outermost point that counts for the
 * method lies eps beyond a node. It is the last particle (beyond = 0), or the edge of its box or of
 * its weights, `beyond` cells farther out. */
typedef struct Corner {
    const char *method;
    double beyond; /* [cells] */
    double eps;    /* [cells] */
    double scale;  /* unit of time steps [h/c], c the speed of P waves */
} Corner;

/* The steps that are tried, in that unit, in ascending order. */
enum { CORNER_RUNGS = 6 };
extern const double corner_rungs[CORNER_RUNGS];

/* Adds a run with each of them. */
void corner_add(Cases *list, const Corner *c);

/* The largest of these steps for which it and all smaller ones are stable; 0: there is none. */
Measure corner_stable(const Table *rows, const Corner *c);

#endif
