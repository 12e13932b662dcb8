/* w07_06_squeeze_quadratic.c: projected error of a quadratic velocity field against particles per
 * cell. Wallstedt and Guilkey (2007), fig. 6.
 *
 * v = (1 + x)^2. More particles lower the error to a plateau that the grid alone sets: in the limit
 * the projection's error is h^2/12 v'' = h^2/6 (Vshivkov's second term, eq. 2.2), relative to v at
 * the first interior node h^2/6/(1 + h)^2; at a whole number k per cell it is 1 + 1/(2 k^2) times
 * that. */
#include <math.h>
#include "squeeze.h"

static void cases(Cases *list, bool quick)
{
    squeeze_add_quadratic(list, "mpm gimp", quick);
    for (int n = 50; n <= 200; n *= 4)
        case_add(list, "run squeeze --method mpm --cells %d --ppc 10 --set field=quadratic", n);
}

/* Order in h at ten particles per cell: eq. 2.2's second term. */
static Measure term_of_h(const Table *rows)
{
    Curve c = {0};
    for (int n = 50; n <= 200; n *= 2)
        curve_add(&c, 1.0 / n, select_value(rows, "error_linf", "method=mpm cells=%d ppc=10", n));
    return curve_order(&c, 0, 1, 3);
}

/* How far the error rises in all, from one particle per cell on. */
static Measure rises(const Curve *c)
{
    Measure sum = measure_sum_of(SQUEEZE_POINTS - 51);
    for (int k = 1; k < c->n; k++)
        if (c->x[k - 1] >= 1 - 1e-9)
            measure_add(&sum, c->y[k] > c->y[k - 1] ? c->y[k] - c->y[k - 1] : 0 * c->y[k]);
    return sum;
}

static void check_terms(Check *c, const Table *rows, const Curve *mpm, const Curve *gimp)
{
    claim(c, "W07-6.term-ppc",
          "Squeeze, quadratic field: MPM, term of PPC in eq. 2.2: worst errors less the plateau "
          "fall as PPC^-2: exponent",
          squeeze_exponent(mpm, 0.5, squeeze_plateau()), -2.1, -1.9);
    claim(c, "W07-6.term-h",
          "Squeeze, quadratic field: MPM, term of h in eq. 2.2: error at 10 particles per cell "
          "falls with h^2: order, 1/50 to 1/200",
          term_of_h(rows), 1.95, 2.02);
    claim_differs(c, "W07-6.no-zero-mpm",
                  "Squeeze, quadratic field: no arrangement has zero error: MPM's least over all "
                  "numbers of particles",
                  select_min(rows, "error_linf", SQUEEZE_POINTS, "method=mpm cells=100"), 1e-6, 1,
                  0, 1e-14,
                  "1.9e-16 at half a particle per cell, where a particle sits on every second node "
                  "and the others are empty; 1.6e-5 or more elsewhere");
    claim(c, "W07-6.no-zero-gimp",
          "Squeeze, quadratic field: no arrangement has zero error: GIMP's least over all numbers "
          "of particles",
          select_min(rows, "error_linf", SQUEEZE_POINTS, "method=gimp"), 1e-6, 1);
    const Measure more = rises(mpm), less = rises(gimp);
    claim(c, "W07-6.monotone",
          "Squeeze, quadratic field: GIMP falls more nearly monotonically: sum of all rises of the "
          "error from 1 particle per cell on, MPM's less GIMP's",
          measure(more.value - less.value, more.rows + less.rows, more.needs + less.needs), 0.005,
          0.01);
}

static void check(Check *c, const Results *r)
{
    const double plateau = squeeze_plateau();
    Curve mpm, gimp;
    claim_note(c, "plateau", plateau);
    curve_pick(&mpm, r->rows, "ppc", "error_linf", "method=mpm cells=100");
    curve_pick(&gimp, r->rows, "ppc", "error_linf", "method=gimp");
    check_terms(c, r->rows, &mpm, &gimp);
    claim(c, "W07-6.mpm-plateau",
          "Squeeze, quadratic field: MPM at 10 particles per cell, over h^2/6/(1+h)^2 (1 + 1/200)",
          squeeze_at_ten(&mpm), 0.999, 1.001);
    claim(c, "W07-6.gimp-plateau",
          "Squeeze, quadratic field: GIMP does not lower the plateau: its error at 10 per cell "
          "over h^2/6/(1+h)^2 (1 + 1/200)",
          squeeze_at_ten(&gimp), 0.999, 1.001);
    claim(c, "W07-6.gimp-settles",
          "Squeeze, quadratic field: GIMP stays within twice the plateau from this many particles "
          "per cell on",
          curve_settles(&gimp, 2 * plateau, SQUEEZE_POINTS), 2.55, 2.95);
    claim(c, "W07-6.mpm-settles",
          "Squeeze, quadratic field: MPM stays within twice the plateau from this many particles "
          "per cell on",
          curve_settles(&mpm, 2 * plateau, SQUEEZE_POINTS), 9.7, 10);
    claim(
        c, "W07-6.gimp-spot",
        "Squeeze, quadratic field: GIMP's error with 137 particles, an agreed value to six digits",
        curve_at(&gimp, 1.37), 2.173422e-4 - 5e-11, 2.173422e-4 + 5e-11);
}

const StudyPage study_w07_06_squeeze_quadratic = {.cases = cases, .check = check, .claims = 10};
