/* w07_05_squeeze_linear.c: how well particles report a linear velocity field to the grid when their
 * number per cell is anything but convenient. Wallstedt and Guilkey (2007), fig. 5.
 *
 * N particles fill 100 cells evenly and carry v = 1 + x. Both methods are exact where a whole
 * number of particles (or a half one) meets every cell, and wrong in between; the worst between two
 * such points falls with the particles per cell as PPC^-2 (MPM) and PPC^-3 (GIMP). */
#include <math.h>
#include <string.h>
#include "study.h"

static const char *const methods[] = {"mpm", "gimp"};
enum { CELLS = 100, FEWEST = 50, MOST = 1000, POINTS = MOST - FEWEST + 1 };

static void cases(Cases *list, bool quick)
{
    for (int m = 0; m < 2; m++)
        for (int n = FEWEST; n <= MOST; n += quick ? 25 : 1)
            case_add(list,
                     "run squeeze --method %s --cells %d --set field=linear --set particles=%d",
                     methods[m], CELLS, n);
}

/* The error of a method against its particles per cell; returns how many points. */
static int curve(const Table *rows, const char *method, double ppc[POINTS], double error[POINTS])
{
    char condition[64];
    const char *const where[] = {condition};
    snprintf(condition, sizeof condition, "method=%s", method);
    rows_pick(rows, 1, where, "ppc", POINTS, ppc);
    return rows_pick(rows, 1, where, "error_linf", POINTS, error);
}

/* Exponent of the local maxima over PPC 2..10: one maximum in each interval of this width. */
static double exponent(int n, const double ppc[], const double error[], double width)
{
    double at[MOST] = {0}, worst[MOST] = {0};
    int intervals = (int)lround(8 / width);
    for (int k = 0; k < n; k++) {
        int i = (int)floor((ppc[k] - 2) / width);
        if (ppc[k] < 2 || i >= intervals || error[k] <= worst[i]) continue;
        worst[i] = error[k];
        at[i] = ppc[k];
    }
    return order_fit(intervals, at, worst, NULL);
}

/* The largest error at the 20 whole and half PPC; NAN if one of them is missing. */
static double worst_zero(int n, const double ppc[], const double error[])
{
    double worst = 0;
    int found = 0;
    for (int k = 0; k < n; k++) {
        if (fabs(2 * ppc[k] - round(2 * ppc[k])) > 1e-9) continue;
        worst = fmax(worst, error[k]);
        found++;
    }
    return found == 20 ? worst : NAN;
}

static void check(Check *c, const Table *rows, const char *dir)
{
    double ppc[POINTS], error[POINTS];
    (void)dir;
    int n = curve(rows, "mpm", ppc, error);
    claim(c, "W07-5.mpm-exponent", "MPM's worst errors fall as PPC^-2", exponent(n, ppc, error, .5),
          -2.1, -1.9);
    claim(c, "W07-5.mpm-zeros", "MPM is exact at whole and half particles per cell",
          worst_zero(n, ppc, error), 0, 1e-13);
    n = curve(rows, "gimp", ppc, error);
    claim(c, "W07-5.gimp-exponent", "GIMP's worst errors fall as PPC^-3",
          exponent(n, ppc, error, 1), -3.1, -2.9);
    claim(c, "W07-5.gimp-zeros", "GIMP is exact at whole and half particles per cell",
          worst_zero(n, ppc, error), 0, 1e-13);
}

const Study study_w07_05_squeeze_linear = {
    .name = "w07_05_squeeze_linear",
    .figure = "W07-5",
    .about = "squeeze, linear field: error of projected velocity against particles per cell",
    .cases = cases,
    .check = check,
};
