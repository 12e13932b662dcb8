/* must.c: allocation that need not be checked by its callers. */
#define _GNU_SOURCE /* vasprintf */
#include "must.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void *must(void *memory)
{
    if (memory) return memory;
    fputs("mpmlab: out of memory\n", stderr);
    exit(1);
}

void *must_grow(void *list, int n, size_t size)
{
    if (n & (n - 1)) return list; /* grows when n is 0 or a power of two */
    return must(realloc(list, size * (n ? 2 * (size_t)n : 1)));
}

char *must_text(const char *format, ...)
{
    char *text = NULL;
    va_list args;
    va_start(args, format);
    int n = vasprintf(&text, format, args);
    va_end(args);
    return must(n < 0 ? NULL : text);
}
