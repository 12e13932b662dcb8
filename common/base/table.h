/* table.h: CSV tables in memory, read and written whole; fits of orders (GSL). */
#ifndef MPMLAB_TABLE_H
#define MPMLAB_TABLE_H

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include "fault.h"

/* Text cells, row-major, which lie in the text of the file. Cells may be quoted there (RFC 4180).
 */
typedef struct Table {
    int ncol, nrow;
    char **name; /* [ncol] */
    char **cell; /* [nrow * ncol] */
    char *text;  /* owned, as name is (cell is the rest of that array) */
} Table;

/* Reads a CSV file with a header line. NULL and a fault if it cannot be read or is ragged. */
Table *table_read(const char *path, Fault *fault);
void table_free(Table *t);

/* Opens dir/NAME.PART.csv, which a run or tables() left there. NULL and a fault if it cannot. */
Table *table_read_part(const char *dir, const char *name, const char *part, Fault *fault);

/* dir/NAME.PART.csv, or dir/NAME.csv if part is NULL. */
enum { PATH_TEXT = 4096 };
void table_part_path(char path[PATH_TEXT], const char *dir, const char *name, const char *part);

int table_column(const Table *t, const char *name);                /* -1 if absent */
const char *table_text(const Table *t, int row, const char *name); /* "" if absent */
double table_number(const Table *t, int row, const char *name);    /* NAN if absent or empty */

/* Puts text as one CSV cell (quoted if it must be). */
void table_put_cell(FILE *out, const char *text);

/* Can path be written, for all that can be told without doing it? 0 or a fault with code 1. */
int file_check(const char *path, Fault *fault);

/* Makes a folder and those above it. 0 or a fault. */
int file_make_folder(const char *path, Fault *fault);

/* The file that a symbolic link stands for, which need not exist yet, or the open stream
 * (/proc/self/fd/1); else path itself. */
void file_target(const char *path, char out[PATH_MAX]);

/* Is path a stream that is open already (/dev/stdout), a device, a pipe or a folder? What is
 * written to it goes there at once and cannot be read back. */
bool file_is_special(const char *path);

/* Opens a temporary file beside path; file_commit flushes, checks and renames it into place, so
 * that path is either the whole new file or what it was. A link stays a link: its target is
 * replaced. What is open already (/dev/stdout) goes on where it is. Both report faults with code 1.
 */
FILE *file_begin(const char *path, Fault *fault);
int file_commit(FILE *f, const char *path, Fault *fault);
void file_abandon(FILE *f, const char *path);

/* Least-squares slope of log y against log x (gsl_fit_linear), with its standard error in *err if
 * not NULL. NAN with fewer than two finite positive points. */
double table_order_fit(int n, const double x[], const double y[], double *err);

#endif
