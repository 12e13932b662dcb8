/* t_10_handover.c: a run that goes on with another method on the same particles (--then, --at).
 *
 * WLS2 to GIMP on the oscillating ring at five times; on the generalized vortex with G = 1, where
 * WLS2 inverts particles before the largest turn and GIMP with undeformed boxes does not; and on
 * the hanging bar, where GIMP takes the step that would invert a particle and what follows. Every
 * curve is a history, of the runs by one method, too. */
#include <math.h>
#include "studies/tables/curves.h"

#define SWIRL "run vortex --cfl .1 --set layout=radial"
#define RELAY " --method wls2 --then gimp"

/* `at` [s]: of 0.02 (ring), of 1 (vortex); 0: one method, or as the run says. */
static const struct {
    const char *scene, *part;
    double at;
    const char *run;
} runs[] = {
    {"ring", "ring_wls2", 0, "run ring --method wls2"},
    {"ring", "ring_gimp", 0, "run ring --method gimp --set layout=radial"},
    {"ring", "ring_0", 0.0025, "run ring" RELAY},
    {"ring", "ring_1", 0.005, "run ring" RELAY},
    {"ring", "ring_2", 0.01, "run ring" RELAY},
    {"ring", "ring_3", 0.015, "run ring" RELAY},
    {"ring", "ring_4", 0.019, "run ring" RELAY},
    {"vortex", "vortex_wls2", 0, SWIRL " --method wls2"},
    {"vortex", "vortex_gimp", 0, SWIRL " --method gimp --set domain=undeformed"},
    {"vortex", "vortex_0", 0.05, SWIRL RELAY " --then-set domain=undeformed"},
    {"vortex", "vortex_1", 0.1, SWIRL RELAY " --then-set domain=undeformed"},
    {"vortex", "vortex_2", 0.15, SWIRL RELAY " --then-set domain=undeformed"},
    {"bar", "bar_wls2", 0, "run hanging_bar --method wls2"},
    {"bar", "bar_then", 0, "run hanging_bar" RELAY " --at inverted"},
};
enum { RUNS = sizeof runs / sizeof *runs, RINGS = 5 /* handed over */ };

static void cases(Cases *list, bool quick)
{
    for (int k = 0; k < RUNS; k++) {
        const int fine = runs[k].scene[0] == 'b' ? 16 : 32,
                  coarse = runs[k].scene[0] == 'r' ? 12 : 8;
        case_add_with(list, "history", runs[k].part, "%s --cells %d%s", runs[k].run,
                      quick ? coarse : fine, runs[k].at > 0 ? phrase(" --at %g", runs[k].at) : "");
    }
}

/* The largest error of a history; NAN if it has none. */
static double largest_error(const Table *t)
{
    double most = NAN;
    for (int k = 0; k < t->nrow; k++) most = fmax(most, select_number(t, k, "error_linf"));
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
    while (step < t->nrow && select_number(t, step, "t") < at * (1 - 1e-12)) step++;
    if (step < 10 || step + 1 >= t->nrow) return NAN;
    for (int k = step - 10; k < step; k++) most = fmax(most, change(t, k));
    return change(t, step) / most;
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "times", "scene,part,at,error,jump,end,status");
    for (int k = 0; k < RUNS; k++) {
        const Table *t = results_ended(r, "%s", runs[k].part);
        const double numbers[] = {runs[k].at, largest_error(t), jump(t, runs[k].at),
                                  select_last(t, "t")};
        results_print(f, "%s,%s,", runs[k].scene, runs[k].part);
        for (int n = 0; n < 4; n++) info_number_write(f, numbers[n]), putc(',', f);
        results_print(f, "%s\n", results_status(r, runs[k].part));
    }
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "times");
    Measure jumps = measure_max_of(RINGS), errors = measure_max_of(RINGS);
    for (int k = 0; k < RUNS; k++) {
        if (runs[k].scene[0] != 'r' || !(runs[k].at > 0)) continue;
        measure_add_max(&jumps, select_value(t, "jump", "part=%s", runs[k].part).value);
        measure_add_max(&errors, select_value(t, "error", "part=%s", runs[k].part).value);
    }
    claim(c, "T-10.energy",
          "Ring, WLS2 then GIMP: change of K + S in the first step by GIMP over the largest of the "
          "ten steps before, worst of five times",
          jumps, 0, 1);
    claim(c, "T-10.error",
          "Ring, WLS2 then GIMP: largest error over that of WLS2 alone, worst of five times",
          measure_ratio(errors, select_value(t, "error", "part=ring_wls2")), 0.9, 1.3);
    claim(c, "T-10.vortex",
          "Vortex with G = 1, N = 32: WLS2 until t = .05, then GIMP with undeformed boxes, reaches "
          "its end; error over that of GIMP alone",
          measure_ratio(select_value(t, "error", "part=vortex_0"),
                        select_value(t, "error", "part=vortex_gimp")),
          1, 2.5);
    claim(c, "T-10.vortex-wls2", "Vortex with G = 1, N = 32: WLS2 alone ends before t = 1, at",
          select_ended(t, "end", "part=vortex_wls2"), 0.45, 0.55);
    claim(c, "T-10.bar",
          "Hanging bar: WLS2, handed over to GIMP in the step that inverts: the time it reaches "
          "over that of WLS2 alone",
          measure_ratio(select_ended(t, "end", "part=bar_then"),
                        select_ended(t, "end", "part=bar_wls2")),
          1.7, 2.2);
}

const StudyPage study_t_10_handover = {
    .cases = cases, .tables = tables, .check = check, .claims = 5};
