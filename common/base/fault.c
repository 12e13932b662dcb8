/* fault.c: failures as values, and the nearest name for "did you mean". */
#include "fault.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { LONGEST_TEXT = sizeof((Fault *)NULL)->text, HALF = LONGEST_TEXT / 2 - 3, MOST = 1 << 14 };

/* Copies text. If it is too long (a path), its middle is left out, because the reason stands at the
 * end. */
static void shorten(const char *whole, int n, char out[LONGEST_TEXT])
{
    const int there = n < MOST ? n : MOST - 1;
    if (n < LONGEST_TEXT)
        memcpy(out, whole, (size_t)n + 1);
    else
        snprintf(out, LONGEST_TEXT, "%.*s...%s", HALF, whole, whole + there - HALF);
}

int fault_set(Fault *f, int code, const char *format, ...)
{
    if (!f) return code;
    va_list args;
    va_start(args, format);
    f->code = code;
    char whole[MOST];
    int n = vsnprintf(whole, sizeof whole, format, args);
    va_end(args);
    shorten(whole, n, f->text);
    for (char *c = f->text; *c; c++) /* typed text may hold anything: a fault stays one line */
        if ((unsigned char)*c < ' ') *c = ' ';
    return code;
}

int fault_machine(Fault *f, const char *what)
{
    return fault_set(f, FAULT_MACHINE, "%s: %s", what, strerror(errno));
}

enum { LONGEST_NAME = 63 };

static int min2(int a, int b)
{
    return a < b ? a : b;
}

/* Capital or small letter: the same name is meant. */
static bool same_letter(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* How many letters must be changed, left out, added or exchanged with their neighbour to make b of
 * a (optimal string alignment); only the first LONGEST_NAME letters of b count. */
static int edit_distance(const char *a, const char *b)
{
    int rows[3][LONGEST_NAME + 1] = {{0}}, *last = rows[0], *row = rows[1], *next = rows[2];
    const int nb = (int)strnlen(b, LONGEST_NAME);
    for (int j = 0; j <= nb; j++) row[j] = j;
    for (int i = 0; i < 2 * LONGEST_NAME && a[i]; i++) { /* a longer word is no misspelt name */
        next[0] = i + 1;
        for (int j = 0; j < nb; j++) {
            next[j + 1] = min2(row[j] + !same_letter(a[i], b[j]), min2(row[j + 1], next[j]) + 1);
            if (i && j && same_letter(a[i], b[j - 1]) && same_letter(a[i - 1], b[j]))
                next[j + 1] = min2(next[j + 1], last[j - 1] + 1);
        }
        int *spare = last;
        last = row;
        row = next;
        next = spare;
    }
    return row[nb];
}

/* NULL if there are no names. */
static const char *nearest(const char *got, const char *const *names, int n)
{
    const char *best = NULL;
    int least = 0;
    for (int k = 0; k < n; k++) {
        const int distance = edit_distance(got, names[k]);
        const bool begins = *got && strncasecmp(got, names[k], strlen(got)) == 0;
        const int own = begins ? min2(distance, 1) : distance; /* an abbreviation is near */
        if (best && own >= least) continue;
        best = names[k];
        least = own;
    }
    return best;
}

int fault_did_you_mean(Fault *f, const char *dashes, const char *got, const char *const *names,
                       int n)
{
    const char *name = *got ? nearest(got, names, n) : NULL;
    if (!f || !name) return FAULT_USAGE;
    const size_t length = strlen(f->text);
    snprintf(f->text + length, sizeof f->text - length, "; did you mean '%s%s'?", dashes, name);
    return FAULT_USAGE;
}
