/* rows.h: rows of nodes that threads share. */
#ifndef MPMLAB_ROWS_H
#define MPMLAB_ROWS_H

#include "sim.h"

typedef void RowWork(Sim *sim, int row, double number);

/* Each row that particles may reach; `number` is the pass's own: a time, a step. What two rows
 * write must not meet. */
void rows_each(Sim *sim, RowWork *work, double number);

#endif
