/* stash.c: everything that steps change of a Sim (sim.h), slot by slot, padding included. The
 * grid's nodes, and what methods keep of them, are made anew in every step. */
#include "sim.h"
#include "skin.h"

static void stash_order(Sim *sim, Stash *s)
{
    Grid *g = &sim->g;
    STASH(s, sim->nblock);
    STASH(s, sim->block_rows);
    const bool fits = sim->nblock >= 0 && sim->nblock <= grid_most_blocks(g);
    s->bad = s->bad || !fits;
    if (s->bad) return;
    stash_bytes(s, sim->block, sizeof *sim->block * (size_t)sim->nblock);
    stash_bytes(s, g->lo, sizeof *g->lo * (size_t)g->rows);
    stash_bytes(s, g->hi, sizeof *g->hi * (size_t)g->rows);
}

void sim_stash(Sim *sim, Stash *s)
{
    Particles *p = &sim->p;
    if (!stash_same(s, p->count) || !stash_same(s, sim->g.rows) || !stash_same(s, p->room)) return;
    STASH(s, p->n);
    s->bad = s->bad || p->n < 0 || p->n > p->room;
    if (s->bad) return;
    stash_bytes(s, p->id, sizeof *p->id * (size_t)p->n);
    for (int f = 0; f < FIELDS; f++)
        if (stash_same(s, p->field[f] != NULL) && p->field[f])
            stash_bytes(s, p->field[f], sizeof(double) * (size_t)p->n);
    stash_order(sim, s);
    STASH(s, sim->half_plan);
    STASH(s, sim->half_now);
    STASH(s, sim->key_shift);
    STASH(s, sim->travel);
    STASH(s, sim->nodes);
    STASH(s, sim->live);
    STASH(s, sim->impulse);
    STASH(s, sim->outside);
    STASH(s, sim->driven);
    STASH(s, sim->dt_before);
    STASH(s, sim->moved);
    STASH(s, sim->fallbacks);
    STASH(s, sim->status);
    skin_stash(sim->skin, s);
}
