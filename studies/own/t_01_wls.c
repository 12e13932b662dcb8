/* t_01_wls.c: the weighted-least-squares method of W11 taken apart on the oscillating ring: one
 * reading changed at a time. The paper leaves a tail below second order unexplained; its causes are
 * the distance to a mean of surface points and the one-point rule in cut cells. Two readings of the
 * text that do not run stand here too: constant node values, and the mean of forces as printed.
 * Largest error over all particles and steps, eq 38; CFL .3.
 *
 * Where the tail starts: how far the points at which cells are cut lie from the true surface, at
 * the start, when fields are exact. */
#include <math.h>
#include "studies/tables/curves.h"

/* The settings that runs change. */
enum { AVERAGE, DISTANCE, QUADRATURE, RETURN, SPURIOUS, STRESS, TRIGGER, SETTINGS };
static const char *const names[SETTINGS] = {"average",           "distance", "quadrature", "return",
                                            "spurious_velocity", "stress",   "trigger"};
static const char *const published[SETTINGS] = {"weighted", "weighted_mean", "centroid", "linear",
                                                "constant", "linear",        "0.12"};
static const char *const cured[SETTINGS] = {"weighted",    "normals", "exact", "linear",
                                            "extrapolate", "linear",  "0.25"};

enum {
    WLS,
    NORMALS,
    EXACT,
    TRIGGER_25,
    EXTRAPOLATE,
    WLS2,
    MEAN,
    CENTROID,
    SPLINE,
    C0,
    LITERAL,
    RUNS
};

/* Which setting a run changes, and how; none: the method as it is. */
static const struct {
    bool cures;
    int setting;
    const char *value;
} runs[RUNS] = {
    [WLS] = {false, 0, NULL},
    [NORMALS] = {false, DISTANCE, "normals"},
    [EXACT] = {false, QUADRATURE, "exact"},
    [TRIGGER_25] = {false, TRIGGER, "0.25"},
    [EXTRAPOLATE] = {false, SPURIOUS, "extrapolate"},
    [WLS2] = {true, 0, NULL},
    [MEAN] = {true, DISTANCE, "weighted_mean"},
    [CENTROID] = {true, QUADRATURE, "centroid"},
    [SPLINE] = {true, RETURN, "spline"},
    [C0] = {false, STRESS, "c0"},
    [LITERAL] = {false, AVERAGE, "literal"},
};

enum { METHODS = 3, CUT_MESHES = 6 };
static const char *const cut_methods[METHODS] = {"wls", "wls2", "ge_wls"};
static const int cut_cells[CUT_MESHES] = {8, 16, 32, 64, 128, 256};

enum { MESHES = 9, FINE = 10 };
static const int cells[FINE] = {8, 11, 16, 23, 32, 45, 64, 91, 128, 181};

static void cases(Cases *list, bool quick)
{
    for (int r = 0; r < RUNS; r++) {
        const int most = quick ? 3 : r == SPLINE ? FINE : r == C0 ? 7 : MESHES;
        for (int k = 0; k < most; k++) {
            const char *set =
                runs[r].value ? phrase(" --set %s=%s", names[runs[r].setting], runs[r].value) : "";
            if (r == LITERAL && cells[k] > 32) continue;
            case_add(list, "run ring --method %s --cells %d%s", runs[r].cures ? "wls2" : "wls",
                     cells[k], set);
        }
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
    FILE *f = path ? fopen(path, "r") : NULL;
    char line[256];
    double most = -INFINITY;
    while (f && fgets(line, sizeof line, f)) {
        int cell, k, cut;
        double x, y;
        if (sscanf(line, "%d,%d,%lf,%lf,%d", &cell, &k, &x, &y, &cut) != 5 || !cut) continue;
        const bool on_x = fabs(x * n - round(x * n)) < 1e-7,
                   on_y = fabs(y * n - round(y * n)) < 1e-7;
        if (on_x == on_y) continue;
        most =
            measure_worse(most, measure_lesser(fabs(hypot(x, y) - 0.625), fabs(hypot(x, y) - 1.1)));
    }
    if (f) fclose(f);
    return isinf(most) ? NAN : most;
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "cuts", "method,cells,error,status");
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < (r->quick ? 2 : CUT_MESHES); k++) {
            const char *part = phrase("%s.%d", cut_methods[m], cut_cells[k]);
            fprintf(f, "%s,%d,%.17g,%s\n", cut_methods[m], cut_cells[k],
                    cut_error(results_path(r, part), cut_cells[k]), results_status(r, part));
        }
}

