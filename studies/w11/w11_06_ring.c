/* w11_06_ring.c: convergence on the oscillating ring, in space (N cells over its radius) and in
 * time (CFL at N = 32), for every method with its usual layout, GIMP with both, beside FEM.
 * Wallstedt and Guilkey (2011), fig. 6. Errors: eq 38, the largest over all particles and steps. */
#include <math.h>
#include "studies/tables/curves.h"

static const int cells[] = {8, 11, 16, 23, 32, 45, 64, 91, 128};
static const double cfl[] = {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
enum { MESHES = sizeof cells / sizeof *cells, STEPS = sizeof cfl / sizeof *cfl };

static void one_method(Cases *list, const char *method, const char *more, bool quick)
{
    for (int k = 0; k < (quick ? 3 : MESHES); k++)
        case_add(list, "run ring --method %s --cells %d%s", method, cells[k], more);
    for (int k = 0; k < STEPS; k++)
        if (cfl[k] != 0.3) /* that one stands above */
            case_add(list, "run ring --method %s --cells %d --cfl %g%s", method, quick ? 8 : 32,
                     cfl[k], more);
}

static void cases(Cases *list, bool quick)
{
    EACH_METHOD(m, &engine_2d) one_method(list, m->name, "", quick);
    one_method(list, "gimp", " --set layout=radial", quick);
    case_add(list, "run ring --method wls --cells %d --cfl .6", quick ? 11 : 64);
}

static Measure error_at(const Table *t, const char *method, const char *layout, int n)
{
    return select_value(t, "error_linf", "method=%s layout=%s cfl=0.3 cells=%d", method, layout, n);
}

/* Order over N = from .. to, `meshes` of them. */
static Measure order(const Table *t, const char *method, const char *layout, double from, double to,
                     int meshes)
{
    return curve_order_in_h(t, "error_linf", from, to, meshes, "method=%s layout=%s cfl=0.3",
                            method, layout);
}

/* (largest - smallest)/largest error of the runs with CFL .05 .. .6 at N = 32: one yardstick for
 * all methods. */
static Measure share_in_cfl(const Table *t, const char *method, const char *layout)
{
    const double most = 0.6 + 1e-9;
    double low = INFINITY;
    Measure high = measure_max_of(0);
    for (int k = 0; k < STEPS; k++) high.needs += cfl[k] <= most;
    EACH_ROW(row, t, "method=%s layout=%s cells=32", method, layout) {
        if (select_number(t, row, "cfl") > most) continue;
        low = measure_lesser(low, select_kept(t, row, "error_linf"));
        measure_add_max(&high, select_kept(t, row, "error_linf"));
    }
    return measure_with(high, (high.value - low) / high.value);
}

static void check_fem(Check *c, const Table *t)
{
    claim(c, "W11-6.fem-32", "Ring: FEM's largest error at N = 32",
          error_at(t, "fem", "cartesian", 32), 0.95 * 3.50e-4, 1.05 * 3.50e-4);
    claim(c, "W11-6.fem-order", "Ring: FEM is of second order: order over N = 8 to 128",
          order(t, "fem", "cartesian", 8, 128, MESHES), 1.9, 2.1);
    claim(c, "W11-6.fem-best",
          "Ring: FEM is more accurate than GIMP on the lattice at N = 32: its error over GIMP's",
          measure_ratio(error_at(t, "fem", "cartesian", 32), error_at(t, "gimp", "cartesian", 32)),
          0, 0.5);
}

static void check_gimp(Check *c, const Table *t)
{
    const Measure at_32 = error_at(t, "gimp", "cartesian", 32);
    claim(c, "W11-6.gimp-32", "Ring: GIMP's largest error at N = 32, particles on the lattice",
          at_32, 0.9 * 3.04e-3, 1.1 * 3.04e-3);
    claim(c, "W11-6.gimp-64", "Ring: GIMP's largest error at N = 64, particles on the lattice",
          error_at(t, "gimp", "cartesian", 64), 0.9 * 2.05e-3, 1.1 * 2.05e-3);
    claim(c, "W11-6.gimp-radial-32",
          "Ring: GIMP's largest error at N = 32, particles fitted to the ring",
          error_at(t, "gimp", "radial", 32), 0.85 * 5.54e-4, 1.15 * 5.54e-4);
    claim(c, "W11-6.gimp-order", "Ring: GIMP is of first order at best: order over N = 8 to 128",
          order(t, "gimp", "cartesian", 8, 128, MESHES), 0.3, 1);
    claim_differs(
        c, "W11-6.gimp-layout",
        "Ring: GIMP works best with particles on the lattice: error fitted over error lattice",
        measure_ratio(error_at(t, "gimp", "radial", 32), at_32), 1, 100, 0.12, 0.25,
        "fitted particles have .18 of the lattice's error at N = 32, then stall; both are shown");
    claim(c, "W11-6.ge-gain",
          "Ring: gradient enhancement gains nothing with particles on the lattice: GE-GIMP's error "
          "over GIMP's at N = 32",
          measure_ratio(error_at(t, "ge_gimp", "cartesian", 32), at_32), 1, 1.3);
    claim(c, "W11-6.gimp-cfl",
          "Ring: GIMP's error is flat in CFL .05 to .6 at N = 32: (largest - smallest)/largest",
          share_in_cfl(t, "gimp", "cartesian"), 0, 0.10);
}

static void check_wls(Check *c, const Table *t)
{
    const Measure at_32 = error_at(t, "wls", "radial", 32);
    claim(c, "W11-6.wls-32", "Ring: WLS's largest error at N = 32", at_32, 0.85 * 7.71e-4,
          1.15 * 7.71e-4);
    claim(c, "W11-6.wls-64", "Ring: WLS's largest error at N = 64",
          error_at(t, "wls", "radial", 64), 0.75 * 2.73e-4, 1.25 * 2.73e-4);
    claim(c, "W11-6.wls-gimp",
          "Ring: WLS is better than GIMP with particles on the lattice: its error over GIMP's, N = "
          "32",
          measure_ratio(at_32, error_at(t, "gimp", "cartesian", 32)), 0, 0.5);
    claim_differs(
        c, "W11-6.wls-cfl",
        "Ring: WLS's error is flat in CFL .05 to .6 at N = 32: (largest - smallest)/largest",
        share_in_cfl(t, "wls", "radial"), 0, 0.10, 0.10, 0.12,
        "it falls by 10.3 % towards CFL .6; CFL .05 to .5 is within 6 %");
}

/* How many of WLS's runs with CFL .05 .. .7 are lost. */
static Measure lost_steps(const Table *t)
{
    Measure lost = measure_sum_of(8);
    EACH_ROW(row, t, "method=wls cells=32")
        if (select_number(t, row, "cfl") <= 0.7 + 1e-9) measure_add(&lost, select_is_lost(t, row));
    return lost;
}

/* WLS beside FEM, mean of all meshes; its order on coarse meshes and on the finest. */
static void check_orders(Check *c, const Table *t)
{
    Curve wls, fem, step;
    curve_pick(&wls, t, "cells", "error_linf", "method=wls layout=radial cfl=0.3");
    curve_pick(&fem, t, "cells", "error_linf", "method=fem layout=cartesian cfl=0.3");
    curve_pick(&step, t, "cfl", "error_linf", "method=wls cells=64");
    claim_differs(c, "W11-6.wls-order-coarse",
                  "Ring: WLS is of second order on coarser meshes: fitted over N = 8 to 45",
                  order(t, "wls", "radial", 8, 45, 6), 1.9, 2.2, 1.75, 1.9,
                  "fitted order 1.94 over N = 8 to 16, 1.77 over 16 to 32, 1.51 over 32 to 64");
    claim_differs(
        c, "W11-6.wls-tail",
        "Ring: WLS has an error of first order that shows on fine meshes: order over N = 64 to 128",
        order(t, "wls", "radial", 64, 128, 3), 0.8, 1.3, 1.5, 1.8,
        "order 1.68 there: below second order, but not yet first");
    claim_differs(
        c, "W11-6.wls-fem",
        "Ring: WLS is somewhat less accurate than FEM: its error over FEM's, mean of nine meshes",
        curve_mean_ratio(&wls, &fem, MESHES), 1, 2, 2.3, 3,
        "2.6 times FEM's error; 1.7 at N = 8, 2.2 at 32, 3.8 at 128");
    claim_differs(c, "W11-6.fine-cfl",
                  "Ring: a low CFL number matters on fine meshes: WLS's error at CFL .6 over that "
                  "at .3, N = 64",
                  measure_ratio(curve_at(&step, 0.6), curve_at(&step, 0.3)), 1.1, 100, 0.9, 1,
                  ".93: the larger step is slightly more accurate, as at N = 32");
    claim(c, "W11-6.cell-size",
          "Ring: the cell size is a safe length in the time step limit: WLS runs lost at CFL .05 "
          "to .7, N = 32, of 8",
          lost_steps(t), 0, 0);
}

static void check_wls2(Check *c, const Table *t)
{
    claim(c, "W11-6.wls2-32", "Ring: WLS2's largest error at N = 32",
          error_at(t, "wls2", "radial", 32), 0, 6.0e-4);
    claim(c, "W11-6.wls2-64", "Ring: WLS2's largest error at N = 64",
          error_at(t, "wls2", "radial", 64), 0, 1.4e-4);
    claim(c, "W11-6.wls2-128", "Ring: WLS2's largest error at N = 128",
          error_at(t, "wls2", "radial", 128), 0, 4e-5);
    claim(c, "W11-6.wls2-order", "Ring: WLS2 is of second order: fitted over N = 16 to 64",
          order(t, "wls2", "radial", 16, 64, 5), 1.8, 2.3);
    claim(
        c, "W11-6.wls2-cfl",
        "Ring: WLS2's error falls with a larger step, CFL .05 to .6: (largest - smallest)/largest",
        share_in_cfl(t, "wls2", "radial"), 0.3, 0.38);
}

static void check(Check *c, const Results *r)
{
    check_fem(c, r->rows);
    check_gimp(c, r->rows);
    check_wls(c, r->rows);
    check_orders(c, r->rows);
    check_wls2(c, r->rows);
    claim(c, "W11-6.mpm-order", "Ring: MPM does not converge: order over N = 8 to 128",
          order(r->rows, "mpm", "cartesian", 8, 128, MESHES), -1, 0);
    claim_note(c, "order_gimp_radial", order(r->rows, "gimp", "radial", 8, 128, MESHES).value);
    EACH_METHOD(m, &engine_2d) {
        const double lattice = order(r->rows, m->name, "cartesian", 8, 128, MESHES).value;
        const double fitted = order(r->rows, m->name, "radial", 8, 128, MESHES).value;
        claim_note(c, phrase("order_%s", m->name), isnan(lattice) ? fitted : lattice);
    }
}

const StudyPage study_w11_06_ring = {.cases = cases, .check = check, .claims = 25};
