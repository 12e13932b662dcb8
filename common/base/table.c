/* table.c: CSV files (RFC 4180) in and out of memory; orders by fit (GSL). */
#include "table.h"

#include <errno.h>
#include <gsl/gsl_fit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "info.h"

/* Reads the open file into one text, a 0 behind it. NULL if it cannot, or if the file holds a 0
 * (a machine that lost power leaves such): what is behind it would be lost in silence. */
static char *read_text(FILE *f)
{
    size_t room = 1 << 16, n = 0;
    char *text = malloc(room);
    while (text) {
        n += fread(text + n, 1, room - n - 1, f);
        if (n < room - 1) break;
        char *larger = realloc(text, room *= 2);
        if (!larger) free(text);
        text = larger;
    }
    if (text) text[n] = '\0';
    const int holds_zero = text && memchr(text, '\0', n);
    if (holds_zero) errno = EILSEQ;
    if (text && !ferror(f) && !holds_zero) return text;
    free(text);
    return NULL;
}

/* Unquotes in place the cell that starts at s. Returns what follows it: ',', '\n' or the end. */
static char *cell_end(char *s)
{
    if (*s != '"') return s + strcspn(s, ",\r\n");
    char *to = s;
    for (char *from = s + 1; *from; from++) {
        if (*from == '"' && *++from != '"') {
            *to = '\0';
            return from;
        }
        *to++ = *from;
    }
    return NULL; /* the closing quote is missing */
}

/* Splits text in place into cells; each record is ended by a NULL. Returns the number of entries,
 * or -1; *entries is the caller's to free. */
static int split(char *text, char ***entries)
{
    int n = 0, room = 0;
    *entries = NULL;
    for (char *s = text; *s;) {
        if (n + 2 > room) {
            char **larger = realloc(*entries, sizeof *larger * (size_t)(room = 2 * room + 64));
            if (!larger) return -1;
            *entries = larger;
        }
        char *end = cell_end(s);
        if (!end || (*end && !strchr(",\r\n", *end))) return -1;
        char mark = *end;
        *end = '\0';
        (*entries)[n++] = s;
        s = end + (mark != '\0');
        if (mark == '\r' && *s == '\n') s++;
        if (mark != ',') (*entries)[n++] = NULL;
    }
    return n;
}

/* Puts the entries of split() into t; every record must have as many cells as the first. */
static int fill(Table *t, char **entries, int n)
{
    for (t->ncol = 0; t->ncol < n && entries[t->ncol];) t->ncol++;
    if (t->ncol == 0 || n % (t->ncol + 1) != 0) return -1;
    t->nrow = n / (t->ncol + 1) - 1;
    t->name = calloc((size_t)(n + 1), sizeof *t->name);
    if (!t->name) return -1;
    t->cell = t->name + t->ncol;
    for (int k = 0; k < n; k++) {
        int ends = k % (t->ncol + 1) == t->ncol;
        if (ends != (entries[k] == NULL)) return -1;
        if (!ends) t->name[k - k / (t->ncol + 1)] = entries[k];
    }
    return 0;
}

Table *table_read(const char *path, Fault *fault)
{
    FILE *f = fopen(path, "r");
    char *text = f ? read_text(f) : NULL, **entries = NULL;
    int error = errno;
    if (f) fclose(f);
    if (!text) {
        fault_set(fault, FAULT_MACHINE, "%s: %s", path, strerror(error));
        return NULL;
    }
    errno = 0;
    Table *t = calloc(1, sizeof *t);
    if (t) t->text = text;
    const int n = t ? split(text, &entries) : -1;
    if (n < 0 || fill(t, entries, n) != 0) {
        fault_set(fault, FAULT_MACHINE, "%s: %s", path,
                  errno ? strerror(errno) : "not a CSV table with equally long lines");
        if (!t) free(text);
        table_free(t);
        t = NULL;
    }
    free(entries);
    return t;
}

void table_free(Table *t)
{
    if (!t) return;
    free(t->name);
    free(t->text);
    free(t);
}

int table_column(const Table *t, const char *name)
{
    for (int k = 0; k < t->ncol; k++) /* most names differ in their first letter */
        if (t->name[k][0] == name[0] && strcmp(t->name[k], name) == 0) return k;
    return -1;
}

const char *table_text(const Table *t, int row, const char *name)
{
    int k = table_column(t, name);
    return k < 0 ? "" : t->cell[row * t->ncol + k];
}

double table_number(const Table *t, int row, const char *name)
{
    double x;
    return info_number_parse(table_text(t, row, name), &x) == 0 ? x : NAN;
}

void table_put_cell(FILE *out, const char *text)
{
    if (!text[strcspn(text, ",\"\r\n")]) {
        fputs(text, out);
        return;
    }
    putc('"', out);
    for (; *text; text++) {
        if (*text == '"') putc('"', out);
        putc(*text, out);
    }
    putc('"', out);
}

double table_order_fit(int n, const double x[], const double y[], double *err)
{
    double *lx = malloc(sizeof *lx * 2 * (size_t)(n > 0 ? n : 1));
    double slope = NAN, c0, c00, c01, c11 = NAN, sum;
    int m = 0;
    for (int k = 0; lx && k < n; k++) {
        if (!(x[k] > 0 && y[k] > 0 && isfinite(x[k]) && isfinite(y[k]))) continue;
        lx[m] = log(x[k]);
        lx[n + m++] = log(y[k]);
    }
    if (m >= 2) gsl_fit_linear(lx, 1, lx + n, 1, (size_t)m, &c0, &slope, &c00, &c01, &c11, &sum);
    if (err) *err = m > 2 ? sqrt(c11) : NAN; /* two points leave no residual */
    free(lx);
    return slope;
}

void table_part_path(char path[PATH_TEXT], const char *dir, const char *name, const char *part)
{
    snprintf(path, PATH_TEXT, "%s/%s%s%s.csv", dir, name, part ? "." : "", part ? part : "");
}

Table *table_read_part(const char *dir, const char *name, const char *part, Fault *fault)
{
    char path[PATH_TEXT];
    table_part_path(path, dir, name, part);
    return table_read(path, fault);
}
