/* measure.h: a number with the rows of tables that it was taken from. A claim names how many rows
 * it needs; with fewer, or with one row that has no number, it must not hold. */
#ifndef MPMLAB_MEASURE_H
#define MPMLAB_MEASURE_H

typedef struct Measure {
    double value; /* NAN as soon as one row has no number */
    int rows;     /* rows that gave a number */
    int needs;    /* rows that the claim names */
} Measure;

/* The larger of both; NAN if one is NAN, so that a maximum that met NAN once stays NAN. */
double measure_worse(double a, double b);
double measure_lesser(double a, double b); /* the smaller, likewise */

Measure measure(double value, int rows, int needs);
Measure measure_formula(double value); /* of a formula: needs no rows */

/* An empty maximum, minimum or sum, to which `needs` rows will be added. */
Measure measure_max_of(int needs);
Measure measure_min_of(int needs);
Measure measure_sum_of(int needs);

/* One more row. */
void measure_add_max(Measure *m, double x);
void measure_add_min(Measure *m, double x);
void measure_add(Measure *m, double x);

/* Of two measures; the result needs the rows of both. */
Measure measure_ratio(Measure a, Measure b);
Measure measure_max(Measure a, Measure b);
Measure measure_min(Measure a, Measure b);
Measure measure_sum(Measure a, Measure b);

/* The largest and the least of n measures; the result needs the rows of all. */
Measure measure_largest(int n, const Measure m[]);
Measure measure_least(int n, const Measure m[]);

/* The same rows, another unit; or another function of the number. */
Measure measure_times(Measure m, double factor);
Measure measure_with(Measure m, double value);

/* Median of y[n]; sorts y. NAN of nothing. */
double measure_median(int n, double y[]);

#endif
