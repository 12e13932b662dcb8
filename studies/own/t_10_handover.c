/* t_10_handover.c: a run that goes on with another method on the same particles (--then, --at).
 *
 * WLS2 to GIMP on the oscillating ring at five times; on the generalized vortex with G = 1, where
 * WLS2 inverts particles before the largest turn and GIMP with undeformed boxes does not; and on
 * the hanging bar, where GIMP takes the step that would invert a particle and what follows. Every
 * curve is a history, of the runs by one method, too. */
#include <math.h>
#include <string.h>
#include "studies/tables/curves.h"

static const double ring[] = {0.0025, 0.005, 0.01, 0.015, 0.019}; /* [s], of .02 */
static const double vortex[] = {0.05, 0.1, 0.15};                 /* [s], of 1 */
enum { RINGS = sizeof ring / sizeof *ring, VORTICES = sizeof vortex / sizeof *vortex };

static void cases(Cases *list, bool quick)
{
    const int N = quick ? 12 : 32, M = quick ? 8 : 32;
    static const char swirl[] = "run vortex --cfl .1 --set layout=radial";
    char part[32];
    case_add_with(list, "history", "ring_wls2", "run ring --cells %d --method wls2", N);
    case_add_with(list, "history", "ring_gimp",
                  "run ring --cells %d --method gimp --set layout=radial", N);
    for (int k = 0; k < RINGS; k++) {
        snprintf(part, sizeof part, "ring_%d", k);
        case_add_with(list, "history", part,
                      "run ring --cells %d --method wls2 --then gimp --at %g", N, ring[k]);
    }
    case_add_with(list, "history", "vortex_wls2", "%s --cells %d --method wls2", swirl, M);
    case_add_with(list, "history", "vortex_gimp",
                  "%s --cells %d --method gimp --set domain=undeformed", swirl, M);
    for (int k = 0; k < VORTICES; k++) {
        snprintf(part, sizeof part, "vortex_%d", k);
        case_add_with(
            list, "history", part,
            "%s --cells %d --method wls2 --then gimp --then-set domain=undeformed --at %g", swirl,
            M, vortex[k]);
    }
    case_add_with(list, "history", "bar_wls2", "run hanging_bar --method wls2%s",
                  quick ? " --cells 8" : "");
    case_add_with(list, "history", "bar_then",
                  "run hanging_bar --method wls2 --then gimp --at inverted%s",
                  quick ? " --cells 8" : "");
}

/* The largest error of a history; NAN if there is none. */
static double largest_error(const Table *t)
{
    double most = NAN;
    for (int k = 0; t && k < t->nrow; k++) most = fmax(most, select_number(t, k, "error_linf"));
    return most;
}

/* |change of K + S| from instant k to the next [J]. */
static double change(const Table *t, int k)
{
    return fabs(select_number(t, k + 1, "total") - select_number(t, k, "total"));
}

/* The change of K + S in the first step by the second method, over the largest of the ten before.
 */
static double jump(const Table *t, double at)
{
    int step = 0;
    double most = 0;
    while (t && step < t->nrow && select_number(t, step, "t") < at * (1 - 1e-12)) step++;
    if (!t || step < 10 || step + 1 >= t->nrow) return NAN;
    for (int k = step - 10; k < step; k++) most = fmax(most, change(t, k));
    return change(t, step) / most;
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "times", "scene,at,error,jump,status");
    for (int k = 0; k < RINGS + VORTICES; k++) {
        char part[32];
        const bool is_ring = k < RINGS;
        const double at = is_ring ? ring[k] : vortex[k - RINGS];
        snprintf(part, sizeof part, "%s_%d", is_ring ? "ring" : "vortex", is_ring ? k : k - RINGS);
        Table *t = results_left(r, part);
        fprintf(f, "%s,%.9g,%.9g,%.9g,%s\n", is_ring ? "ring" : "vortex", at, largest_error(t),
                jump(t, at), results_status(r, part));
        table_free(t);
    }
}

/* Largest error of the run of a scene by a method: alone, or handed over at `at` > 0. One row. */
static Measure error_of(const Table *t, const char *problem, const char *method, double at)
{
    char word[64] = "";
    Measure m = measure_sum_of(1);
    if (at > 0) snprintf(word, sizeof word, "at=%.9g;", at);
    for (int row = -1; (row = select_next(t, row, "problem=%s method=%s", problem, method)) >= 0;) {
        const char *params = select_text(t, row, "params");
        if (at > 0 ? !strstr(params, word) : strstr(params, "then=") != NULL) continue;
        measure_add(&m, select_kept(t, row, "error_linf"));
        break;
    }
    return m;
}

/* The last time of a history. */
static Measure end_of(const Results *r, const char *part)
{
    Table *t = results_left(r, part);
    Measure m = measure_sum_of(1);
    if (t && t->nrow > 0) measure_add(&m, select_number(t, t->nrow - 1, "t"));
    table_free(t);
    return m;
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "times");
    Measure jumps = measure_max_of(RINGS), errors = error_of(r->rows, "ring", "wls2", ring[0]);
    for (int row = -1; (row = select_next(t, row, "scene=ring")) >= 0;)
        measure_add_max(&jumps, select_kept(t, row, "jump"));
    for (int k = 1; k < RINGS; k++)
        errors = measure_max(errors, error_of(r->rows, "ring", "wls2", ring[k]));
    claim(c, "T-10.energy",
          "ring, WLS2 then GIMP: change of K + S in the first step by GIMP over the largest of the "
          "ten steps before, worst of five times",
          jumps, 0, 1);
    claim(c, "T-10.error",
          "ring, WLS2 then GIMP: largest error over that of WLS2 alone, worst of five times",
          measure_ratio(errors, error_of(r->rows, "ring", "wls2", 0)), 0.9, 1.3);
    claim(c, "T-10.vortex",
          "vortex with G = 1, N = 32: WLS2 until t = .05, then GIMP with undeformed boxes, reaches "
          "its end; error over that of GIMP alone",
          measure_ratio(error_of(r->rows, "vortex", "wls2", vortex[0]),
                        error_of(r->rows, "vortex", "gimp", 0)),
          1, 2.5);
    claim(c, "T-10.vortex-wls2", "vortex with G = 1, N = 32: WLS2 alone ends before t = 1, at",
          end_of(r, "vortex_wls2"), 0.45, 0.55);
    claim(
        c, "T-10.bar",
        "hanging bar: time that WLS2 and then GIMP reach, which takes the step that inverts, over "
        "that of WLS2 alone",
        measure_ratio(end_of(r, "bar_then"), end_of(r, "bar_wls2")), 1.7, 2.2);
}

const Study study_t_10_handover = {
    .name = "t_10_handover",
    .figure = "T-10",
    .about = "hand-over from WLS2 to GIMP during a run: ring, vortex, hanging bar",
    .cases = cases,
    .tables = tables,
    .check = check,
    .claims = 5,
};
