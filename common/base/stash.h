/* stash.h: the state of a run, which changes from step to step, written to a stream as bytes or
 * read from it. One function does both, so that they cannot differ. */
#ifndef MPMLAB_STASH_H
#define MPMLAB_STASH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct Stash {
    FILE *f;
    bool load;       /* bytes come in, else they go out */
    bool bad;        /* a read or write failed: what was read since is not to be used */
    const char *why; /* what the run of the state has and this one has not; NULL: no difference */
} Stash;

/* Writes n bytes at `at`, or reads them there. */
void stash_bytes(Stash *s, void *at, size_t n);

/* Writes a number that an option sets, or reads one and compares. False if they differ: then `why`
 * names what the run of the state has ("another --every"). */
bool stash_same_option(Stash *s, long number, const char *why);

/* The same for the length of an array. */
bool stash_same(Stash *s, long number);

#define STASH(s, object) stash_bytes((s), &(object), sizeof(object))

#endif
