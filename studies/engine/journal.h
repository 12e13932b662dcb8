/* journal.h: the rows of a study as they finish, each with length and checksum, so that a study
 * killed at any moment loses no finished row. */
#ifndef MPMLAB_JOURNAL_H
#define MPMLAB_JOURNAL_H

#include <stddef.h>
#include "common/base/fault.h"

enum { MOST_PROGRAMS = 4 };

typedef struct Record {
    const char *key, *row; /* one line each */
} Record;

typedef struct Journal {
    int fd;
    char *text; /* the file; records point into it */
    int n;
    Record *records; /* sorted by key, the newest of each */
} Journal;

/* Opens (or creates) and locks path, waiting for another study that holds it; reads it, and cuts
 * off a torn tail. 0, or a fault with code 1. */
int journal_open(Journal *j, const char *path, Fault *fault);

/* Rewrites the file without what no program can use any more: older rows of equal keys, and rows of
 * all programs (the last word of a key) but this one and the MOST_PROGRAMS - 1 that wrote last. It
 * is replaced whole, and only if that makes it smaller. 0 or a fault. */
int journal_compact(Journal *j, const char *path, const char *program, Fault *fault);

/* Reads again what has been appended since. */
int journal_reload(Journal *j, const char *path, Fault *fault);

/* Order of keys: words that are numbers by value, so that 0.3 and 0.29999999999999999 are one. */
int journal_compare_keys(const char *a, const char *b);

/* The row with that key, or NULL; valid until the next reload. */
const char *journal_row(const Journal *j, const char *key);

/* Appends a record by one write(); may be called by several processes sharing fd. 0, or errno. */
int journal_append(int fd, const char *key, const char *row);

void journal_close(Journal *j);

#endif
