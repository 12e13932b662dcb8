/* history.h: numbers from the history of a run, whose rows are instants from its start to its end.
 * All are NAN of a table without rows. */
#ifndef MPMLAB_HISTORY_H
#define MPMLAB_HISTORY_H

#include "common/base/table.h"

/* When the column first differs from its start by more than this share of it [s]; NAN: never. */
double history_first_change(const Table *t, const char *column, double share);

/* Mean rate of the column from the last instant that lies within this share of the duration to the
 * end [1/s]. */
double history_rate(const Table *t, const char *column, double from);

#endif
