/* fault.c: failures as values, and the nearest name for "did you mean". */
#include "fault.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { LONGEST_TEXT = sizeof((Fault *)NULL)->text, HALF = LONGEST_TEXT / 2 - 3, MOST = 1 << 14 };

/* What is too long (a path) loses its middle: the reason stands at the end. */
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

enum { LONGEST_NAME = 63 };

static int min3(int a, int b, int c)
{
    int ab = a < b ? a : b;
    return ab < c ? ab : c;
}

/* Levenshtein distance, row by row; only the first LONGEST_NAME letters of b count. */
static int edit_distance(const char *a, const char *b)
{
    int row[LONGEST_NAME + 1], nb = (int)strnlen(b, LONGEST_NAME);
    for (int j = 0; j <= nb; j++) row[j] = j;
    for (int i = 0; i < 2 * LONGEST_NAME && a[i]; i++) { /* a longer word is no misspelt name */
        int diagonal = row[0];
        row[0] = i + 1;
        for (int j = 0; j < nb; j++) {
            int change = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = min3(change, row[j] + 1, row[j + 1] + 1);
        }
    }
    return row[nb];
}

const char *fault_nearest_name(const char *got, const char *const *names, int n)
{
    const char *best = NULL;
    int least = 0;
    for (int k = 0; k < n; k++) {
        int begins = *got && strncmp(got, names[k], strlen(got)) == 0; /* an abbreviation */
        int distance = begins ? 1 : edit_distance(got, names[k]);
        if (best && distance >= least) continue;
        best = names[k];
        least = distance;
    }
    return best;
}
