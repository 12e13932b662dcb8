/* sweep.h: a user's own study: every combination of lists of run options, its orders, its figure.
 */
#ifndef MPMLAB_SWEEP_H
#define MPMLAB_SWEEP_H

#include "lists.h"
#include "studies/study.h"

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
    int across;  /* the axis that figure and orders go along: the longest list of numbers; or -1 */
    int chosen;  /* how many combinations can be run */
    int *choice; /* [chosen] their numbers, ascending */
} Sweep;

/* Finds `across`, and puts that axis last: then the cases of one curve stand together. */
void sweep_arrange(Sweep *sweep);

/* How many combinations it has. */
double sweep_size(const Sweep *sweep);

/* The command of combination k. */
void sweep_case(const Sweep *sweep, int k, char text[], size_t size);

/* The value of axis a in combination k. */
const char *sweep_value(const Sweep *sweep, int a, int k);

/* The settings that distinguish the curve of combination k from the others: "gimp; cfl 0.1". */
void sweep_title(const Sweep *sweep, int k, char text[256]);

/* The --ppc of case k; NAN if --ppc is not varied, or is the axis along which curves run. */
double sweep_asked_ppc(const Sweep *s, int k);

/* Finds the combinations that can be run. Others (a method with an integrator it is unstable with)
 * are left out, and each reason is written on `notes`. A fault with code 2: none is left, or a
 * word is refused in every combination and by itself. */
int sweep_choose(Sweep *sweep, FILE *notes, Fault *fault);

void sweep_free(Sweep *sweep);

/* From the rows, which are those of the chosen combinations: NAME.curves.csv (series, x, y,
 * status), NAME.orders.csv (one line per curve) and NAME.var for the figure. */
void sweep_tables(const Sweep *sweep, const Results *results);

#endif
