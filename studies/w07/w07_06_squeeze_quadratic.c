/* w07_06_squeeze_quadratic.c: projected error of a quadratic velocity field against particles per
 * cell. Wallstedt and Guilkey (2007), fig. 6.
 *
 * v = (1 + x)^2. More particles lower the error to a plateau that the grid alone sets: in the limit
 * the projection's error is h^2/12 v'' = h^2/6 (Vshivkov's second term, eq. 2.2), relative to v at
 * the first interior node h^2/6/(1 + h)^2; at a whole number k per cell it is 1 + 1/(2 k^2) times
 * that. */
#include "squeeze.h"
#include "studies/tables/curves.h"

static void cases(Cases *list, bool quick)
{
    squeeze_add_quadratic(list, "mpm gimp", quick);
}

static void check(Check *c, const Results *r)
{
    const double plateau = squeeze_plateau(), at_10 = 1 + 0.5 / 100;
    Curve mpm, gimp;
    claim_note(c, "plateau", plateau);
    curve_pick(&mpm, r->rows, "ppc", "error_linf", "method=mpm");
    curve_pick(&gimp, r->rows, "ppc", "error_linf", "method=gimp");
    claim(c, "W07-6.mpm-plateau", "MPM at 10 particles per cell, over h^2/6/(1+h)^2 (1 + 1/200)",
          measure_times(curve_at(&mpm, 10), 1 / (plateau * at_10)), 0.999, 1.001);
    claim(c, "W07-6.gimp-plateau", "GIMP does not lower the plateau: the same for GIMP",
          measure_times(curve_at(&gimp, 10), 1 / (plateau * at_10)), 0.999, 1.001);
    claim(c, "W07-6.gimp-settles",
          "GIMP stays within twice the plateau from this many particles per cell on",
          curve_settles(&gimp, 2 * plateau, SQUEEZE_POINTS), 2.55, 2.95);
    claim(c, "W07-6.mpm-settles", "MPM needs far more",
          curve_settles(&mpm, 2 * plateau, SQUEEZE_POINTS), 9.7, 10);
    claim(c, "W07-6.gimp-spot", "GIMP's error with 137 particles, an agreed value to six digits",
          curve_at(&gimp, 1.37), 2.173422e-4 - 5e-11, 2.173422e-4 + 5e-11);
}

const Study study_w07_06_squeeze_quadratic = {
    .name = "w07_06_squeeze_quadratic",
    .figure = "W07-6",
    .about = "squeeze, quadratic field: more particles lower the error to the grid's plateau only",
    .cases = cases,
    .check = check,
    .claims = 5,
};
