/* t_14_adaptive.c: the adaptive step of W11 eq 34, dt = CFL h/(v_max + max |v_p|), beside the
 * constant one: the disk's impacts, a hanging bar, and the oscillating ring, whose error is
 * compared at equal mean steps.
 *
 * A constant step that satisfies eq 34 at every instant is the least of the adaptive ones; the
 * steps saved are those that this one takes beyond the adaptive run's. */
#include <math.h>
#include "studies/tables/curves.h"

static const char *const disk[] = {"gimp", "wls2", "fem"};
enum { DISKS = 3 };

static void add_run(Cases *list, const char *problem, const char *method, int cells)
{
    case_add_with(list, "history", phrase("%s_%s", problem, method),
                  "run %s --method %s --cells %d --set dt=adaptive", problem, method, cells);
}

static void cases(Cases *list, bool quick)
{
    for (int m = 0; m < DISKS; m++) add_run(list, "disk_impact", disk[m], quick ? 8 : 32);
    for (int m = 0; m < DISKS; m++)
        case_add(list, "run disk_impact --method %s --cells %d --cfl .3", disk[m], quick ? 8 : 32);
    add_run(list, "hanging_bar", "fem", quick ? 4 : 16);
    for (int m = 0; m < DISKS; m++) {
        case_add(list, "run ring --method %s --cells 16 --set dt=adaptive", disk[m]);
        case_add(list, "run ring --method %s --cells 16 --cfl .2", disk[m]);
    }
}

/* Part of the steps of the constant rule that the adaptive run saves; none without its history. */
static Measure saved(const Results *r, const char *problem, const char *method)
{
    const Table *h = results_run(r, "%s_%s", problem, method);
    const int steps = h->nrow - 1;
    double least = INFINITY;
    if (steps < 3) return measure(NAN, 0, 1);
    for (int k = 0; k + 2 < steps; k++) least = fmin(least, select_number(h, k, "dt"));
    return measure(1 - steps * least / select_number(h, steps, "t"), 1, 1);
}

/* A number of the run of that problem, in adaptive steps or in equal ones. */
static Measure value(const Results *r, const char *column, const char *problem, const char *method,
                     const char *dt)
{
    return select_value(r->rows, column, "problem=%s method=%s set.dt=%s", problem, method, dt);
}

/* Energy drift on the disk in adaptive steps less that in equal ones. */
static Measure more_drift(const Results *r, const char *method)
{
    const Measure equal = value(r, "energy_drift", "disk_impact", method, "constant");
    return measure_sum(value(r, "energy_drift", "disk_impact", method, "adaptive"),
                       measure_times(equal, -1));
}

static Measure same(const Results *r, const char *method)
{
    return measure_ratio(value(r, "error_linf", "ring", method, "adaptive"),
                         value(r, "error_linf", "ring", method, "constant"));
}

static void check(Check *c, const Results *r)
{
    for (int m = 0; m < DISKS; m++) {
        claim(c, phrase("T-14.error-%s", disk[m]),
              phrase("%s: error on the ring in adaptive steps over that in equal ones, as many",
                     engine_label(disk[m])),
              same(r, disk[m]), 0.9, 1.1);
        claim(
            c, phrase("T-14.saved-%s", disk[m]),
            phrase("%s, disk: part of the steps that eq 34 saves over a constant step as small as "
                   "its least one",
                   engine_label(disk[m])),
            saved(r, "disk_impact", disk[m]), 0.005, 0.5);
        claim(c, phrase("T-14.energy-%s", disk[m]),
              phrase("%s: energy drift on the disk in adaptive steps less that in equal ones at "
                     "CFL .3",
                     engine_label(disk[m])),
              more_drift(r, disk[m]), -0.003, 0.003);
    }
    claim(c, "T-14.saved-hanging",
          "FEM, hanging bar: part of the steps that eq 34 saves over a constant step as small as "
          "its least one",
          saved(r, "hanging_bar", "fem"), 0.05, 0.9);
    claim(c, "T-14.energy-hanging", "FEM: energy drift on the hanging bar",
          value(r, "energy_drift", "hanging_bar", "fem", "adaptive"), -1e-4, 1e-4);
}

const StudyPage study_t_14_adaptive = {.cases = cases, .check = check, .claims = 11};
