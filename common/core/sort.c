/* sort.c: puts particles in the order of the grid: by cell, rows last, stable; cuts the order into
 * blocks of rows, fills each up to whole chunks, and finds the live span of every row of nodes.
 * Costs O(particles + rows + columns): never O(cells), so empty space is free. */
#include <limits.h>
#include <math.h>
#include <string.h>
#include "passes.h"
#include "stretch.h"
#include "common/base/team.h"

/* Where every particle's stencil stands, per axis: its cell, or its nearest node if stencils are
 * about a node (odd widths), so that neighbours in the order share all their nodes. */
static void find_keys(void *own, int first, int last)
{
    Sim *sim = own;
    for (int d = 0; d < DIM; d++) {
        const double *x = sim->p.field[(sim->total ? AT_X0 : AT_X) + d], cells = sim->g.cells,
                     shift = sim->key_shift;
        const int origin = sim->g.origin[d];
        int *key = sim->p.key[d];
        for (int k = first; k < last; k++) key[k] = (int)floor(x[k] * cells + shift) - origin;
    }
}

/* One stable counting pass: order[] by key[] in [0, nkey). */
static void count_sort(int n, const int key[], const int order[], int out[], int nkey, int count[])
{
    memset(count, 0, sizeof(int) * ((size_t)nkey + 1));
    for (int k = 0; k < n; k++) count[key[order[k]] + 1]++;
    for (int k = 0; k < nkey; k++) count[k + 1] += count[k];
    for (int k = 0; k < n; k++) out[count[key[order[k]]]++] = order[k];
}

/* Real slots in cell order, axis 0 fastest. Returns where they ended up: one of the two buffers. */
static int *cell_order(Sim *sim, int *buffer[2])
{
    Particles *p = &sim->p;
    int n = 0, now = 0;
    for (int k = 0; k < p->n; k++)
        if (p->id[k] >= 0) buffer[0][n++] = k;
    for (int d = 0; d < DIM; d++, now = 1 - now)
        count_sort(n, p->key[d], buffer[now], buffer[1 - now], sim->g.n[d], sim->g.count);
    return buffer[now];
}

static int block_of(const Sim *sim, int slot)
{
    return sim->p.key[AXIS_LAST][slot] / sim->block_rows;
}

/* Cuts the order at block borders; source[slot] is the old slot, or -1 - slot for padding. */
static void cut_blocks(Sim *sim, const int order[], int source[])
{
    const int count = sim->p.count;
    int slot = 0, b = 0;
    sim->nblock = 0;
    for (int k = 0; k < count; b++) {
        const int own = block_of(sim, order[k]);
        while (b < own) sim->block[b++] = (Block){slot / CHUNK, slot / CHUNK};
        Block *block = &sim->block[b];
        block->first = slot / CHUNK;
        for (; k < count && block_of(sim, order[k]) == own; k++) source[slot++] = order[k];
        while (slot % CHUNK) source[slot++] = -1 - order[k - 1];
        block->last = slot / CHUNK;
    }
    sim->nblock = b;
    sim->p.n = slot;
}

/* Padding is a massless copy of a real particle and stays one, bit for bit. With a state of its own
 * it would gather from nodes that no real particle reaches, of round-off mass and any velocity, and
 * its F would become NaN, which times a mass of 0 is still NaN. */
static void unload_padding(Sim *sim)
{
    Particles *p = &sim->p;
    for (int k = 0; k < p->n; k++)
        if (p->id[k] < 0) p->field[AT_M][k] = p->field[AT_VOL][k] = 0;
}

typedef struct Move {
    const int *source; /* by slot: the old slot */
    const double *from;
    double *to;
} Move;

static void move_slots(void *own, int first, int last)
{
    const Move *m = own;
    for (int k = first; k < last; k++) m->to[k] = m->from[m->source[k]];
}

/* source[slot]: the old slot, or -1 - slot for its massless copy; becomes the old slot in any case.
 */
