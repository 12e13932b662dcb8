/* rows.c: see rows.h. */
#include "rows.h"

#include "common/base/team.h"

typedef struct Rows {
    Sim *sim;
    RowWork *work;
    double number;
} Rows;

static void work_rows(void *own, int first, int last)
{
    const Rows *r = own;
    const Grid *g = &r->sim->g;
    for (int row = first; row < last; row++)
        if (g->lo[row] < g->hi[row]) r->work(r->sim, row, r->number);
}

void rows_each(Sim *sim, RowWork *work, double number)
{
    team_share(sim->setup->threads, sim->g.rows, work_rows, &(Rows){sim, work, number});
}
