/* corner.c: see corner.h. */
#include "corner.h"

#include "grades.h"
#include "studies/select.h"

enum { CELLS = 4 };

const double corner_rungs[CORNER_RUNGS] = {0.4, 0.5, 0.6, 0.7, 0.8, 0.95};

/* Two particles per cell and axis, so that the last one is a quarter of a cell before a node. */
void corner_add(Cases *list, const Corner *c)
{
    const double offset = c->eps + 0.25 - c->beyond;
    for (int n = 0; n < CORNER_RUNGS; n++)
        case_add(list,
                 "run block --method %s --integrator cd --cells %d --cfl %.6g --t-end .1 --set "
                 "dim=3 --set offset_x=%g --set offset_y=%g --set offset_z=%g --set stop_growth=1 "
                 "--set stretch=1.00000003 --set drift_x=1.6e-7",
                 c->method, CELLS, corner_rungs[n] * c->scale * BLOCK_SPEED / BLOCK_P_SPEED, offset,
                 offset, offset);
}

Measure corner_stable(const Table *rows, const Corner *c)
{
    Measure stable = measure_sum_of(CORNER_RUNGS);
    int n = 0, rung = 0;
    EACH_ROW(row, rows, "stretch=1.00000003 method=%s", c->method) {
        measure_add(&stable, 1);
        rung += rung == n++ && select_is(rows, row, "status", "ok");
    }
    return measure_with(stable, rung > 0 ? corner_rungs[rung - 1] : 0);
}
