/* phrase.c: see phrase.h. */
#define _GNU_SOURCE /* vasprintf */
#include "phrase.h"

#include <stdlib.h>

/* All phrases, the youngest first. */
static struct Phrase {
    struct Phrase *before;
    char *text;
} * phrases;

const char *phrase(const char *format, ...)
{
    struct Phrase *p = malloc(sizeof *p);
    va_list args;
    va_start(args, format);
    const int n = p ? vasprintf(&p->text, format, args) : -1;
    va_end(args);
    if (n < 0) {
        fputs("mpmlab: out of memory\n", stderr);
        exit(1);
    }
    p->before = phrases;
    phrases = p;
    return p->text;
}
