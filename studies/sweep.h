/* sweep.h: a user's own study: every combination of lists of run options, its orders, its figure.
 */
#ifndef MPMLAB_SWEEP_H
#define MPMLAB_SWEEP_H

#include "lists.h"
#include "study.h"

enum { SWEEP_AXES = 24 };

/* One option with its values. */
typedef struct Axis {
    char option[64]; /* "cells", or "set" */
    char name[64];   /* "cells", or the setting's name */
    List list;
} Axis;

typedef struct Sweep {
    char problem[32];
    int n;
    Axis axis[SWEEP_AXES];
    int across; /* the axis that figure and orders go along: the longest list of numbers; or -1 */
} Sweep;

/* Finds `across`, and puts that axis last: then the cases of one curve stand together. */
void sweep_arrange(Sweep *sweep);

/* How many cases it has. */
double sweep_size(const Sweep *sweep);

/* The command of case k. */
void sweep_case(const Sweep *sweep, int k, char text[], size_t size);

/* From dir/NAME.csv: NAME.curves.csv (series, x, y, status), NAME.orders.csv (a line a curve) and
 * NAME.var for the figure. 0 or a fault. */
int sweep_tables(const Sweep *sweep, const char *dir, const char *name, Fault *fault);

#endif
