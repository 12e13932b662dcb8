/* corner.h: a block in space whose corner reaches a distance eps into cells that are empty
 * otherwise (H-5): which of a few time steps are stable. */
#ifndef MPMLAB_CORNER_H
#define MPMLAB_CORNER_H

#include "studies/study.h"

/* What reaches eps beyond a node: the last particle, or what lies so far beyond it. */
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

/* The largest of them that is stable, with all below it. */
Measure corner_stable(const Table *rows, const Corner *c);

#endif
