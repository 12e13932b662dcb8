/* w07_01_layouts.c: ideal and general particle positions. Wallstedt and Guilkey (2007), fig. 1.
 *
 * A block of 5 x 5 cells inside the ring of W11, four particles per cell: on a lattice, where
 * symmetry hides the errors of the projection, and on rings about the origin, which are as regular
 * but not aligned with the grid. */
#include "studies/tables/curves.h"

enum { CELLS = 16, FIRST = 6, LAST = 11 }; /* the block lies wholly inside the ring */
enum { FINE = 32 };
static const char *const layouts[] = {"cartesian", "radial"};

static void cases(Cases *list, bool quick)
{
    (void)quick;
    case_add_with(list, "particles", "cartesian",
                  "run ring --method gimp --cells %d --ppc 4 --set steps=1", CELLS);
    case_add_with(list, "particles", "radial",
                  "run ring --method gimp --cells %d --ppc 4 --set steps=1 --set layout=radial",
                  CELLS);
    for (int k = 0; k < 2; k++)
        for (int n = CELLS; n <= FINE; n += FINE - CELLS)
            case_add(list, "run ring --method mpm --cells %d --set layout=%s", n, layouts[k]);
}

static int count_inside(const Table *t)
{
    const double N = CELLS, first = FIRST, last = LAST;
    int n = 0;
    for (int row = 0; row < t->nrow; row++) {
        const double x = N * select_number(t, row, "X"), y = N * select_number(t, row, "Y");
        n +=
            x >= first && x <= last && y >= first && y <= last && select_number(t, row, "mass") > 0;
    }
    return n;
}

/* MPM on the ring: error with radial particles over that with the lattice: the effect of the layout
 * alone on a whole run. */
static Measure radial_ratio(const Table *rows, int n)
{
    static const char where[] = "method=mpm layout=%s cells=%d";
    return measure_ratio(select_value(rows, "error_linf", where, layouts[1], n),
                         select_value(rows, "error_linf", where, layouts[0], n));
}

static void check(Check *c, const Results *r)
{
    claim_differs(c, "W07-1.radial",
                  "MPM is much less accurate with a radial pattern: its largest error on the ring, "
                  "N = 16, over that with the lattice",
                  radial_ratio(r->rows, CELLS), 1.5, 100, 0.6, 1,
                  "its error is .74 of that with the lattice: a radial pattern fits the round "
                  "body, which a lattice does not");
    claim_differs(c, "W07-1.radial-fine",
                  "MPM is much less accurate with a radial pattern: its largest error on the ring, "
                  "N = 32, over that with the lattice",
                  radial_ratio(r->rows, FINE), 1.5, 100, 0.9, 1.3,
                  "its error is 1.08 times that with the lattice: a radial pattern fits the round "
                  "body, which a lattice does not");
    claim_note(c, "cells", CELLS);
    claim_note(c, "first_cell", FIRST);
    claim_note(c, "last_cell", LAST);
    for (int k = 0; k < 2; k++)
        claim_note(c, layouts[k], count_inside(results_ended(r, "%s", layouts[k])));
}

const StudyPage study_w07_01_layouts = {.cases = cases, .check = check, .claims = 2};
