/* w11_03_spurious.c: the weight of a node with the trigger weight, and the ring's spurious nodes:
 * those whose largest weight is at most the trigger, at the start, where the radii are .625
 * and 1.1. Wallstedt and Guilkey (2011), fig. 3. */
#include <math.h>
#include "studies/tables/curves.h"
#include "studies/tables/spline.h"

enum { CELLS = 16, SIDE = CELLS + 5 /* nodes at 0 .. SIDE - 1 */, INNER = 170 /* in the ring */ };
static const double trigger = 0.12;
static const double triggers[] = {0.1, 0.12, 0.15, 0.2, 0.25};
enum { TRIGGERS = sizeof triggers / sizeof *triggers };

static void cases(Cases *list, bool quick)
{
    case_add_with(list, "particles", "particles",
                  "run ring --method wls --cells %d --set trigger=%g --set steps=1", CELLS,
                  trigger);
    for (int k = 0; k < TRIGGERS; k++)
        case_add(list, "run ring --method wls --cells %d --set trigger=%g", quick ? 8 : 32,
                 triggers[k]);
}

/* Largest weight of any point at its place before the step; images beyond the symmetry lines are
 * no nearer. */
static void weigh(const Table *t, double most[SIDE][SIDE])
{
    for (int row = 0; row < t->nrow; row++) {
        const double X = select_number(t, row, "X"), Y = select_number(t, row, "Y"),
                     R = hypot(X, Y);
        const double stretch = 1 + 0.1 * (6 - 9 * R + 4 * R * R); /* problems/ring.c at t = 0 */
        const double n = (double)CELLS * stretch, x = n * X, y = n * Y;
        for (int j = 0; j < SIDE; j++)
            for (int i = 0; i < SIDE; i++)
                most[j][i] =
                    measure_worse(most[j][i], spline_quadratic(x - i) * spline_quadratic(y - j));
    }
}

static void output_nodes(FILE *f, double most[SIDE][SIDE], const char *status)
{
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++)
            if (!(most[j][i] <= 0))
                results_print(f, "%.17g,%.17g,%.17g,%d,%s\n", i / (double)CELLS, j / (double)CELLS,
                              most[j][i], !(most[j][i] > trigger), status);
}

static void tables(const Results *r)
{
    double most[SIDE][SIDE] = {{0}};
    weigh(results_ended(r, "particles"), most);
    output_nodes(results_write(r, "nodes", "x,y,most,spurious,status"), most,
                 results_status(r, "particles"));
}

/* Least over largest distance of a line of equal weight about the node. */
static double roundness(double weight)
{
    double least = INFINITY, most = 0;
    for (int degree = 0; degree <= 90; degree++) {
        const double a = degree * M_PI / 180;
        double low = 0, high = 1.5;
        for (int k = 0; k < 60; k++) {
            const double r = (low + high) / 2;
            if (spline_quadratic(r * cos(a)) * spline_quadratic(r * sin(a)) > weight)
                low = r;
            else
                high = r;
        }
        least = measure_lesser(least, low);
        most = measure_worse(most, low);
    }
    return least / most;
}

/* (largest - least)/largest error on the ring over these trigger weights. */
static Measure spread(const Table *rows)
{
    const Measure most = select_max(rows, "error_linf", TRIGGERS, "cells=32");
    const double least = select_min(rows, "error_linf", TRIGGERS, "cells=32").value;
    return measure_with(most, (most.value - least) / most.value);
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "nodes");
    int spurious = 0;
    Measure inner = measure_sum_of(INNER);
    for (int row = 0; row < t->nrow; row++) {
        const double R = hypot(select_number(t, row, "x"), select_number(t, row, "y"));
        const double is = select_kept(t, row, "spurious");
        spurious += is > 0;
        if (R >= 0.625 && R <= 1.1) measure_add(&inner, is);
    }
    claim(c, "W11-3.outside", "Ring, WLS, N = 16: no node inside is spurious: how many are", inner,
          0, 0);
    claim(c, "W11-3.circular",
          "A node's lines of equal weight (eq 4) are nearly circles: least over largest radius, "
          "weight .12",
          measure_formula(roundness(trigger)), 0.95, 1);
    claim(c, "W11-3.trigger",
          "Trigger weights .1 to .25 do equally well: (largest - least)/largest error on the ring, "
          "N = 32",
          spread(r->rows), 0, 0.05);
    claim_note(c, "trigger", trigger);
    claim_note(c, "spurious", spurious);
}

const StudyPage study_w11_03_spurious = {
    .cases = cases, .tables = tables, .check = check, .claims = 3};