static void permute(Sim *sim, int source[])
{
    Particles *p = &sim->p;
    int *id = p->key[0]; /* the keys have done their work */
    for (int k = 0; k < p->n; k++) {
        const bool real = source[k] >= 0;
        source[k] = real ? source[k] : -1 - source[k];
        id[k] = real ? p->id[source[k]] : -1;
    }
    p->key[0] = p->id;
    p->id = id;
    for (int f = 0; f < FIELDS; f++) {
        double *from = p->field[f], *to = p->spare;
        if (!from) continue;
        team_share(sim->setup->threads, p->n, move_slots, &(Move){source, from, to});
        p->field[f] = to;
        p->spare = from;
    }
    unload_padding(sim);
}

static void widen(Grid *g, int row, int lo, int hi)
{
    if (lo < g->lo[row]) g->lo[row] = lo;
    if (hi > g->hi[row]) g->hi[row] = hi;
}

/* All rows that particles of one cell row may touch get its span of columns. */
static void touch_rows(Grid *g, const int cell[DIM], int lo, int hi, int down, int up)
{
    int rows = 1;
    for (int d = 1; d < DIM; d++) rows *= up + down + 1;
    for (int r = 0; r < rows; r++) {
        int row = 0, rest = r;
        for (int d = DIM - 1; d > 0; d--) {
            row = row * g->n[d] + cell[d] - down + rest % (up + down + 1);
            rest /= up + down + 1;
        }
        widen(g, row, lo - down, hi + up + 1);
    }
}

/* The stencil of a particle in cell c lies within nodes c - half .. c + 1 + half, or c - half .. c
 * + half if it is centred on node c; until the next sort the particle may drift by one cell. Where
 * symmetry folds the grid, a ghost's image must be live, too. */
static void find_spans(Sim *sim, const int order[])
{
    Grid *g = &sim->g;
    int *const *key = sim->p.key;
    const int half = sim->method.width(sim->half_plan) / 2;
    const int down = half + 1, up = half + (sim->key_shift > 0 ? 1 : 2);
    for (int r = 0; r < g->rows; r++) g->lo[r] = INT_MAX, g->hi[r] = 0;
    for (int k = 0; k < sim->p.count;) {
        int cell[DIM], lo = key[0][order[k]], hi = lo;
        for (int d = 0; d < DIM; d++) cell[d] = key[d][order[k]];
        for (bool same = true; same && k < sim->p.count; k += same) {
            for (int d = 1; d < DIM; d++) same &= key[d][order[k]] == cell[d];
            if (same) hi = key[0][order[k]]; /* ascending within a row */
        }
        touch_rows(g, cell, lo, hi, down, up);
    }
    mirror_spans(g);
}

void sim_restart(Sim *sim)
{
    sim_start_own(sim);
    sim->travel = INFINITY;
}

void sim_sort(Sim *sim)
{
    const bool first = isinf(sim->travel);
    const int half = sim->half_now <= 0.5 ? 1 : 0;
    sim->half_plan = half ? 0.5 : fmin(1.25 * sim->half_now, sim->half_max);
    sim->key_shift = sim->method.about_node || sim->method.width(sim->half_plan) % 2 ? 0.5 : 0;
    const int reach = 2 * (sim->method.width(sim->half_plan) / 2) + 3;
    const int least = DIM == 1 ? 8 * BLOCK_ROWS : BLOCK_ROWS;
    sim->block_rows = (reach + least - 1) / least * least;
    int *buffer[2] = {sim->p.order, sim->p.source};
    team_share(sim->setup->threads, sim->p.n, find_keys, sim);
    int *order = cell_order(sim, buffer);
    int *source = order == buffer[0] ? buffer[1] : buffer[0];
    find_spans(sim, order);
    cut_blocks(sim, order, source);
    permute(sim, source);
    sim->travel = 0;
    if (first && sim->method.moments) gather_start_moments(sim);
}

bool sim_is_valid(const Sim *sim)
{
    const Particles *p = &sim->p;
    int real = 0;
    if (p->n % CHUNK || p->n > p->room) return false;
    for (int k = 0; k < p->n; k++) {
        real += p->id[k] >= 0;
        if (p->id[k] < 0 && p->field[AT_M][k] > 0) return false;
    }
    for (int b = 1; b < sim->nblock; b++)
        if (sim->block[b].first != sim->block[b - 1].last) return false;
    for (int r = 0; r < sim->g.rows; r++)
        if (sim->g.hi[r] > sim->g.n[0] || (sim->g.hi[r] > 0 && sim->g.lo[r] < 0)) return false;
    return real == p->count;
}
