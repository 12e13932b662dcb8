/* stash.c: see stash.h. */
#include "stash.h"

void stash_bytes(Stash *s, void *at, size_t n)
{
    if (s->bad || n == 0) return;
    if (s->load)
        s->bad = fread(at, 1, n, s->f) != n;
    else
        s->bad = fwrite(at, 1, n, s->f) != n;
}

bool stash_same_option(Stash *s, long number, const char *why)
{
    long other = number;
    STASH(s, other);
    if (s->bad || other == number) return !s->bad;
    s->bad = true;
    s->why = why;
    return false;
}

bool stash_same(Stash *s, long number)
{
    return stash_same_option(s, number, "other particles or nodes");
}
