/* files.h: the files that a study's runs left beside its table, and which of them count: those of
 * runs that are in the table and reached their end. */
#ifndef MPMLAB_FILES_H
#define MPMLAB_FILES_H

#include "studies/engine/cases.h"
#include "curves.h"

typedef struct Files {
    const char *dir, *name;
    Cases cases;
    Table *rows; /* NAME.csv, or NULL */
    int *row;    /* [cases.n] the case's row, or -1 */
} Files;

/* Of the study of this name; to be closed. */
void files_open(Files *f, const char *dir, const char *name);
void files_close(Files *f);

/* Is dir/NAME.PART.csv (or the file `path`) of a run that reached its end? */
bool file_kept(const Files *f, const char *part);
bool file_path(const Files *f, const char *part, char path[PATH_TEXT]); /* gives its path, too */
bool path_kept(const Files *f, const char *path);

/* "ok", "lost" or, of a run that is not in the table, "absent": for a column `status`. */
const char *file_status(const Files *f, const char *part);

/* The file of such a run; NULL of any other. */
Table *file_read(const Files *f, const char *part);

#endif
