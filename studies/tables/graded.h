/* graded.h: projection in 1D onto cells that differ in size, or from particles that do; the cells
 * of the program itself are equal. */
#ifndef MPMLAB_GRADED_H
#define MPMLAB_GRADED_H

#include <stdbool.h>

/* In this order: tents; GIMP (the mean of a tent over a particle's length); each of the two with
 * the particle's gradient (W07 eq 4.1); a weighted least-squares fit, whose weight is the quadratic
 * spline over the mean size of a node's two cells. */
typedef enum GradedMethod {
    GRADED_TENT,
    GRADED_GIMP,
    GRADED_GE_TENT,
    GRADED_GE_GIMP,
    GRADED_FIT,
    GRADED_METHODS
} GradedMethod;
extern const char *const graded_names[GRADED_METHODS]; /* of the program's methods */

enum { GRADED_MOST = 192 };

/* A line of length 1, two particles per cell. */
typedef struct Graded {
    int n; /* cells */
    double x[GRADED_MOST + 1];
    double at[2 * GRADED_MOST], half[2 * GRADED_MOST]; /* particles: middle and half length */
} Graded;

/* n cells whose sizes are in the ratios 1, r, r^2, r^3, r^2, r, 1, ..., r = cells. The lengths of
 * the two particles in the first, third, ... cell have the ratio `sizes`; elsewhere they are equal.
 */
void graded_make(Graded *g, int n, double cells, double sizes);

/* Of particle p at node i. */
double graded_weight(const Graded *g, GradedMethod method, int i, int p);

/* Largest error of v = 1 + x or 1 + x^2 at nodes two cells and more inside. */
double graded_error(const Graded *g, GradedMethod method, bool quadratic);

#endif
