/* t_04_stability.c: where each method breaks: CFL x PPC x amplitude, and the largest stable CFL.
 *
 * Ten periods of the sine bar (1D) and of the standing waves of axis_mms (2D), every method with
 * every integrator, refused pairs included. A run is stable if it reaches the end with kinetic +
 * strain energy - work never more than 5 % (of the largest so far) above its start, as the ledger
 * has it. It "grew" if it reaches the end with more; it is lost if a particle is turned inside out,
 * leaves the grid or is not a number. Losing energy is no instability.
 *
 * The rungs below are all run, coarse on purpose, since stability is not monotone in CFL where
 * particles cross cells; the gap under the lowest rung that fails is bisected (ladder.h) to 5 %.
 * A limit says that every rung tried below it was stable, too. */
#include <math.h>
#include <stdlib.h>
#include "studies/tables/ladder.h"
#include "studies/tables/stability.h"

enum { STALE = 16 }; /* lines of pairs with a stale gradient */

/* Slow runs are rationed: what the figure shows, the default integrators, gets the finest mesh and
 * the lowest rung; the others get there where the next rung fails. Refused pairs run at one PPC. */
static void add_ladders(Cases *list, const Map *map, const char *method, Pair pair, bool quick)
{
    const bool usual = stability_is_usual(map, method, pair);
    const bool one = quick || !pair_is_allowed(map->engine, map->problem, method, pair);
    for (int a = 0; map->A[a] > 0; a++)
        for (int p = 0; map->ppc[p] > 0; p++)
            for (int k = usual ? 0 : 1; k < MAP_RUNGS; k += quick ? 3 : 1) {
                if ((quick && a != map->usual_A) || (one && p != map->usual_ppc)) continue;
                case_add(list,
                         "run %s --method %s --integrator %s --cells %d --ppc %g --cfl %g --t-end "
                         "%.17g --set A=%g --set allow_unstable=1 --set refresh=%d",
                         map->problem, method, pair.integrator, map->cells[usual], map->ppc[p],
                         stability_rungs[k], (quick ? 2 : 10) * map->period, map->A[a],
                         pair.refresh);
            }
}

static void cases(Cases *list, bool quick)
{
    for (const Map *map = stability_maps; map < stability_maps + MAPS; map++)
        EACH_METHOD(m, map->engine)
            for (int k = 0; k < PAIRS; k++)
                if (stability_has_pair(map, m->name, k))
                    add_ladders(list, map, m->name, pairs[k], quick);
}

/* CFL number below which a ladder is not followed. */
static double lowest(const Table *rows, int row)
{
    const Pair pair = pairs[pair_of_row(rows, row)];
    const bool usual =
        stability_is_usual(stability_of_row(rows, row), select_text(rows, row, "method"), pair);
    return usual ? stability_rungs[0] / 2 : stability_rungs[0];
}

/* Both limits, of stable runs and of runs that are not lost; they may lie in one gap. */
static void refine(Cases *list, const Table *rows, bool quick)
{
    Ladder *ladders;
    const int n = ladder_read_all(rows, &ladders);
    for (const Ladder *l = ladders; l < ladders + n; l++) {
        int before = -1;
        for (Mark worst = MARK_OK; worst < MARK_LOST; worst++) {
            int first;
            ladder_limit(l, worst, &first);
            if (first >= 0 && !(worst > MARK_OK && first == before))
                ladder_split(list, rows, l, first - 1, quick ? 0.4 : 0.05, lowest(rows, l->row[0]));
            before = first;
        }
    }
    free(ladders);
}

/* The least limit over PPC of a pair in 1D. */
static Measure bar(const Table *worst, const char *what, const char *pair, double A)
{
    return select_value(worst, what, "dim=1 %s amplitude=%g", pair, A);
}

/* In 2D, over both amplitudes, too. */
static Measure plane(const Table *worst, const char *method, const char *integrator)
{
    static const char where[] = "dim=2 method=%s integrator=%s refresh=0 amplitude=%g";
    const double *A = stability_maps[1].A;
    return measure_min(select_value(worst, "stable", where, method, integrator, A[0]),
                       select_value(worst, "stable", where, method, integrator, A[1]));
}

