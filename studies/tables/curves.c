/* curves.c: see curves.h. */
#include "curves.h"

#include <math.h>

void curve_pick(Curve *c, const Table *rows, const char *x, const char *y, const char *where, ...)
{
    char text[512];
    PHRASE_INTO(text, where);
    c->n = 0;
    for (int row = -1; c->n < CURVE_MAX && (row = select_next(rows, row, "%s", text)) >= 0;
         c->n++) {
        c->x[c->n] = select_number(rows, row, x);
        c->y[c->n] = select_kept(rows, row, y);
    }
}

Measure curve_at(const Curve *c, double x)
{
    for (int k = 0; k < c->n; k++)
        if (fabs(c->x[k] - x) <= 1e-12 * fabs(x)) return measure(c->y[k], !isnan(c->y[k]), 1);
    return measure(NAN, 0, 1);
}

Measure curve_max(const Curve *c, int needs)
{
    Measure most = measure_max_of(needs);
    for (int k = 0; k < c->n; k++) measure_add_max(&most, c->y[k]);
    return most;
}

Measure curve_settles(const Curve *c, double level, int needs)
{
    double from = NAN;
    for (int k = c->n - 1; k >= 0 && c->y[k] <= level; k--) from = c->x[k];
    return measure_with(curve_max(c, needs), isnan(curve_max(c, needs).value) ? NAN : from);
}

Measure curve_deviation(const Curve *c, double first, int n, const double printed[], double last)
{
    Measure worst = measure_max_of(n);
    for (int k = 0; k < n; k++, first *= 2)
        measure_add_max(&worst,
                        fabs(curve_at(c, first).value / printed[k] - 1) * (k == n - 1 ? last : 1));
    return worst;
}

double curve_slope(int n, const double x[], const double y[])
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
    return measure(curve_slope(n, x, y), numbers, needs);
}

Measure curve_order_in_h(const Table *rows, const char *error, double from, double to, int needs,
                         const char *where, ...)
{
    Curve c;
    char text[512];
    PHRASE_INTO(text, where);
    curve_pick(&c, rows, "cells", error, "%s", text);
    return measure_times(curve_order(&c, from, to, needs), -1);
}

Measure curve_worst(const Table *t, const char *methods, int each, const char *want,
                    const char *where)
{
    Measure worst = {0};
    EACH_WORD(m, methods) {
        Curve c;
        curve_pick(&c, t, want, want, "method=%s %s", m, where);
        const Measure most = c.n ? curve_max(&c, each) : measure(NAN, 0, each);
        worst = worst.needs ? measure_max(worst, most) : most;
    }
    return worst;
}

Measure curve_mean_ratio(const Curve *a, const Curve *b, int needs)
{
    Measure mean = measure_sum_of(2 * needs);
    for (int k = 0; k < a->n; k++) {
        const Measure own = measure(a->y[k], !isnan(a->y[k]), 1);
        const Measure ratio = measure_ratio(own, curve_at(b, a->x[k]));
        mean.value += ratio.value / (double)needs;
        mean.rows += ratio.rows;
    }
    return mean;
}

Measure curve_least(const Table *t, const char *methods, int each, const char *want,
                    const char *where)
{
    Measure least = measure_min_of(0);
    EACH_WORD(m, methods)
        least = measure_min(least, select_min(t, want, each, "method=%s %s", m, where));
    return least;
}

void curve_add(Curve *c, double x, Measure y)
{
    if (y.rows < y.needs || c->n == CURVE_MAX) return;
    c->x[c->n] = x;
    c->y[c->n++] = y.value;
}

double curve_growth(const Table *t, const char *column)
{
    return t->nrow > 1 ? select_last(t, column) / select_number(t, 0, column) : NAN;
}

double curve_first_change(const Table *t, const char *column, double share)
{
    for (int row = 0; row < t->nrow; row++)
        if (fabs(select_number(t, row, column) / select_number(t, 0, column) - 1) > share)
            return select_number(t, row, "t");
    return NAN;
}

double curve_rate(const Table *t, const char *column, double from)
{
    const double t1 = select_last(t, "t"), x1 = select_last(t, column);
    double t0 = NAN, x0 = NAN;
    for (int row = 0; row < t->nrow && select_number(t, row, "t") <= from * t1; row++) {
        t0 = select_number(t, row, "t");
        x0 = select_number(t, row, column);
    }
    return (x1 - x0) / (t1 - t0);
}

Measure curve_lost(const Table *t, const char *methods, int each, const char *where)
{
    Measure lost = measure_sum_of(0);
    EACH_WORD(m, methods)
        lost = measure_sum(lost, select_count_lost(t, each, phrase("method=%s %s", m, where)));
    return lost;
}
