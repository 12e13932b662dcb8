/* rows.h: a loop over rows of nodes, shared by threads. */
#ifndef MPMLAB_ROWS_H
#define MPMLAB_ROWS_H

#include "sim.h"

typedef void RowWork(Sim *sim, int row, double number);

/* Calls work for each row that particles may reach. `number` is handed on: a time, a time step, or
 * which of several turns it is. No row may write what another one reads or writes. */
void rows_each(Sim *sim, RowWork *work, double number);

#endif