/* The largest over methods that refuse an integrator for its stale gradient. */
static Measure best_stale(const Table *worst)
{
    Measure best = measure_max_of(STALE);
    for (int row = 0; row < worst->nrow; row++) {
        const Pair fresh = {select_text(worst, row, "integrator"), true};
        const Engine *engine = engines[select_number(worst, row, "dim") > 1];
        const char *problem = stability_maps[engine->dim - 1].problem;
        if (select_number(worst, row, "refresh") > 0) continue;
        if (!pair_is_run(engine, problem, select_text(worst, row, "method"), fresh)) continue;
        measure_add_max(&best, select_number(worst, row, "stable"));
    }
    return best;
}

/* Expected ranges are the rungs of tenths between which an earlier search found each limit. */
static void check_bar(Check *c, const Table *worst)
{
    static const struct {
        const char *id, *method, *label, *amplitude, *more;
        double A, low, high;
    } known[] = {
        {"T-4.tent", "mpm", "MPM", "1e-4", "", 1e-4, 0.7, 0.8},
        {"T-4.tent-.01", "mpm", "MPM", ".01", "", 0.01, 0.7, 0.8},
        {"T-4.tent-.05", "mpm", "MPM", ".05", ", where particles cross cells", 0.05, 0.05, 0.1},
        {"T-4.gimp", "gimp", "GIMP", "1e-4", "", 1e-4, 0.7, 0.8},
        {"T-4.gimp-.01", "gimp", "GIMP", ".01", "", 0.01, 0.8, 0.9},
        {"T-4.gimp-.05", "gimp", "GIMP", ".05", "", 0.05, 0.8, 0.9},
        {"T-4.ge-gimp", "ge_gimp", "GE-GIMP", "1e-4", "", 1e-4, 1, 1.1},
        {"T-4.ge-gimp-.01", "ge_gimp", "GE-GIMP", ".01", "", 0.01, 1, 1.1}};
    static const char ge[] = "method=ge_gimp integrator=cd";
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        claim(
            c, known[k].id,
            phrase(
                "Standing wave in a bar, %s with cd, A = %s%s: largest stable CFL at the worst PPC",
                known[k].label, known[k].amplitude, known[k].more),
            bar(worst, "stable", phrase("method=%s integrator=cd", known[k].method), known[k].A),
            known[k].low, known[k].high);
    claim_differs(
        c, "T-4.ge-gimp-.05",
        "Standing wave in a bar, GE-GIMP with cd, A = .05: largest stable CFL at the worst PPC",
        bar(worst, "stable", ge, 0.05), 0.6, 0.7, 0.1, 0.6,
        "runs end well up to .6, but energy grows by more than 5 % long before");
    claim(c, "T-4.ge-gimp-.05-kept",
          "Standing wave in a bar, GE-GIMP with cd, A = .05: largest CFL at which no run is lost, "
          "energy growth allowed",
          bar(worst, "kept", ge, 0.05), 0.6, 0.7);
}

static void check(Check *c, const Results *r)
{
    const Table *worst = results_part(r, "worst");
    check_bar(c, worst);
    EACH_WORD(integrator, "musl uvf") {
        const char *pair = phrase("method=gimp integrator=%s", integrator);
        claim(c, phrase("T-4.%s", integrator),
              phrase("Standing wave in a bar, GIMP with %s: largest stable CFL, the lower of A = "
                     "1e-4 and .01",
                     integrator),
              measure_min(bar(worst, "stable", pair, 1e-4), bar(worst, "stable", pair, 0.01)), 1.4,
              2);
    }
    claim(c, "T-4.plane-gimp",
          "Axis-aligned waves in 2D, GIMP with cd: largest stable CFL, worst amplitude and PPC "
          "(own measurement)",
          plane(worst, "gimp", "cd"), 0.65, 0.8);
    claim(c, "T-4.plane-bspline",
          "Axis-aligned waves in 2D, B-splines with cd: largest stable CFL, worst amplitude and "
          "PPC (own measurement)",
          plane(worst, "bspline", "cd"), 0.9, 1.2);
    claim(c, "T-4.plane-fem",
          "Axis-aligned waves in 2D, FEM: largest stable CFL, worst amplitude (own measurement)",
          plane(worst, "fem", "cd"), 0.6, 0.8);
    claim(c, "T-4.stale",
          "Standing waves: methods that project twice per step with a stale gradient are stable at "
          "no step: largest stable CFL of all of them",
          best_stale(worst), 0, 0);
}

const StudyPage study_t_04_stability = {
    .cases = cases, .refine = refine, .tables = stability_tables, .check = check, .claims = 16};
