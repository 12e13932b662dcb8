/* sort.c: puts particles in the order of the grid: by cell, rows last, stable; cuts the order into
 * blocks of rows, fills each up to whole chunks, and finds the live span of every row of nodes.
 * Costs O(particles + rows + columns): never O(cells), so empty space is free. */
#include <limits.h>
#include <math.h>
#include <string.h>
#include "passes.h"

/* Where a particle's stencil stands: its cell, or its nearest node if stencils are about a node
 * (odd widths), so that neighbours in the order share all their nodes. */
static int cell_of(const Sim *sim, int slot, int axis)
{
    const double at = sim->p.field[AT_X + axis][slot] * sim->g.cells;
    return (int)floor(at + sim->key_shift) - sim->g.origin[axis];
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
    for (int d = 0; d < DIM; d++, now = 1 - now) {
        for (int k = 0; k < n; k++) p->key[buffer[now][k]] = cell_of(sim, buffer[now][k], d);
        count_sort(n, p->key, buffer[now], buffer[1 - now], sim->g.n[d], sim->g.count);
    }
    return buffer[now];
}

static int block_of(const Sim *sim, int slot)
{
    return cell_of(sim, slot, DIM - 1) / sim->block_rows;
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

/* Padding moves with a real particle but weighs nothing and starts undeformed. */
static double pad_value(int field, double real)
{
    if (field < AT_V) return real;
    return field >= AT_F && field < AT_M && (field - AT_F) % (DIM + 1) == 0;
}

static void permute(Sim *sim, const int source[])
{
    Particles *p = &sim->p;
    for (int f = 0; f < FIELDS; f++) {
        double *from = p->field[f], *to = p->spare;
        if (!from) continue;
        for (int k = 0; k < p->n; k++)
            to[k] = source[k] >= 0 ? from[source[k]] : pad_value(f, from[-1 - source[k]]);
        p->field[f] = to;
        p->spare = from;
    }
    for (int k = 0; k < p->n; k++) p->key[k] = source[k] >= 0 ? p->id[source[k]] : -1;
    int *id = p->id;
    p->id = p->key;
    p->key = id;
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

/* A particle in cell c sees nodes c - half .. c + 1 + half, about node c less by one; it may drift
 * by one cell until the next sort. Where symmetry folds the grid, a ghost's image must be live,
 * too. */
static void find_spans(Sim *sim)
{
    Grid *g = &sim->g;
    const int half = sim->method.width(sim->half_plan) / 2;
    const int down = half + 1, up = half + (sim->key_shift > 0 ? 1 : 2);
    for (int r = 0; r < g->rows; r++) g->lo[r] = INT_MAX, g->hi[r] = 0;
    for (int k = 0; k < sim->p.n;) {
        int cell[DIM], lo, hi;
        for (int d = 0; d < DIM; d++) cell[d] = cell_of(sim, k, d);
        lo = hi = cell[0];
        for (bool same = true; same && k < sim->p.n; k += same) {
            for (int d = 1; d < DIM; d++) same &= cell_of(sim, k, d) == cell[d];
            const int c = cell_of(sim, k, 0);
            if (same && c < lo) lo = c;
            if (same && c > hi) hi = c;
        }
        touch_rows(g, cell, lo, hi, down, up);
    }
    grid_mirror_spans(g);
}

void sim_sort(Sim *sim)
{
    const bool first = isinf(sim->travel);
    const int half = sim->half_now <= 0.5 ? 1 : 0;
    sim->half_plan = half ? 0.5 : fmin(1.25 * sim->half_now, sim->half_max);
    sim->key_shift = sim->method.width(sim->half_plan) % 2 ? 0.5 : 0;
    const int reach = 2 * (sim->method.width(sim->half_plan) / 2) + 3;
    const int least = DIM == 1 ? 64 : 8;
    sim->block_rows = (reach + least - 1) / least * least;
    int *buffer[2] = {sim->p.order, sim->p.source};
    int *order = cell_order(sim, buffer);
    int *source = order == buffer[0] ? buffer[1] : buffer[0];
    cut_blocks(sim, order, source);
    permute(sim, source);
    find_spans(sim);
    sim->travel = 0;
    if (first && sim->method.moments) start_moments(sim);
}
