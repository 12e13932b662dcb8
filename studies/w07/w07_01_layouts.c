/* w07_01_layouts.c: ideal and general particle positions. Wallstedt and Guilkey (2007), fig. 1.
 *
 * A block of 5 x 5 cells inside the ring of W11, four particles a cell: on a lattice, where
 * symmetry hides the errors of the projection, and on rings about the origin, as regular but for
 * the grid. */
#include "studies/tables/curves.h"

enum { CELLS = 16, FIRST = 6, LAST = 11 }; /* the block lies wholly inside the ring */

static void cases(Cases *list, bool quick)
{
    (void)quick;
    case_add_with(list, "particles", "cartesian",
                  "run ring --method gimp --cells %d --ppc 4 --set steps=1", CELLS);
    case_add_with(list, "particles", "radial",
                  "run ring --method gimp --cells %d --ppc 4 --set steps=1 --set layout=radial",
                  CELLS);
}

static int count_inside(const Table *t)
{
    const double N = CELLS, first = FIRST, last = LAST;
    int n = 0;
    for (int row = 0; t && row < t->nrow; row++) {
        const double x = N * select_number(t, row, "X"), y = N * select_number(t, row, "Y");
        n +=
            x >= first && x <= last && y >= first && y <= last && select_number(t, row, "mass") > 0;
    }
    return n;
}

static void check(Check *c, const Results *r)
{
    static const char *const layouts[] = {"cartesian", "radial"};
    claim_note(c, "cells", CELLS);
    claim_note(c, "first_cell", FIRST);
    claim_note(c, "last_cell", LAST);
    for (int k = 0; k < 2; k++) {
        Table *t = results_left(r, layouts[k]);
        claim_note(c, layouts[k], count_inside(t));
        table_free(t);
    }
}

const Study study_w07_01_layouts = {
    .name = "w07_01_layouts",
    .figure = "W07-1",
    .about = "ideal and radial particle positions in a block of 5 x 5 cells",
    .cases = cases,
    .check = check,
};
