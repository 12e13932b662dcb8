/* sweep_tables.c: the curves of a sweep, their orders, and what the figure must know of them. */
#include <math.h>
#include <string.h>
#include "common/base/info.h"
#include "studies/select.h"
#include "sweep.h"

enum { MOST_TICS = 12, REASON_TEXT = 128 };

typedef struct Curves {
    const Sweep *sweep;
    const Table *rows;
    const char *x, *y; /* names */
    int length;        /* combinations of one curve; some may have no row */
} Curves;

/* Rows first .. first + n - 1 are one curve. */
typedef struct Part {
    int series, first, n;
} Part;

/* Steps on to the next curve; a zeroed Part comes before the first. */
static bool next_part(const Curves *c, Part *p)
{
    const int *choice = c->sweep->choice;
    p->series += p->n > 0;
    p->first += p->n;
    for (p->n = 0; p->first + p->n < c->rows->nrow; p->n++)
        if (choice[p->first + p->n] / c->length != choice[p->first] / c->length) break;
    return p->n > 0;
}

static double asked(const Curves *c, int row)
{
    double x = row;
    if (c->sweep->across >= 0)
        info_number_parse(sweep_value(c->sweep, c->sweep->across, c->sweep->choice[row]), &x);
    return x;
}

/* The real value, where the row has it: particles per cell are what fits into the body. */
static double x_of(const Curves *c, int row)
{
    static const char *const columns[] = {"cells", "ppc", "cfl", "particles", "t_end"};
    const char *column = strcmp(c->x, "t-end") == 0 ? "t_end" : c->x;
    double x = NAN;
    for (size_t k = 0; k < sizeof columns / sizeof *columns; k++)
        if (strcmp(columns[k], column) == 0) x = select_number(c->rows, row, column);
    if (strcmp(column, "steps") == 0 && !select_is_lost(c->rows, row))
        x = select_number(c->rows, row, column);
    return isfinite(x) ? x : asked(c, row);
}

static double y_of(const Curves *c, int row)
{
    return select_number(c->rows, row, c->y);
}

static bool has_any(const Table *rows, const char *column)
{
    for (int row = 0; row < rows->nrow; row++)
        if (isfinite(select_number(rows, row, column))) return true;
    return false;
}

/* Errors if any row has one: those of other rows are unknown or lost, not another quantity. */
static const char *quantity(const Table *rows)
{
    const bool exact = has_any(rows, "error_linf") || !has_any(rows, "energy_drift");
    return exact ? "error_linf" : "energy_drift";
}

typedef struct Order {
    double slope, error; /* NAN: none */
    int lost;
    char reason[REASON_TEXT]; /* why there is none, or what was left out */
} Order;

/* What a curve's finished runs have in common, and not. */
typedef struct Sums {
    double x[LIST_MAX], y[LIST_MAX]; /* points above 0 */
    int n, finished, zeros, below, above;
    bool x_above, x_differs, same_end;
    double end; /* [s] */
} Sums;

static void add_row(const Curves *c, int row, Sums *s)
{
    const double y = y_of(c, row), steps = select_number(c->rows, row, "steps");
    const double at = steps * select_number(c->rows, row, "dt"), end = isfinite(at) ? at : 0;
    if (s->finished++ == 0) s->end = end;
    s->same_end = s->same_end && fabs(end - s->end) <= 1e-9 * fabs(s->end);
    s->zeros += !(fabs(y) > 0) && isfinite(y);
    if (!isfinite(y) || !(fabs(y) > 0) || s->n == LIST_MAX) return;
    s->below += y < 0;
    s->above += y > 0;
    s->x[s->n] = x_of(c, row);
    s->y[s->n] = fabs(y);
    s->x_differs = s->x_differs || fabs(s->x[s->n] - s->x[0]) > 0;
    s->n++;
}

static Sums sums_of(const Curves *c, const Part *p)
{
    Sums s = {.x_above = true, .same_end = true};
    for (int row = p->first; row < p->first + p->n; row++) {
        s.x_above = s.x_above && x_of(c, row) > 0;
        if (!select_is_lost(c->rows, row)) add_row(c, row, &s);
    }
    return s;
}

/* Why no slope can be fitted, or "". */
static void why_none(const Curves *c, const Sums *s, char why[REASON_TEXT])
{
    why[0] = '\0';
    if (c->sweep->across < 0)
        snprintf(why, REASON_TEXT, "no option has several numbers");
    else if (s->finished == 0)
        snprintf(why, REASON_TEXT, "every run is lost");
    else if (s->zeros == s->finished)
        snprintf(why, REASON_TEXT, "%s is exactly 0", c->y);
    else if (!s->x_above)
        snprintf(why, REASON_TEXT, "%.40s is not above 0 everywhere", c->x);
    else if (select_is_word("cells ppc cfl particles", c->x) && !s->same_end) /* it refines */
        snprintf(why, REASON_TEXT, "runs end at different times; --t-end T makes them equal");
    else if (s->below && s->above)
        snprintf(why, REASON_TEXT, "%s changes its sign", c->y);
    else if (s->n < 2)
        snprintf(why, REASON_TEXT, "fewer than two finished runs have a value other than 0");
    else if (!s->x_differs)
        snprintf(why, REASON_TEXT, "all runs have the same %.40s", c->x);
}

/* Slope of log |y| over log x; over cells its negative: the order in h. */
static Order order_of(const Curves *c, const Part *p)
{
    const Sums s = sums_of(c, p);
    Order o = {.slope = NAN, .error = NAN, .lost = p->n - s.finished};
    why_none(c, &s, o.reason);
    if (o.reason[0]) return o;
    o.slope = table_order_fit(s.n, s.x, s.y, &o.error);
    if (strcmp(c->x, "cells") == 0) o.slope = -o.slope;
    if (s.n < s.finished)
        snprintf(o.reason, REASON_TEXT, "fitted without %d runs whose %s is 0 or empty",
                 s.finished - s.n, c->y);
    return o;
}

