/* spline.h: the quadratic spline, by which WLS weighs particles (W11 eq 4). */
#ifndef MPMLAB_SPLINE_H
#define MPMLAB_SPLINE_H

#include <math.h>

/* Of a distance in cells. */
static inline double spline_quadratic(double r)
{
    const double a = fabs(r);
    return a < 0.5 ? 0.75 - a * a : a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0;
}

#endif
