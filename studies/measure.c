/* measure.c: see measure.h. */
#include "measure.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdbool.h>

double measure_worse(double a, double b)
{
    if (isnan(a) || isnan(b)) return NAN;
    return a > b ? a : b;
}

double measure_lesser(double a, double b)
{
    return -measure_worse(-a, -b);
}

Measure measure(double value, int rows, int needs)
{
    return (Measure){value, rows, needs};
}

Measure measure_formula(double value)
{
    return measure(value, 0, 0);
}

Measure measure_max_of(int needs)
{
    return measure(-INFINITY, 0, needs);
}

Measure measure_min_of(int needs)
{
    return measure(INFINITY, 0, needs);
}

Measure measure_sum_of(int needs)
{
    return measure(0, 0, needs);
}

void measure_add_max(Measure *m, double x)
{
    m->value = measure_worse(m->value, x);
    m->rows += !isnan(x);
}

void measure_add_min(Measure *m, double x)
{
    m->value = measure_lesser(m->value, x);
    m->rows += !isnan(x);
}

void measure_add(Measure *m, double x)
{
    m->value += x;
    m->rows += !isnan(x);
}

/* Rows that one of two has too many must not make up for those that the other lacks. */
static Measure both(double value, Measure a, Measure b)
{
    const int most_a = a.rows < a.needs ? a.rows : a.needs;
    const int most_b = b.rows < b.needs ? b.rows : b.needs;
    const bool whole = a.rows >= a.needs && b.rows >= b.needs;
    return measure(value, whole ? a.rows + b.rows : most_a + most_b, a.needs + b.needs);
}

Measure measure_ratio(Measure a, Measure b)
{
    return both(a.value / b.value, a, b);
}

Measure measure_max(Measure a, Measure b)
{
    return both(measure_worse(a.value, b.value), a, b);
}

Measure measure_min(Measure a, Measure b)
{
    return both(measure_lesser(a.value, b.value), a, b);
}

Measure measure_largest(int n, const Measure m[])
{
    Measure out = m[0];
    for (int k = 1; k < n; k++) out = measure_max(out, m[k]);
    return out;
}

Measure measure_least(int n, const Measure m[])
{
    Measure out = m[0];
    for (int k = 1; k < n; k++) out = measure_min(out, m[k]);
    return out;
}

Measure measure_sum(Measure a, Measure b)
{
    return both(a.value + b.value, a, b);
}

Measure measure_times(Measure m, double factor)
{
    return measure_with(m, m.value * factor);
}

Measure measure_with(Measure m, double value)
{
    return measure(value, m.rows, m.needs);
}

double measure_median(int n, double y[])
{
    if (n < 1) return NAN;
    gsl_sort(y, 1, (size_t)n);
    return gsl_stats_median_from_sorted_data(y, 1, (size_t)n);
}
