/* t_01_wls.c: the weighted-least-squares method of W11 taken apart on the oscillating ring: one
 * reading changed at a time. The paper leaves a tail below second order unexplained; its causes are
 * the distance to a mean of surface points and the one-point rule in cut cells. Two readings of the
 * text that do not run stand here too: constant node values, and the mean of forces as printed.
 * Largest error over all particles and steps, eq 38; CFL .3.
 *
 * Where the tail starts: how far the points at which cells are cut lie from the true surface, at
 * the start, when fields are exact. */
#include <math.h>
#include "studies/runs/run_row.h"
#include "studies/tables/curves.h"
#include "studies/tables/patches.h"

/* The methods, each with one setting changed, or as they are. */
enum { WLS, NORMALS, EXACT, TRIGGER, EXTRAPOLATE, WLS2, MEAN, CENTROID, SPLINE, C0, LITERAL, RUNS };
static const char *const runs[RUNS] = {
    [WLS] = "wls",
    [NORMALS] = "wls --set distance=normals",
    [EXACT] = "wls --set quadrature=exact",
    [TRIGGER] = "wls --set trigger=0.25",
    [EXTRAPOLATE] = "wls --set spurious_velocity=extrapolate",
    [WLS2] = "wls2",
    [MEAN] = "wls2 --set distance=weighted_mean",
    [CENTROID] = "wls2 --set quadrature=centroid",
    [SPLINE] = "wls2 --set return=spline",
    [C0] = "wls --set stress=c0",
    [LITERAL] = "wls --set average=literal",
};

enum { METHODS = 3, CUT_MESHES = 6 };
static const char *const cut_methods[METHODS] = {"wls", "wls2", "ge_wls"};
static const int cut_cells[CUT_MESHES] = {8, 16, 32, 64, 128, 256};

enum { MESHES = 9, FINE = 10 };
static const int cells[FINE] = {8, 11, 16, 23, 32, 45, 64, 91, 128, 181};

static void cases(Cases *list, bool quick)
{
    for (int r = 0; r < RUNS; r++) {
        const int most = quick ? 3 : r == SPLINE ? FINE : r == C0 ? 7 : r == LITERAL ? 5 : MESHES;
        for (int k = 0; k < most; k++)
            case_add(list, "run ring --cells %d --method %s", cells[k], runs[r]);
    }
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < (quick ? 2 : CUT_MESHES); k++)
            case_add_with(list, "patches", phrase("%s.%d", cut_methods[m], cut_cells[k]),
                          "run ring --method %s --cells %d --set steps=1", cut_methods[m],
                          cut_cells[k]);
}

/* Largest distance [m] of any cut point of a file of patches from the ring's radii at the start;
 * NAN if it cannot be read. A point on an edge of a cell has one coordinate on a grid line. */
static double cut_error(const char *path, int n)
{
    Patches p = patches_open(path);
    double most = -INFINITY;
    while (patches_next(&p)) {
        const double X = p.x[0] * n, Y = p.x[1] * n, R = hypot(p.x[0], p.x[1]);
        const bool on_x = fabs(X - round(X)) < 1e-7, on_y = fabs(Y - round(Y)) < 1e-7;
        if (p.cut && on_x != on_y)
            most = measure_worse(most, measure_lesser(fabs(R - 0.625), fabs(R - 1.1)));
    }
    return isinf(most) ? NAN : most;
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "cuts", "method,cells,error,status");
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < (r->quick ? 2 : CUT_MESHES); k++) {
            const char *part = phrase("%s.%d", cut_methods[m], cut_cells[k]);
            results_print(f, "%s,%d,%.17g,%s\n", cut_methods[m], cut_cells[k],
                          cut_error(results_path(r, part), cut_cells[k]), results_status(r, part));
        }
}

static Measure error_at(const Table *rows, int run, int n)
{
    return run_row_value(rows, "error_linf", "run ring --cells %d --method %s", n, runs[run]);
}

static Curve errors_of(const Table *rows, int run)
{
    Curve c = {0};
    for (int k = 0; k < FINE; k++) curve_add(&c, cells[k], error_at(rows, run, cells[k]));
    return c;
}

/* Fitted order over the meshes from .. to, `meshes` of them. */
static Measure order(const Table *rows, int run, double from, double to, int meshes)
{
    const Curve c = errors_of(rows, run);
    return measure_times(curve_order(&c, from, to, meshes), -1);
}

