/* csv_append.h: rows added to a table that several runs may be adding to at once. */
#ifndef MPMLAB_CSV_APPEND_H
#define MPMLAB_CSV_APPEND_H

#include <stdio.h>
#include "common/base/fault.h"
#include "common/base/row.h"

/* Can rows be appended to path? 0, or a fault: 1 it cannot be written, 2 it has other columns. */
int csv_append_check(const char *path, Fault *fault);

/* Appends the row under a lock, the header first if the file is new. A torn last line (a run was
 * killed while writing) is dropped, with a note on `notes` if not NULL. 0 or a fault as above. */
int csv_append(const char *path, const Row *row, FILE *notes, Fault *fault);

#endif
