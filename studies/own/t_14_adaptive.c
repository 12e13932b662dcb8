/* t_14_adaptive.c: the adaptive step of W11 eq 34, dt = CFL h/(v_max + max |v_p|), beside the
 * constant one: the disk's impacts, a hanging bar, and the oscillating ring, whose
 * error is compared at equal mean steps.
 *
 * A constant step that satisfies eq 34 at every instant is the least of the adaptive ones; the
 * steps saved are those that this one takes beyond the adaptive run's. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "studies/tables/curves.h"

static const char *const disk[] = {"gimp", "wls2", "fem"};
enum { DISKS = 3 };

static void add_run(Cases *list, const char *problem, const char *method, int cells)
{
    char part[64];
    snprintf(part, sizeof part, "%s_%s", problem, method);
    case_add_with(list, "history", part, "run %s --method %s --cells %d --set dt=adaptive", problem,
                  method, cells);
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

/* Part of the steps of the constant rule that the adaptive run saves; NAN without its history. */
static Measure saved(const Results *r, const char *problem, const char *method)
{
    char part[64];
    double least = INFINITY;
    snprintf(part, sizeof part, "%s_%s", problem, method);
    Table *h = results_file(r, part);
    if (!h) return measure(NAN, 0, 1);
    const int steps = h->nrow - 1;
    const double end = table_number(h, steps, "t");
    for (int k = 0; k + 2 < steps; k++) least = fmin(least, table_number(h, k, "dt"));
    table_free(h);
    return measure(1 - steps * least / end, 1, 1);
}

/* The row's dt is a number, so that runs are told apart by their CFL numbers. */
static Measure drift(const Results *r, const char *problem, const char *method, const char *cfl)
{
    return select_value(r->rows, "energy_drift", "problem=%s method=%s cfl=%s", problem, method,
                        cfl);
}

/* Energy drift on the disk in adaptive steps less that in equal ones. */
static Measure more_drift(const Results *r, const char *method)
{
    const Measure adaptive = drift(r, "disk_impact", method, "0.4");
    return measure_sum(adaptive, measure_times(drift(r, "disk_impact", method, "0.3"), -1));
}

static Measure same(const Results *r, const char *method)
{
    Measure error[2];
    for (int k = 0; k < 2; k++)
        error[k] = select_value(r->rows, "error_linf", "problem=ring method=%s cfl=%s", method,
                                k ? "0.2" : "0.3");
    return measure_ratio(error[0], error[1]);
}

static void check(Check *c, const Results *r)
{
    static const char *const labels[] = {"GIMP", "WLS2", "FEM"};
    for (int m = 0; m < DISKS; m++) {
        char id[64], text[160];
        snprintf(id, sizeof id, "T-14.error-%s", disk[m]);
        snprintf(text, sizeof text,
                 "%s: error on the ring in adaptive steps over that in equal ones, as many",
                 labels[m]);
        claim(c, id, text, same(r, disk[m]), 0.9, 1.1);
        snprintf(id, sizeof id, "T-14.saved-%s", disk[m]);
        snprintf(text, sizeof text, "%s: part of the steps that eq 34 saves on the disk",
                 labels[m]);
        claim(c, id, text, saved(r, "disk_impact", disk[m]), 0.005, 0.5);
        snprintf(id, sizeof id, "T-14.energy-%s", disk[m]);
        snprintf(text, sizeof text,
                 "%s: energy drift on the disk in adaptive steps less that in equal ones at CFL .3",
                 labels[m]);
        claim(c, id, text, more_drift(r, disk[m]), -0.003, 0.003);
    }
    claim(c, "T-14.saved-hanging", "FEM: part of the steps that eq 34 saves on the hanging bar",
          saved(r, "hanging_bar", "fem"), 0.05, 0.9);
    claim(c, "T-14.energy-hanging", "FEM: energy drift on the hanging bar",
          drift(r, "hanging_bar", "fem", "0.2"), -1e-4, 1e-4);
}

const Study study_t_14_adaptive = {
    .name = "t_14_adaptive",
    .figure = "T-14",
    .about = "adaptive time steps (eq 34) on the disk, a hanging bar and the ring",
    .cases = cases,
    .check = check,
    .claims = 11,
};
