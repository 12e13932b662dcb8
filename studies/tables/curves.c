/* curves.c: see curves.h. */
#include "curves.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_CONDITIONS = 8, WHERE_TEXT = 512 };

/* Splits text in place at spaces. */
static int split(char *text, const char *conditions[MOST_CONDITIONS])
{
    char *rest = text;
    int n = 0;
    for (char *word; n < MOST_CONDITIONS && (word = strtok_r(rest, " ", &rest));)
        conditions[n++] = word;
    return n;
}

/* The rows that meet `where` (a list of arguments in `args`): numbers of column x and y. */
static int pick(const Table *rows, const char *x, const char *y, bool kept, const char *where,
                va_list args, int most, double out_x[], double out_y[])
{
    const char *conditions[MOST_CONDITIONS];
    char text[WHERE_TEXT];
    int n = 0;
    vsnprintf(text, sizeof text, where, args);
    const int count = split(text, conditions);
    for (int row = 0; row < rows->nrow && n < most; row++) {
        if (!row_matches(rows, row, count, conditions)) continue;
        out_x[n] = table_number(rows, row, x);
        out_y[n++] = kept ? kept_number(rows, row, y) : table_number(rows, row, y);
    }
    return n;
}

void curve_pick(Curve *c, const Table *rows, const char *x, const char *y, const char *where, ...)
{
    va_list args;
    va_start(args, where);
    c->n = pick(rows, x, y, true, where, args, CURVE_MAX, c->x, c->y);
    va_end(args);
}

static Measure one(int found, double value)
{
    return measure(found ? value : NAN, found && !isnan(value), 1);
}

Measure select_value(const Table *rows, const char *want, const char *where, ...)
{
    double x, y = NAN;
    va_list args;
    va_start(args, where);
    const int found = pick(rows, want, want, true, where, args, 1, &x, &y);
    va_end(args);
    return one(found, y);
}

Measure select_ended_value(const Table *rows, const char *want, const char *where, ...)
{
    double x, y = NAN;
    va_list args;
    va_start(args, where);
    const int found = pick(rows, want, want, false, where, args, 1, &x, &y);
    va_end(args);
    return one(found, y);
}

double select_setting(const Table *rows, int row, const char *setting)
{
    const size_t n = strlen(setting);
    double value = NAN;
    for (const char *at = table_text(rows, row, "params"); *at;) {
        if (strncmp(at, setting, n) == 0 && at[n] == '=') {
            char *end;
            value = strtod(at + n + 1, &end);
            return *end == ';' || !*end ? value : NAN;
        }
        at += strcspn(at, ";");
        at += *at == ';';
    }
    return value;
}

Measure curve_at(const Curve *c, double x)
{
    for (int k = 0; k < c->n; k++)
        if (fabs(c->x[k] - x) <= 1e-12 * fabs(x)) return one(1, c->y[k]);
    return one(0, NAN);
}

Measure curve_max(const Curve *c, int needs)
{
    Measure most = largest_of(needs);
    for (int k = 0; k < c->n; k++) add_largest(&most, c->y[k]);
    return most;
}

Measure curve_settles(const Curve *c, double level, int needs)
{
    double from = NAN;
    for (int k = c->n - 1; k >= 0 && c->y[k] <= level; k--) from = c->x[k];
    return with_value(curve_max(c, needs), isnan(curve_max(c, needs).value) ? NAN : from);
}

Measure curve_deviation(const Curve *c, int n, const double printed[][3])
{
    Measure worst = largest_of(n);
    for (int k = 0; k < n; k++) {
        const Measure y = curve_at(c, printed[k][0]);
        add_largest(&worst, fabs(y.value / printed[k][1] - 1) * printed[k][2]);
    }
    return worst;
}

double order_of_all(int n, const double x[], const double y[])
{
    for (int k = 0; k < n; k++)
        if (!(x[k] > 0 && y[k] > 0 && isfinite(x[k]) && isfinite(y[k]))) return NAN;
    return table_order_fit(n, x, y, NULL);
}

Measure curve_order(const Curve *c, double from, double to, int needs)
{
    double x[CURVE_MAX], y[CURVE_MAX];
    int n = 0, numbers = 0;
    for (int k = 0; k < c->n; k++) {
        if (c->x[k] < from || c->x[k] > to) continue;
        numbers += !isnan(c->y[k]);
        x[n] = c->x[k], y[n++] = c->y[k];
    }
    return measure(order_of_all(n, x, y), numbers, needs);
}

bool method_known(const char *name)
{
    for (const Info *const *m = engine_2d.methods; *m; m++)
        if (strcmp((*m)->name, name) == 0) return true;
    return false;
}

double select_median(int n, double y[])
{
    if (n < 1) return NAN;
    gsl_sort(y, 1, (size_t)n);
    return gsl_stats_median_from_sorted_data(y, 1, (size_t)n);
}

bool select_is_lost(const Table *rows, int row)
{
    const char *status = table_text(rows, row, "status");
    return strcmp(status, "ok") != 0 && strcmp(status, "energy_growth") != 0;
}

Measure count_lost(const Table *rows, int needs, const char *where)
{
    const char *conditions[MOST_CONDITIONS];
    char text[WHERE_TEXT];
    Measure lost = sum_of(needs);
    snprintf(text, sizeof text, "%s", where);
    const int n = split(text, conditions);
    for (int row = 0; row < rows->nrow; row++)
        if (row_matches(rows, row, n, conditions)) add_sum(&lost, select_is_lost(rows, row));
    return lost;
}

double kept_number(const Table *rows, int row, const char *want)
{
    if (table_column(rows, "status") >= 0 && select_is_lost(rows, row)) return NAN;
    return table_number(rows, row, want);
}

void squeeze_add(Cases *list, const char *method, const char *field, int cells, int step,
                 bool quick)
{
    for (int n = cells / 2; n <= 10 * cells; n += quick ? 25 * step : step)
        case_add(list, "run squeeze --method %s --cells %d --set field=%s --set particles=%d",
                 method, cells, field, n);
}

void plateau_add(Cases *list, const char *const names[], bool quick)
{
    for (; *names; names++) squeeze_add(list, *names, "quadratic", PLATEAU_CELLS, 1, quick);
}

double plateau_error(void)
{
    const double h = 1 / (double)PLATEAU_CELLS;
    return h * h / 6 / pow(1 + h, 2);
}
