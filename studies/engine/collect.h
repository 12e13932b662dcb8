/* collect.h: a study's missing cases as independent commands, for GNU parallel or a batch system;
 * and their rows back into the journal. Each command has a file of its own, named by its key. */
#ifndef MPMLAB_COLLECT_H
#define MPMLAB_COLLECT_H

#include "cases.h"

/* Prints one shell command per missing case, and makes the folder dir/NAME.collect for their rows.
 */
int collect_list(const Study *study, const Cases *cases, const Journal *journal, const char *dir,
                 Fault *fault);

/* Appends to the journal (at path) the rows found there, in the order of the cases. */
int collect_merge(const Study *study, const Cases *cases, const Journal *journal, const char *path,
                  const char *dir, Fault *fault);

#endif
