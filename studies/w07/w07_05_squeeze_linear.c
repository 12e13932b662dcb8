/* w07_05_squeeze_linear.c: how well particles report a linear velocity field to the grid when their
 * number per cell is anything but convenient. Wallstedt and Guilkey (2007), fig. 5.
 *
 * N particles fill 100 cells evenly and carry v = 1 + x. Both methods are exact where a whole
 * number of particles (or a half one) meets every cell, and wrong in between; the worst between two
 * such points falls with the particles per cell as PPC^-2 (MPM) and PPC^-3 (GIMP). */
#include <math.h>
#include "squeeze.h"

static const char *const methods[] = {"mpm", "gimp"};

static void cases(Cases *list, bool quick)
{
    for (int m = 0; m < 2; m++) squeeze_add(list, methods[m], "linear", SQUEEZE_CELLS, 1, quick);
}

/* The largest error at the 20 whole and half PPC. */
static Measure worst_zero(const Curve *c)
{
    Measure worst = measure_max_of(20);
    for (int k = 0; k < c->n; k++)
        if (fabs(2 * c->x[k] - round(2 * c->x[k])) <= 1e-9) measure_add_max(&worst, c->y[k]);
    return worst;
}

/* At how many of all numbers of particles is GIMP's error the smaller one? */
static Measure share_better(const Curve *gimp, const Curve *mpm)
{
    Measure n = measure_sum_of(SQUEEZE_POINTS);
    for (int k = 0; k < gimp->n; k++) {
        const Measure other = curve_at(mpm, gimp->x[k]);
        measure_add(&n, isnan(gimp->y[k] + other.value) ? NAN : gimp->y[k] < other.value);
    }
    return measure_times(n, 1 / (double)SQUEEZE_POINTS);
}

static void check(Check *c, const Results *r)
{
    Curve curve, mpm;
    curve_pick(&mpm, r->rows, "ppc", "error_linf", "method=mpm");
    curve = mpm;
    claim(c, "W07-5.significant",
          "Squeeze, linear field: the projection has an error: MPM's largest",
          curve_max(&mpm, SQUEEZE_POINTS), 0.005, 0.02);
    claim(c, "W07-5.mpm-exponent", "Squeeze, linear field: MPM's worst errors fall as PPC^-2",
          squeeze_exponent(&curve, .5, 0), -2.1, -1.9);
    claim(c, "W07-5.mpm-zeros",
          "Squeeze, linear field: MPM is exact at whole and half particles per cell",
          worst_zero(&curve), 0, 1e-13);
    curve_pick(&curve, r->rows, "ppc", "error_linf", "method=gimp");
    claim(c, "W07-5.gimp-better",
          "Squeeze, linear field: GIMP projects better than MPM: at what share of all numbers of "
          "particles",
          share_better(&curve, &mpm), 0.95, 1);
    claim(c, "W07-5.gimp-exponent", "Squeeze, linear field: GIMP's worst errors fall as PPC^-3",
          squeeze_exponent(&curve, 1, 0), -3.1, -2.9);
    claim(c, "W07-5.gimp-zeros",
          "Squeeze, linear field: GIMP is exact at whole and half particles per cell",
          worst_zero(&curve), 0, 1e-13);
}

const StudyPage study_w07_05_squeeze_linear = {.cases = cases, .check = check, .claims = 6};