typedef struct Range {
    double low, high; /* NAN both of nothing */
} Range;

static void widen(Range *r, double value)
{
    r->low = fmin(r->low, value); /* fmin and fmax pass over NAN */
    r->high = fmax(r->high, value);
}

static void write_curves(FILE *f, const Curves *c)
{
    for (Part p = {0}; next_part(c, &p);)
        for (int row = p.first; row < p.first + p.n; row++)
            results_print(f, "%d,%.10g,%.10g,%s\n", p.series, x_of(c, row), y_of(c, row),
                          select_text(c->rows, row, "status"));
}

/* The values that a curve's runs share, as asked for; where another number of particles fits into
 * the body, that number per cell, too. */
static void curve_title(const Curves *c, const Part *p, char text[256])
{
    const int first = c->sweep->choice[p->first];
    const double ppc = sweep_asked_ppc(c->sweep, first);
    Range real = {NAN, NAN};
    snprintf(text, 256, "%s", c->sweep->problem);
    if (c->sweep->across >= 0) sweep_title(c->sweep, first, text);
    for (int row = p->first; row < p->first + p->n; row++)
        widen(&real, select_number(c->rows, row, "ppc"));
    const size_t at = strlen(text);
    if (fmax(fabs(real.low - ppc), fabs(real.high - ppc)) > 1e-9)
        snprintf(text + at, 256 - at, " (really %.4g to %.4g)", real.low, real.high);
}

static void write_orders(FILE *f, const Curves *c)
{
    char text[256];
    for (Part p = {0}; next_part(c, &p);) {
        const Order o = order_of(c, &p);
        curve_title(c, &p, text);
        fprintf(f, "%d,", p.series);
        table_put_cell(f, text);
        results_print(f, ",%s,%s,%d,%d,%.10g,%.10g,", c->x, c->y, p.n, o.lost, o.slope, o.error);
        if (o.reason[0])
            table_put_cell(f, o.reason);
        else
            fputs("\"\"", f); /* gnuplot reads an empty last cell as part of another */
        putc('\n', f);
    }
}

/* Finds the ranges of x, and of |y| above 0, in finished runs. */
static void find_ranges(const Curves *c, Range *x, Range *y)
{
    *x = *y = (Range){NAN, NAN};
    for (int row = 0; row < c->rows->nrow; row++) {
        const double value = fabs(y_of(c, row));
        widen(x, x_of(c, row));
        if (!select_is_lost(c->rows, row) && value > 0 && isfinite(value)) widen(y, value);
    }
}

/* Where the values that were asked for are the real ones, they are the tics; without numbers the
 * combinations are. */
static void write_tics(FILE *f, const Curves *c)
{
    const int across = c->sweep->across;
    char text[256];
    bool real = true;
    for (int row = 0; row < c->rows->nrow; row++)
        real = real && !(fabs(x_of(c, row) - asked(c, row)) > 0);
    if (!real || c->length > MOST_TICS) return;
    if (across < 0)
        for (int row = 0; row < c->rows->nrow; row++) {
            sweep_title(c->sweep, c->sweep->choice[row], text);
            fprintf(f, "%s\"%s\" %d", row ? ", " : "", text, row);
        }
    else
        for (int k = 0; k < c->sweep->axis[across].list.n; k++) {
            double x = 0; /* gnuplot reads 08 as octal */
            info_number_parse(c->sweep->axis[across].list.value[k], &x);
            fprintf(f, "%s%.10g", k ? ", " : "", x);
        }
}

static void write_names(FILE *f, const Curves *c)
{
    Range x, y;
    find_ranges(c, &x, &y);
    fprintf(f, "problem = '%s'\nx_name = '%s'\ny_name = '%s'\nnumeric = %d\nx_log = %d\n",
            c->sweep->problem, c->x, c->y, c->sweep->across >= 0,
            c->sweep->across >= 0 && x.low > 0 && x.high >= 4 * x.low);
    fprintf(f, "x_low = %.10g\nx_high = %.10g\ny_log = %d\ny_low = %.10g\ny_high = %.10g\n", x.low,
            x.high, y.high > 0, y.high > 0 ? y.low : 0, y.high > 0 ? y.high : 0);
    fputs("x_tics = '", f);
    write_tics(f, c);
    fputs("'\n", f);
}

/* Notes runs that had fewer steps than --set steps=N, because they end at t_end in any case. */
static void note_steps(const Table *rows)
{
    int n = 0;
    for (int row = 0; row < rows->nrow; row++)
        n += strcmp(select_text(rows, row, "status"), "ok") == 0 &&
             select_number(rows, row, "set.steps") > select_number(rows, row, "steps");
    if (n)
        fprintf(stderr, "mpmlab: %d of %d runs reached t_end before the steps of --set steps\n", n,
                rows->nrow);
}

void sweep_tables(const Sweep *sweep, const Results *r)
{
    char header[160];
    Curves c = {sweep, r->rows, "case", quantity(r->rows), (int)sweep_size(sweep)};
    if (sweep->across >= 0) {
        c.x = sweep->axis[sweep->across].name;
        c.length = sweep->axis[sweep->across].list.n;
    }
    snprintf(header, sizeof header, "series,%s,%s,status", c.x, c.y);
    write_curves(results_write(r, "curves", header), &c);
    write_orders(results_write(r, "orders",
                               "series,curve,along,quantity,cases,lost,order,order_error,reason"),
                 &c);
    write_names(results_write_notes(r), &c);
    note_steps(r->rows);
}
