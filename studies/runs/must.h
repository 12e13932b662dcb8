/* must.h: memory that the command line needs to go on at all: there, or one line and exit 1. */
#ifndef MPMLAB_MUST_H
#define MPMLAB_MUST_H

#include <stddef.h>

void *must(void *memory);

/* Room for one more element of `size` bytes behind n; list is NULL at first, and owned by the
 * caller. */
void *must_grow(void *list, int n, size_t size);

/* The formatted text in memory that the caller owns. */
char *must_text(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
