/* measure.c: see measure.h. */
#include "measure.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdbool.h>

double worse(double a, double b)
{
    if (isnan(a) || isnan(b)) return NAN;
    return a > b ? a : b;
}

double lesser(double a, double b)
{
    return -worse(-a, -b);
}

Measure measure(double value, int rows, int needs)
{
    return (Measure){value, rows, needs};
}

Measure closed_form(double value)
{
    return measure(value, 0, 0);
}

Measure largest_of(int needs)
{
    return measure(-INFINITY, 0, needs);
}

Measure least_of(int needs)
{
    return measure(INFINITY, 0, needs);
}

Measure sum_of(int needs)
{
    return measure(0, 0, needs);
}

void add_largest(Measure *m, double x)
{
    m->value = worse(m->value, x);
    m->rows += !isnan(x);
}

void add_least(Measure *m, double x)
{
    m->value = lesser(m->value, x);
    m->rows += !isnan(x);
}

void add_sum(Measure *m, double x)
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

Measure over(Measure a, Measure b)
{
    return both(a.value / b.value, a, b);
}

Measure largest(Measure a, Measure b)
{
    return both(worse(a.value, b.value), a, b);
}

Measure least(Measure a, Measure b)
{
    return both(lesser(a.value, b.value), a, b);
}

Measure sum(Measure a, Measure b)
{
    return both(a.value + b.value, a, b);
}

Measure times(Measure m, double factor)
{
    return with_value(m, m.value * factor);
}

Measure with_value(Measure m, double value)
{
    return measure(value, m.rows, m.needs);
}

double measure_median(int n, double y[])
{
    if (n < 1) return NAN;
    gsl_sort(y, 1, (size_t)n);
    return gsl_stats_median_from_sorted_data(y, 1, (size_t)n);
}
