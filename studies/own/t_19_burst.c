/* t_19_burst.c: a ring that a pulse of pressure inside breaks (scene burst_ring), as W11 section 6
 * names it: WLS2 until the first particle breaks, then GIMP on the same particles; GIMP and WLS2
 * all the way beside it. N = 32; GIMP's boxes keep their widths, as matter without tension may
 * stretch without end.
 *
 * Energy: the external work W is reduced by what particles stored in tension when they broke, so
 * that K + S - W should stay constant. Pictures: particles at t = .02 s. */
#include <math.h>
#include "studies/tables/grades.h"

#define RELAY "run burst_ring --method wls2 --then gimp --at rupture --then-set domain=undeformed"
#define GIMP  "run burst_ring --method gimp --set layout=radial --set domain=undeformed"

enum { RUNS = 4 };
static const struct {
    const char *part, *run;
} runs[RUNS] = {{"relay", RELAY},
                {"gimp", GIMP},
                {"wls2", "run burst_ring --method wls2"},
                {"whole", GIMP " --set strength=10"}};

static void cases(Cases *list, bool quick)
{
    const int cells = quick ? 12 : 32;
    for (int k = 0; k < RUNS; k++)
        case_add_with(list, "history", runs[k].part, "%s --cells %d", runs[k].run, cells);
    for (int k = 0; k < 2; k++)
        case_add_with(list, "particles", phrase("%s.points", runs[k].part),
                      "%s --cells %d --t-end .02", runs[k].run, cells);
}

/* K + S - W at an instant [J]. */
static double balance(const Table *t, int k)
{
    return select_number(t, k, "total") - select_number(t, k, "external_work");
}

/* Largest |K + S - W| over the largest K + S. */
static double drift(const Table *t)
{
    double most = 0, size = 0;
    for (int k = 0; k < t->nrow; k++) {
        most = measure_worse(most, fabs(balance(t, k) - balance(t, 0)));
        size = measure_worse(size, select_number(t, k, "total"));
    }
    return size > 0 ? most / size : NAN;
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "ends", "part,end,kinetic,drift,status");
    for (int k = 0; k < RUNS; k++) {
        const Table *t = results_ended(r, "%s", runs[k].part);
        const double numbers[] = {select_last(t, "t"), select_last(t, "kinetic"), drift(t)};
        results_print(f, "%s,", runs[k].part);
        for (int n = 0; n < 3; n++) info_number_write(f, numbers[n]), putc(',', f);
        results_print(f, "%s\n", results_status(r, runs[k].part));
    }
}

static Measure of(const Results *r, const char *part, const char *column)
{
    return select_value(results_part(r, "ends"), column, "part=%s", part);
}

static void check(Check *c, const Results *r)
{
    claim(c, "T-19.wls2", "Bursting ring, N = 32: WLS2 alone inverts before t = .04 s, at",
          select_ended(results_part(r, "ends"), "end", "part=wls2"), 0.01, 0.025);
    claim(c, "T-19.relay",
          "Bursting ring, N = 32: WLS2 until rupture, then GIMP, reaches t = .04 s; kinetic energy "
          "then over that of GIMP alone",
          measure_ratio(of(r, "relay", "kinetic"), of(r, "gimp", "kinetic")), 0.9, 1.1);
    claim(c, "T-19.whole",
          "Ring under the same pulse of pressure, which does not break, N = 32, GIMP: largest "
          "change of K + S - W over the largest K + S",
          of(r, "whole", "drift"), 0, 0.03);
    claim_differs(
        c, "T-19.energy",
        "Bursting ring, N = 32, GIMP: K + S - W is constant if the energy of breaking particles "
        "counts as work: largest change over the largest K + S",
        of(r, "gimp", "drift"), 0, 0.03, 0.15, 0.35,
        "fragments lose energy, less with smaller steps: .28 at CFL .2, .16 at .05; until "
        "t = .0125 s, while the ring breaks, it is .025");
}

const StudyPage study_t_19_burst = {.cases = cases, .tables = tables, .check = check, .claims = 4};
