/* phrase.h: short texts made where they are used: names of files and claims, settings of runs. */
#ifndef MPMLAB_PHRASE_H
#define MPMLAB_PHRASE_H

#include <stdarg.h>
#include <stdio.h>

/* The formatted text. It stays as it is for as long as the program runs; nobody frees it. */
const char *phrase(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* In a function whose last parameters are `format, ...`: formats them into the array `text`. */
#define PHRASE_INTO(text, format)                                                                  \
    do {                                                                                           \
        va_list args;                                                                              \
        va_start(args, format);                                                                    \
        vsnprintf(text, sizeof text, format, args);                                                \
        va_end(args);                                                                              \
    } while (0)

#endif
