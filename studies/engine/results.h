/* results.h: what a study has left in its folder, handed to its page (study.h: Results). */
#ifndef MPMLAB_RESULTS_H
#define MPMLAB_RESULTS_H

#include "studies/study.h"

/* Of dir/NAME.*; r->rows is empty if there is no NAME.csv, which is then the fault of
 * results_close. `quick`: which list of cases the rows are of. */
Results *results_open(const Study *study, const char *dir, bool quick);

/* Writes what the page has begun, each file whole or not at all. 0, or the first fault that reading
 * or writing had. Frees all. */
int results_close(Results *r, Fault *fault);

/* The table that results_part() did not find, or "". */
const char *results_missing(const Results *r);

/* Has the page make its tables from dir/NAME.csv. 0 or a fault. */
int results_tables(const Study *study, const char *dir, bool quick, Fault *fault);

#endif
