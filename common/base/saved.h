/* saved.h: a run's state on disk, to go on from: a text line that says what it is, the run's key
 * and program, bytes (stash.h), and a checksum of all. FILE.1 is the one before. */
#ifndef MPMLAB_SAVED_H
#define MPMLAB_SAVED_H

#include <limits.h>
#include "stash.h"
#include "fault.h"

/* A state belongs to one run: to the command that makes it, and to one program. */
typedef struct SavedKey {
    const char *command;
    unsigned long program;
} SavedKey;

/* Only a regular file, there or not, can be read back: of an option and its path, or NULL. */
int saved_check_path(const char *option, const char *path, Fault *fault);

/* Opens a new state for writing; NULL and a fault. */
FILE *saved_begin(const char *path, const SavedKey *key, Fault *fault);

/* Puts it in place, whole, on the disk; what was there becomes path.1. 0 or a fault. */
int saved_commit(FILE *f, const char *path, Fault *fault);

/* The newest whole state of this run, path or path.1: opens it where its bytes begin; `chosen` is
 * its name, or may be NULL. NULL and a fault (2): torn or missing both, or of another run. */
FILE *saved_open(const char *path, const SavedKey *key, char chosen[PATH_MAX], Fault *fault);

#endif