static void check_values(Check *c, const Table *rows)
{
    static const double wls[] = {1.05e-2, 2.59e-3, 7.71e-4, 2.73e-4, 8.45e-5};
    static const double wls2[] = {6.60e-3, 1.88e-3, 5.31e-4, 1.11e-4, 2.79e-5};
    const Curve published = errors_of(rows, WLS), cured = errors_of(rows, WLS2);
    claim(c, "T-1.wls-values",
          "Ring: WLS's largest departure from the recorded errors at N = 8 ... 128",
          curve_deviation(&published, 8, 5, wls, 1), 0, 0.15);
    claim(c, "T-1.wls2-values",
          "Ring: WLS2's largest departure from the recorded errors at N = 8 ... 128",
          curve_deviation(&cured, 8, 5, wls2, 1), 0, 0.15);
}

static void check_causes(Check *c, const Table *rows)
{
    claim(c, "T-1.wls-tail",
          "Ring: WLS as published falls below second order: order over N = 32 ... 128",
          order(rows, WLS, 32, 128, 5), 1.2, 1.8);
    claim(c, "T-1.wls2-order", "Ring: WLS2 is of second order: order over N = 16 ... 64",
          order(rows, WLS2, 16, 64, 5), 1.8, 2.3);
    claim(c, "T-1.wls2-128",
          "Ring: WLS2 continues at second order to N = 128: its largest error there [m]",
          error_at(rows, WLS2, 128), 0, 4e-5);
    claim(c, "T-1.no-normals",
          "Ring: WLS2 without the distance along normals falls below second order: error over "
          "WLS2's at N = 128",
          measure_ratio(error_at(rows, MEAN, 128), error_at(rows, WLS2, 128)), 1.3, 10);
    claim(c, "T-1.no-exact",
          "Ring: WLS2 without the exact rule in cut cells falls below second order: error over "
          "WLS2's at N = 128",
          measure_ratio(error_at(rows, CENTROID, 128), error_at(rows, WLS2, 128)), 1.3, 10);
    claim(c, "T-1.spline-order",
          "Ring: WLS2 with return=spline is of second order: order over N = 64 ... 181",
          order(rows, SPLINE, 64, 181, 4), 1.8, 2.3);
}

/* Readings of the text that do not run. */
static void check_failures(Check *c, const Table *rows)
{
    Measure lost = measure_sum_of(5);
    claim(
        c, "T-1.c0",
        "Ring: WLS with values at nodes only, no slopes: largest error at N = 64 [m] (WLS: 2.7e-4)",
        error_at(rows, C0, 64), 5e-3, 1);
    EACH_ROW(row, rows, "average=literal") {
        const double steps = select_number(rows, row, "steps");
        measure_add(&lost, isnan(steps) ? NAN : steps < 20);
    }
    claim(c, "T-1.literal",
          "Ring: WLS with the mean of forces as printed is unstable: runs lost within 20 steps, of "
          "five",
          lost, 5, 5);
}

/* The largest distance of a method's cut points from the surface, over h^power. */
static Measure cuts_over(const Table *t, const char *method, int power)
{
    Curve c;
    curve_pick(&c, t, "cells", "error", "method=%s", method);
    for (int k = 0; k < c.n; k++) c.y[k] *= pow(c.x[k], power);
    return curve_max(&c, CUT_MESHES);
}

static Measure cuts_order(const Table *t, const char *method)
{
    return curve_order_in_h(t, "error", 16, 128, 4, "method=%s", method);
}

static void check_cuts(Check *c, const Table *t)
{
    claim(c, "T-1.cuts-guess",
          "Ring, cut points by the mean of surface points (WLS) are more precise than the first "
          "guess, half an edge: largest distance from the surface over h/2, any N",
          measure_times(cuts_over(t, "wls", 1), 2), 0, 0.5);
    claim(c, "T-1.cuts-mean",
          "Ring, cut points by the mean of surface points (WLS) are below second order: order over "
          "N = 16 ... 128",
          cuts_order(t, "wls"), 0.6, 1.8);
    claim(c, "T-1.cuts-normals",
          "Ring, cut points by normals (WLS2) are of second order: order over N = 16 ... 128",
          cuts_order(t, "wls2"), 1.8, 2.2);
    claim(c, "T-1.cuts-bound",
          "Ring, cut points by normals (WLS2): largest distance from the surface at any N, over "
          "h^2 [1/m]",
          cuts_over(t, "wls2", 2), 0, 0.2);
    claim(c, "T-1.cuts-curved",
          "Ring, cut points on a curved surface (GE-WLS) are of third order or better: order over "
          "N = 16 ... 128",
          cuts_order(t, "ge_wls"), 2.8, 5);
}

static void check(Check *c, const Results *r)
{
    check_cuts(c, results_part(r, "cuts"));
    check_values(c, r->rows);
    check_causes(c, r->rows);
    check_failures(c, r->rows);
}

const StudyPage study_t_01_wls = {.cases = cases, .tables = tables, .check = check, .claims = 15};
