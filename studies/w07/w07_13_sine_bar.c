/* w07_13_sine_bar.c: convergence of a standing wave after a quarter period, with and without
 * gradient enhancement. Wallstedt and Guilkey (2007), fig. 13 (eqs 5.1, 5.2).
 *
 * Two laws. sigma = E (F - 1) makes the wave equation exact at any amplitude: second order, and the
 * gradient saves nearly half of the error. With the neo-Hookean law the exact solution is that of
 * another material: the error tails off at about half the amplitude squared, A^2/2 [m]. */
#include <math.h>
#include "forty_percent.h"
#include "studies/tables/curves.h"

enum { MESHES = 9, METHODS = 3, LAWS = 2, PRINTED = 5 };
static const int cells[MESHES] = {10, 14, 20, 28, 40, 57, 80, 113, 160};
static const char *const methods[METHODS] = {"mpm", "gimp", "ge_gimp"};
static const char *const laws[LAWS] = {"linear", "neo_hookean"};

static void cases(Cases *list, bool quick)
{
    for (int l = 0; l < LAWS; l++)
        for (int m = 0; m < METHODS; m++)
            for (int k = 0; k < MESHES; k += quick ? 4 : 1)
                case_add(list, "run sine_bar --method %s --cells %d --set law=%s", methods[m],
                         cells[k], laws[l]);
}

/* Agreed errors of GIMP and GE-GIMP with 10, 20, ... 160 cells: 1 %, and 2 % on the finest mesh. */
static const double printed[LAWS][2][PRINTED] = {
    {{2.920e-2, 7.588e-3, 1.971e-3, 4.659e-4, 1.240e-4},
     {1.543e-2, 4.023e-3, 1.069e-3, 2.463e-4, 6.680e-5}},
    {{2.995e-2, 9.869e-3, 5.921e-3, 5.159e-3, 5.055e-3},
     {1.650e-2, 7.186e-3, 5.433e-3, 5.043e-3, 5.085e-3}}};

static void pick(Curve *c, const Table *rows, const char *x, int law, int method)
{
    curve_pick(c, rows, x, "error_linf", "method=%s law=%s", methods[method], laws[law]);
}

static Measure mean_ratio(const Table *rows)
{
    Curve gimp, ge;
    pick(&gimp, rows, "cells", 0, 1);
    pick(&ge, rows, "cells", 0, 2);
    return curve_mean_ratio(&ge, &gimp, MESHES);
}

static void check_values(Check *c, const Table *rows)
{
    static const char *const ids[LAWS][2] = {
        {"W07-13.gimp-linear-values", "W07-13.ge-gimp-linear-values"},
        {"W07-13.gimp-neo-values", "W07-13.ge-gimp-neo-values"}};
    Curve curve;
    for (int l = 0; l < LAWS; l++)
        for (int m = 0; m < 2; m++) {
            pick(&curve, rows, "cells", l, 1 + m);
            claim(c, ids[l][m],
                  phrase("Sine bar, %s, %s law: largest departure from the recorded errors at 1/10 "
                         "... 1/160 (the last counts half)",
                         m ? "GE-GIMP" : "GIMP", l ? "neo-Hookean" : "exact"),
                  curve_deviation(&curve, 10, PRINTED, printed[l][m], 0.5), 0, 0.01);
        }
}

static void check(Check *c, const Results *r)
{
    Curve curve;
    check_values(c, r->rows);
    pick(&curve, r->rows, "h", 0, 1);
    claim(c, "W07-13.gimp-order", "Sine bar: second order for a smooth solution: GIMP, exact law",
          curve_order(&curve, 0, 1, MESHES), 1.85, 2.05);
    pick(&curve, r->rows, "h", 0, 2);
    claim(c, "W07-13.ge-gimp-order",
          "Sine bar: second order for a smooth solution: GE-GIMP, exact law",
          curve_order(&curve, 0, 1, MESHES), 1.85, 2.05);
    pick(&curve, r->rows, "h", 0, 0);
    claim(c, "W07-13.mpm-order", "Sine bar: MPM does not converge, exact law: order",
          curve_order(&curve, 0, 1, MESHES), -1, 0.1);
    claim(c, "W07-13.forty-percent",
          "Gradient enhancement lowers GIMP's error by about forty percent, sine bar, exact law: "
          "mean of ratios, nine meshes",
          mean_ratio(r->rows), FORTY_PERCENT_LOW, FORTY_PERCENT_HIGH);
    pick(&curve, r->rows, "cells", 1, 1);
    claim(c, "W07-13.tail-off",
          "Sine bar: the neo-Hookean curve tails off at finite strain: GIMP's error at 1/160, over "
          "A^2",
          measure_times(curve_at(&curve, 160), 1 / 0.01), 0.49, 0.53);
}

const StudyPage study_w07_13_sine_bar = {.cases = cases, .check = check, .claims = 9};
