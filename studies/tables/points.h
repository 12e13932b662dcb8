/* points.h: the numbers that a run leaves for each of its points, in files of particles, samples,
 * nodes and errors. Columns are named in one text: "x y z". */
#ifndef MPMLAB_POINTS_H
#define MPMLAB_POINTS_H

#include "common/base/table.h"

/* The numbers of these columns in one row; `out` has room for them. */
void points_row(const Table *t, int row, const char *columns, double out[]);

/* The same of all rows, one row after the other; the caller frees them. */
double *points_all(const Table *t, const char *columns);

/* Cauchy stress along e in space: e sigma e/|e|^2. */
double points_stress_along(const Table *t, int row, const double e[3]);

#endif
