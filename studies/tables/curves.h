/* curves.h: one column of a table against another; orders, plateaus, departures from printed
 * values. `where`: see select.h. */
#ifndef MPMLAB_CURVES_H
#define MPMLAB_CURVES_H

#include "studies/runs/engines.h"
#include "studies/select.h"
#include "studies/study.h"

enum { CURVE_MAX = 1024 };

typedef struct Curve {
    int n;
    double x[CURVE_MAX], y[CURVE_MAX];
} Curve;

/* Column y against column x, in the table's order. y is NAN in rows of runs that were lost. */
void curve_pick(Curve *c, const Table *rows, const char *x, const char *y, const char *where, ...)
    __attribute__((format(printf, 5, 6)));

Measure curve_at(const Curve *c, double x); /* y at just this x: one row */
Measure curve_max(const Curve *c, int needs);

/* The least x of the curve from which on every y is at most level; NAN if the last is above it. */
Measure curve_settles(const Curve *c, double level, int needs);

/* Largest |y/printed - 1| at the n points x = first, 2 first, 4 first, ...; the deviation of the
 * last point is multiplied by `last`. */
Measure curve_deviation(const Curve *c, double first, int n, const double printed[], double last);

/* Mean over a's points of a's y over b's at the same x; `needs` points of each. */
Measure curve_mean_ratio(const Curve *a, const Curve *b, int needs);

/* Order: slope of log y against log x over the points with x in [from, to]; NAN if one of them is
 * not positive. curve_slope: of n points. */
Measure curve_order(const Curve *c, double from, double to, int needs);
double curve_slope(int n, const double x[], const double y[]);

/* Order in h of a column of errors, fitted over the rows with N = from .. to cells per unit length.
 */
Measure curve_order_in_h(const Table *rows, const char *error, double from, double to, int needs,
                         const char *where, ...) __attribute__((format(printf, 6, 7)));

/* Largest of column `want` over the rows of these methods ("gimp wls") that also meet `where`,
 * `each` of them of every method; NAN if one of them has no such row, was lost, or is NAN. */
Measure curve_worst(const Table *t, const char *methods, int each, const char *want,
                    const char *where);

/* The least one, likewise. */
Measure curve_least(const Table *t, const char *methods, int each, const char *want,
                    const char *where);

/* Adds a point, unless y lacks rows that it needs. */
void curve_add(Curve *c, double x, Measure y);

/* A column in the last row over that in the first; NAN with fewer than two rows. */
double curve_growth(const Table *t, const char *column);

/* First time [s] in a history at which the column differs from its first value by more than `share`
 * times that value; NAN: never. */
double curve_first_change(const Table *t, const char *column, double share);

/* Mean rate of change [1/s] of a column of a history, between the last row with t <= from t_end and
 * the last row, at t_end. */
double curve_rate(const Table *t, const char *column, double from);

/* How many rows of these methods that also meet `where` were lost; there are `each` of a method. */
Measure curve_lost(const Table *t, const char *methods, int each, const char *where);

#endif
