/* sweep.c: see sweep.h. Case k has the digits of k as its values, the last axis running fastest. */
#include "sweep.h"

#include <math.h>
#include <string.h>
#include "../common/info.h"
#include "pages.h"

enum { MOST_TICS = 12 };

static bool is_numeric(const List *list)
{
    double x;
    for (int k = 0; k < list->n; k++)
        if (number_parse(list->value[k], &x)) return false;
    return list->n > 0;
}

void sweep_arrange(Sweep *s)
{
    s->across = -1;
    for (int k = 0; k < s->n; k++)
        if (s->axis[k].list.n > 1 && is_numeric(&s->axis[k].list) &&
            (s->across < 0 || s->axis[k].list.n > s->axis[s->across].list.n))
            s->across = k;
    if (s->across < 0) return;
    const Axis last = s->axis[s->n - 1];
    s->axis[s->n - 1] = s->axis[s->across];
    s->axis[s->across] = last;
    s->across = s->n - 1;
}

double sweep_size(const Sweep *s)
{
    double size = 1;
    for (int k = 0; k < s->n; k++) size *= s->axis[k].list.n;
    return size;
}

/* The value of axis a in case k. */
static const char *value_of(const Sweep *s, int a, int k)
{
    for (int b = s->n - 1; b > a; b--) k /= s->axis[b].list.n;
    return s->axis[a].list.value[k % s->axis[a].list.n];
}

void sweep_case(const Sweep *s, int k, char text[], size_t size)
{
    size_t at = (size_t)snprintf(text, size, "run %s", s->problem);
    for (int a = 0; a < s->n && at < size; a++) {
        const Axis *x = &s->axis[a];
        const bool setting = strcmp(x->option, "set") == 0;
        at += (size_t)snprintf(text + at, size - at, " --%s %s%s%s", x->option,
                               setting ? x->name : "", setting ? "=" : "", value_of(s, a, k));
    }
}

/* What case k has that other curves have not: "gimp, cfl 0.1". */
static void title(const Sweep *s, int k, char text[256])
{
    size_t at = 0;
    text[0] = '\0';
    for (int a = 0; a < s->n && at < 256; a++) {
        const Axis *x = &s->axis[a];
        const char *name = is_numeric(&x->list) ? x->name : "";
        if (a == s->across || x->list.n < 2) continue;
        at += (size_t)snprintf(text + at, 256 - at, "%s%s%s%s", at ? "; " : "", name,
                               *name ? " " : "", value_of(s, a, k));
    }
    if (!text[0]) snprintf(text, 256, "%s", s->problem);
}

typedef struct Curves {
    const Sweep *sweep;
    const Table *rows;
    const char *x, *y; /* names */
    int length;        /* cases of one curve */
} Curves;

static double x_of(const Curves *c, int row)
{
    double x = row;
    if (c->sweep->across >= 0) number_parse(value_of(c->sweep, c->sweep->across, row), &x);
    return x;
}

static double y_of(const Curves *c, int row)
{
    return fabs(table_number(c->rows, row, c->y));
}

/* Slope of log y over log x; over cells its negative: the order in h. */
static double order_of(const Curves *c, int first, double *error)
{
    double x[LIST_MAX], y[LIST_MAX];
    int n = 0;
    for (int row = first; row < first + c->length; row++) {
        if (is_lost(c->rows, row)) continue;
        x[n] = x_of(c, row);
        y[n++] = y_of(c, row);
    }
    *error = NAN;
    const double slope = c->sweep->across < 0 ? NAN : order_fit(n, x, y, error);
    return strcmp(c->x, "cells") == 0 ? -slope : slope;
}

static void number(FILE *f, double x, const char *after)
{
    if (isfinite(x)) fprintf(f, "%.10g", x);
    fputs(after, f);
}

static int write_curves(const Curves *c, const char *path, Fault *fault)
{
    FILE *f = file_begin(path, fault);
    if (!f) return FAULT_MACHINE;
    fprintf(f, "series,%s,%s,status\n", c->x, c->y);
    for (int row = 0; row < c->rows->nrow; row++) {
        fprintf(f, "%d,", row / c->length);
        number(f, x_of(c, row), ",");
        number(f, y_of(c, row), ",");
        fprintf(f, "%s\n", table_text(c->rows, row, "status"));
    }
    return file_commit(f, path, fault);
}

static int write_orders(const Curves *c, const char *path, Fault *fault)
{
    FILE *f = file_begin(path, fault);
    char text[256];
    double error;
    if (!f) return FAULT_MACHINE;
    fputs("series,curve,along,quantity,cases,lost,order,order_error\n", f);
    for (int first = 0; first < c->rows->nrow; first += c->length) {
        int lost = 0;
        for (int row = first; row < first + c->length; row++) lost += is_lost(c->rows, row);
        title(c->sweep, first, text);
        fprintf(f, "%d,", first / c->length);
        csv_cell(f, text);
        fprintf(f, ",%s,%s,%d,%d,", c->x, c->y, c->length, lost);
        const double order = order_of(c, first, &error);
        number(f, order, ",");
        number(f, error, "\n");
    }
    return file_commit(f, path, fault);
}

/* Does x cover a factor of four, from above 0? */
static bool is_wide(const Curves *c)
{
    double low = INFINITY, high = -INFINITY;
    for (int row = 0; row < c->length; row++) {
        low = fmin(low, x_of(c, row));
        high = fmax(high, x_of(c, row));
    }
    return c->sweep->across >= 0 && low > 0 && high >= 4 * low;
}

static int write_names(const Curves *c, const char *path, Fault *fault)
{
    FILE *f = file_begin(path, fault);
    if (!f) return FAULT_MACHINE;
    fprintf(f, "problem = '%s'\nx_name = '%s'\ny_name = '%s'\nx_log = %d\nx_tics = '",
            c->sweep->problem, c->x, c->y, is_wide(c));
    for (int row = 0; row < c->length && c->sweep->across >= 0 && c->length <= MOST_TICS; row++)
        number(f, x_of(c, row), row + 1 < c->length ? ", " : "");
    fputs("'\n", f);
    return file_commit(f, path, fault);
}

int sweep_tables(const Sweep *sweep, const char *dir, const char *name, Fault *fault)
{
    char path[PATH_TEXT];
    Table *rows = part_read(dir, name, NULL, fault);
    if (!rows) return FAULT_MACHINE;
    const bool exact = rows->nrow && *table_text(rows, 0, "error_linf");
    Curves c = {sweep, rows, "case", exact ? "error_linf" : "energy_drift", rows->nrow};
    if (sweep->across >= 0) {
        c.x = sweep->axis[sweep->across].name;
        c.length = sweep->axis[sweep->across].list.n;
    }
    part_path(path, dir, name, "curves");
    int code = write_curves(&c, path, fault);
    part_path(path, dir, name, "orders");
    if (code == 0) code = write_orders(&c, path, fault);
    snprintf(path, sizeof path, "%s/%s.var", dir, name);
    if (code == 0) code = write_names(&c, path, fault);
    table_free(rows);
    return code;
}
