/* t_12_conditioning.c: which nodes are spurious (W11 3.5): the ring at N = 24 with trigger weights
 * from .02 to .5, with 1, 4 and 9 particles per cell, fitted to the body or on the lattice with
 * surface points on the circles; and with the determinant of the moments, or the number of
 * particles, as the only test. Error, spurious nodes of a step, and which runs are lost. One
 * particle per cell on the lattice is too little for the published method with any of them. */
#include <math.h>
#include "studies/tables/curves.h"

static const double triggers[] = {0.02, 0.05, 0.08, 0.12, 0.18, 0.25, 0.35, 0.5};
static const char *const methods[] = {"wls", "wls2"}, *const conditions[] = {"determinant",
                                                                             "count"};
static const int ppc[] = {1, 4, 9};
static const struct {
    const char *name, *run;
} layouts[] = {{"fitted", "run ring"},
               {"lattice", "run scan --set load=radial --set edge=grey --set width=1.1 --set "
                           "pixels=256"}};
enum { TRIGGERS = 8, FILLS = 3, CELLS = 24, CASES = 2 * FILLS /* of one setting and method */ };

static void cases(Cases *list, bool quick)
{
    for (int m = 0; m < 2; m++)
        for (int l = 0; l < 2; l++)
            for (int p = 0; p < FILLS; p++) {
                const char *run = phrase("%s --method %s --ppc %d --cells %d", layouts[l].run,
                                         methods[m], ppc[p], quick ? 10 : CELLS);
                for (int k = 0; k < TRIGGERS; k++)
                    case_add(list, "%s --set trigger=%g", run, triggers[k]);
                for (int k = 0; k < 2; k++)
                    case_add(list, "%s --set condition=%s", run, conditions[k]);
            }
}

/* The test that tells spurious nodes. */
static const char *condition_of(const Table *t, int row)
{
    for (int k = 0; k < 2; k++)
        if (select_meets(t, row, "condition=%s", conditions[k])) return conditions[k];
    return "weight";
}

/* Rows of runs with what figures and claims ask of them. */
static void tables(const Results *r)
{
    const Table *t = r->rows;
    FILE *f = results_write(r, "map", "method,layout,fill,condition,trigger,error,spurious,lost");
    for (int row = 0; row < t->nrow; row++) {
        const bool lost = select_is_lost(t, row);
        const double steps = select_number(t, row, "steps");
        results_print(f, "%s,%s,%g,%s,%g,%.17g,%.17g,%d\n", select_text(t, row, "method"),
                      layouts[select_is(t, row, "problem", "scan")].name,
                      pow(round(sqrt(select_number(t, row, "ppc"))), 2), condition_of(t, row),
                      select_number(t, row, "trigger"), select_number(t, row, "error_linf"),
                      select_number(t, row, "fallbacks") / steps, lost);
    }
}

/* How many runs of one setting are lost, over both layouts and all particles per cell. */
static Measure lost(const Table *t, const char *method, const char *condition, double trigger)
{
    Measure sum = measure_sum_of(CASES);
    EACH_ROW(row, t, "method=%s condition=%s", method, condition)
        if (!(trigger > 0) || fabs(select_number(t, row, "trigger") - trigger) < 1e-9)
            measure_add(&sum, select_number(t, row, "lost"));
    return sum;
}

static Measure fitted_error(const Table *t, const char *method, double trigger)
{
    return select_value(t, "error", "method=%s layout=fitted fill=4 condition=weight trigger=%g",
                        method, trigger);
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "map");
    for (int k = 0; k < 2; k++)
        claim(c, phrase("T-12.%s", conditions[k]),
              phrase("Published WLS on the ring, N = 24, nodes spurious by the %s alone: how many "
                     "of 6 runs (1, 4, 9 particles per cell; fitted, on the lattice) are lost",
                     k ? "number of particles" : "determinant of the moments"),
              lost(t, "wls", conditions[k], 0), 2, 3);
    claim(c, "T-12.low",
          "Published WLS on the ring, N = 24, trigger weight .05: how many of 6 runs are lost",
          lost(t, "wls", "weight", 0.05), 2, 3);
    claim(c, "T-12.usual",
          "Published WLS on the ring, N = 24, trigger weight .18: how many of 6 runs are lost (one "
          "particle per cell on the lattice)",
          lost(t, "wls", "weight", 0.18), 0, 1);
    claim(c, "T-12.wls2", "WLS2, these runs with trigger weight .25: how many of 6 are lost",
          lost(t, "wls2", "weight", 0.25), 0, 0);
    claim(
        c, "T-12.high",
        "WLS2 on the fitted ring, 4 particles per cell: largest error with trigger weight .5 over "
        "that with .25",
        measure_ratio(fitted_error(t, "wls2", 0.5), fitted_error(t, "wls2", 0.25)), 2, 5);
    claim(c, "T-12.spurious",
          "Published WLS on the fitted ring, 4 particles per cell: spurious nodes with trigger "
          "weight .25 over those with .12",
          measure_ratio(
              select_value(t, "spurious",
                           "method=wls layout=fitted fill=4 condition=weight trigger=0.25"),
              select_value(t, "spurious",
                           "method=wls layout=fitted fill=4 condition=weight trigger=0.12")),
          1.5, 2.5);
}

const StudyPage study_t_12_conditioning = {
    .cases = cases, .tables = tables, .check = check, .claims = 7};
