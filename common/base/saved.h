/* saved.h: a run's state on disk, from which it can be resumed: a text line of identification, the
 * run's key and program, bytes (stash.h), and a checksum of all. FILE.1 is the previous state. */
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

/* Checks that path, the value of `option` (NULL: not given), is a regular file or does not exist:
 * nothing else can be read back. 0 or a fault. */
int saved_check_path(const char *option, const char *path, Fault *fault);

/* Checks that path.1, where the previous state will be, is free or a state. 0 or a fault. */
int saved_check_before(const char *path, Fault *fault);

/* Opens a new state for writing; NULL and a fault. */
FILE *saved_begin(const char *path, const SavedKey *key, Fault *fault);

/* Puts it in place, whole, on the disk; what was there becomes path.1. 0 or a fault. */
int saved_commit(FILE *f, const char *path, Fault *fault);

/* Opens the newest complete state of this run, path or path.1, where its bytes begin; writes the
 * file's name to `chosen` if that is not NULL. NULL and a fault (2): both are damaged or missing,
 * or of another run. */
FILE *saved_open(const char *path, const SavedKey *key, char chosen[PATH_MAX], Fault *fault);

#endif
