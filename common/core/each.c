/* each.c: see each.h. */
#include "each.h"

#include "common/base/team.h"

typedef struct Rows {
    Sim *sim;
    RowWork *work;
    const void *own;
} Rows;

static void work_rows(void *own, int first, int last)
{
    const Rows *r = own;
    const Grid *g = &r->sim->g;
    for (int row = first; row < last; row++)
        if (g->lo[row] < g->hi[row]) r->work(r->sim, row, r->own);
}

void each_row(Sim *sim, RowWork *work, const void *own)
{
    team_share(sim->setup->threads, sim->g.rows, work_rows, &(Rows){sim, work, own});
}

typedef struct Blocks {
    Sim *sim;
    ChunkWork *work;
    void *own;
    int parity;
} Blocks;

static void work_blocks(void *own, int first, int last)
{
    const Blocks *all = own;
    for (int k = first; k < last; k++) {
        const int b = 2 * k + all->parity;
        all->work(all->sim, all->sim->block[b].first, all->sim->block[b].last, all->own);
    }
}

void each_block(Sim *sim, ChunkWork *work, void *own)
{
    for (int parity = 0; parity < 2; parity++)
        team_take(sim->setup->threads, (sim->nblock + 1 - parity) / 2, work_blocks,
                  &(Blocks){sim, work, own, parity});
}
