/* sidecar.h: NAME.csv of a study, and NAME.json, which says where its numbers come from. */
#ifndef MPMLAB_SIDECAR_H
#define MPMLAB_SIDECAR_H

#include "cases.h"

/* Writes the rows of all cases, in order, timing columns last. 0 or a fault. */
int sidecar_write_rows(const Cases *cases, const Journal *journal, const char *path, Fault *fault);

/* Writes dir/NAME.json: inputs, version, compiler, flags, time steps, seconds, checksums. */
int sidecar_write(const Study *study, const Cases *cases, const char *dir, Fault *fault);

/* Is dir/NAME.csv the whole table that the study asks for now? If not, reason says why. */
bool sidecar_is_current(const Study *study, const char *dir, char reason[128]);

/* Before a table is written over one that has runs which are not among these cases: renames all
 * files of the old one but the journal from NAME to NAME-1 (or the next free number), and says so.
 * 0 or a fault. */
int sidecar_keep(const Study *study, const Cases *cases, const char *dir, Fault *fault);

#endif
