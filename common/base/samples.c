/* samples.c: see samples.h. */
#include "samples.h"
#include <math.h>

/* Place and weight of point k along one axis; Gauss' are exact for polynomials of degree 7. */
static void point_on_axis(int k, bool gauss, double *x, double *weight)
{
    const int far = k == 0 || k == SAMPLES_AXIS - 1;
    const double root = sqrt(6.0 / 5), share = sqrt(30) / 36;
    const double out = sqrt(3.0 / 7 + (far ? 2.0 : -2.0) / 7 * root);
    *x = gauss ? 0.5 + (k < 2 ? -0.5 : 0.5) * out : (k + 0.5) / (double)SAMPLES_AXIS;
    *weight = gauss ? 0.5 * (0.5 + (far ? -share : share)) : 1.0 / (double)SAMPLES_AXIS;
}

static double distance_at(int axes, const double distance[], const double x[3])
{
    double sum = 0;
    for (int c = 0; c < 1 << axes; c++) {
        double S = 1;
        for (int d = 0; d < axes; d++) S *= c >> d & 1 ? x[d] : 1 - x[d];
        sum += S * distance[c];
    }
    return sum;
}

int samples_in_cell(int axes, const double distance[], bool gauss, double x[MOST_SAMPLES][3],
                    double weight[MOST_SAMPLES])
{
    int n = 0, total = 1;
    for (int d = 0; d < axes; d++) total *= SAMPLES_AXIS;
    for (int q = 0; q < total; q++) {
        int rest = q;
        x[n][1] = x[n][2] = 0;
        weight[n] = 1;
        for (int d = 0; d < axes; d++, rest /= SAMPLES_AXIS) {
            double own;
            point_on_axis(rest % SAMPLES_AXIS, gauss, &x[n][d], &own);
            weight[n] *= own;
        }
        n += distance_at(axes, distance, x[n]) > 0;
    }
    return n;
}
