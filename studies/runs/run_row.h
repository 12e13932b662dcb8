/* run_row.h: the row of a run in a table of runs. */
#ifndef MPMLAB_RUN_ROW_H
#define MPMLAB_RUN_ROW_H

#include "common/base/table.h"
#include "common/run/engine.h"
#include "studies/measure.h"

/* Are problem, method, mesh, duration and settings of this row those of the resolved run? Its CFL
 * number and integrator are not compared. */
bool run_row_is(const Table *rows, int row, const RunSpec *spec, const Engine *engine);

/* A number of the first row of the run that is given as the command line would ("run bar --ppc 2");
 * none if there is no such row, or the run was lost. */
Measure run_row_value(const Table *rows, const char *column, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
