/* curves.h: what several study pages share: curves and numbers out of a table, the squeeze's cases.
 *
 * `where` is a format that gives "column=value column=value ...": rows must meet all of them. */
#ifndef MPMLAB_CURVES_H
#define MPMLAB_CURVES_H

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

/* Largest |y/printed - 1| over the points {x, printed, weight}, each times its weight. */
Measure curve_deviation(const Curve *c, int n, const double printed[][3]);

/* Order: slope of log y against log x over the points with x in [from, to]; NAN if one of them is
 * not positive. */
Measure curve_order(const Curve *c, double from, double to, int needs);
double order_of_all(int n, const double x[], const double y[]);

/* The first such row's number in column `want`: one row. None if its run was lost. */
Measure select_value(const Table *rows, const char *want, const char *where, ...)
    __attribute__((format(printf, 3, 4)));

/* The same, of a run that was lost, too: how far it got, how it ended. */
Measure select_ended_value(const Table *rows, const char *want, const char *where, ...)
    __attribute__((format(printf, 3, 4)));

/* The number of a setting in the row's params; NAN if it is not there or a word. */
double select_setting(const Table *rows, int row, const char *setting);

/* Is this a method (or FEM) of the plane? */
bool method_known(const char *name);

/* Median of y[n] (GSL); sorts y. NAN of nothing. */
double select_median(int n, double y[]);

/* Did the run of this row end before its time? Energy growth alone does not end one. */
bool select_is_lost(const Table *rows, int row);

/* How many runs of those rows were lost, of `needs` that there must be. */
Measure count_lost(const Table *rows, int needs, const char *where);

/* A number of a row; NAN if its run was lost (tables without a column `status` know of none). */
double kept_number(const Table *rows, int row, const char *want);

/* The squeeze from 0.5 to 10 particles per cell, `step` particles apart (quick: 25 times that). */
void squeeze_add(Cases *list, const char *method, const char *field, int cells, int step,
                 bool quick);

/* Figs 6 and 9 of W07: the quadratic field on 1/100 cells, by these methods (ended by NULL), one
 * particle apart; and the error that the grid alone sets there, h^2/6/(1 + h)^2. */
enum { PLATEAU_CELLS = 100, PLATEAU_POINTS = 951 };
void plateau_add(Cases *list, const char *const names[], bool quick);
double plateau_error(void);

#endif