static const char *setting(int run, int which)
{
    if (runs[run].value && runs[run].setting == which) return runs[run].value;
    return runs[run].cures ? cured[which] : published[which];
}

/* The rows of a run: all settings as they are in it; not those that only draw cut cells. */
static const char *where_is(int run)
{
    const char *where = phrase("method=%s set.steps=0", runs[run].cures ? "wls2" : "wls");
    for (int k = 0; k < SETTINGS; k++) where = phrase("%s %s=%s", where, names[k], setting(run, k));
    return where;
}

static Measure error_at(const Table *rows, int run, int n)
{
    return select_value(rows, "error_linf", "%s cells=%d", where_is(run), n);
}

/* Fitted order over the meshes from .. to, `meshes` of them. */
static Measure order(const Table *rows, int run, double from, double to, int meshes)
{
    return curve_order_in_h(rows, "error_linf", from, to, meshes, "%s", where_is(run));
}

static void check_values(Check *c, const Table *rows)
{
    static const double wls[] = {1.05e-2, 2.59e-3, 7.71e-4, 2.73e-4, 8.45e-5};
    static const double wls2[] = {6.60e-3, 1.88e-3, 5.31e-4, 1.11e-4, 2.79e-5};
    Curve curve;
    curve_pick(&curve, rows, "cells", "error_linf", "%s", where_is(WLS));
    claim(c, "T-1.wls-values",
          "Ring: WLS's largest departure from the recorded errors at N = 8 ... 128",
          curve_deviation(&curve, 8, 5, wls, 1), 0, 0.15);
    curve_pick(&curve, rows, "cells", "error_linf", "%s", where_is(WLS2));
    claim(c, "T-1.wls2-values",
          "Ring: WLS2's largest departure from the recorded errors at N = 8 ... 128",
          curve_deviation(&curve, 8, 5, wls2, 1), 0, 0.15);
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
    for (int k = 0; k < 5; k++) {
        const double steps =
            select_ended(rows, "steps", "%s cells=%d", where_is(LITERAL), cells[k]).value;
        measure_add(&lost, isnan(steps) ? NAN : steps < 20);
    }
    claim(c, "T-1.literal",
          "Ring: WLS with the mean of forces as printed is unstable: runs lost within 20 steps, of "
          "five",
          lost, 5, 5);
}

/* Orders from N = 16 on. */
static void check_cuts(Check *c, const Results *r)
{
    Measure order[METHODS], most[METHODS], guessed = measure_max_of(CUT_MESHES);
    const Table *t = results_part(r, "cuts");
    for (int m = 0; m < METHODS; m++) {
        Curve curve;
        curve_pick(&curve, t, "cells", "error", "method=%s", cut_methods[m]);
        order[m] = curve_order_in_h(t, "error", 16, 128, 4, "method=%s", cut_methods[m]);
        for (int k = 0; k < curve.n && m == 0; k++)
            measure_add_max(&guessed, 2 * curve.x[k] * curve.y[k]);
        for (int k = 0; k < curve.n; k++) curve.y[k] *= curve.x[k] * curve.x[k];
        most[m] = curve_max(&curve, CUT_MESHES);
    }
    claim(c, "T-1.cuts-guess",
          "Ring, cut points by the mean of surface points (WLS) are more precise than the first "
          "guess, half an edge: largest distance from the surface over h/2, any N",
          guessed, 0, 0.5);
    claim(c, "T-1.cuts-mean",
          "Ring, cut points by the mean of surface points (WLS) are below second order: order over "
          "N = 16 ... 128",
          order[0], 0.6, 1.8);
    claim(c, "T-1.cuts-normals",
          "Ring, cut points by normals (WLS2) are of second order: order over N = 16 ... 128",
          order[1], 1.8, 2.2);
    claim(c, "T-1.cuts-bound",
          "Ring, cut points by normals (WLS2): largest distance from the surface at any N, over "
          "h^2 [1/m]",
          most[1], 0, 0.2);
    claim(c, "T-1.cuts-curved",
          "Ring, cut points on a curved surface (GE-WLS) are of third order or better: order over "
          "N = 16 ... 128",
          order[2], 2.8, 5);
}

static void check(Check *c, const Results *r)
{
    check_cuts(c, r);
    check_values(c, r->rows);
    check_causes(c, r->rows);
    check_failures(c, r->rows);
}

const StudyPage study_t_01_wls = {.cases = cases, .tables = tables, .check = check, .claims = 15};
