/* space.h: the deposit of moments.c in 3D: runs of particles about one middle node, node by node.
 *
 * In 3D the last DIM lanes of the quantities are free. They hold r, so that sums of W r_d and
 * W r_d r_e are formed with the others, and the line of moments holds sum W and beta alone. Within
 * a run r is measured from the middle node; then its sums are shifted to each node, at e from
 * there: sum W (r_d - e_d) f = sum W r_d f - e_d sum W f,  and f = r_k becomes r_k - e_k. */
#ifndef MPMLAB_WLS_SPACE_H
#define MPMLAB_WLS_SPACE_H

#include "kernel.h"

typedef struct Space {
    Field W[NEIGHBOURS], beta[NEIGHBOURS]; /* W, and beta times the tent, of every node */
    Line sample[CHUNK][1 + DIM];           /* f, r_d f: per particle of a run */
    Line away[NEIGHBOURS];                 /* e in the lanes of r, else 0 */
} Space;

static inline double step_to(int node, int d)
{
    return (d == 0 ? node : d == 1 ? node / 3 : node / 9) % 3 - 1;
}

/* Products of the axes' tables. */
static inline void multiply_tables(const Kernel k[DIM], int table, Field out[NEIGHBOURS])
{
    for (int r = 0; r < NEIGHBOURS / 3; r++) {
        Field across;
        for (int p = 0; p < CHUNK; p++)
            across[p] = k[AXIS_Y].table[table][r % 3][p] * k[AXIS_LAST].table[table][r / 3][p];
        for (int i = 0; i < 3; i++)
            for (int p = 0; p < CHUNK; p++) out[3 * r + i][p] = k[0].table[table][i][p] * across[p];
    }
}

static inline void load_samples(const Deposit *w, int from, int to, bool hermite, Space *s)
{
    for (int p = from; p < to; p++) {
        const Part *f = (const Part *)&w->A[p];
        Part *out = (Part *)s->sample[p];
        for (int h = 0; h < PARTS; h++) out[h] = f[h];
        for (int d = 0; d < DIM; d++)
            for (int h = 0; h < PARTS; h++) out[(1 + d) * PARTS + h] = w->kernel[d].off[p] * f[h];
        for (int d = 0; d < DIM && hermite; d++)
            for (int a = 0; a < DIM; a++) s->sample[p][1 + d][Q_V + a] += w->B[p][d][Q_V + a];
    }
}

/* Two parts (lanes.h) of the lines of particles from <= p < to, onto one node. */
static inline __attribute__((always_inline)) void
add_parts(const Space *s, int node, int from, int to, int part, double total, Line fit[FIT])
{
    Part sum[1 + DIM][2] = {{{0}}};
    for (int p = from; p < to; p++) {
        const double W = s->W[node][p];
        const Part *f = (const Part *)s->sample[p] + part;
        for (int k = 0; k <= DIM; k++)
            for (int h = 0; h < 2; h++) sum[k][h] += W * f[k * PARTS + h];
    }
    for (int d = 0; d < DIM; d++)
        for (int h = 0; h < 2; h++) sum[1 + d][h] -= step_to(node, d) * sum[0][h];
    if (part + 2 == PARTS) { /* where r is */
        const Part *e = (const Part *)&s->away[node] + part;
        for (int h = 0; h < 2; h++) sum[0][h] -= total * e[h];
        for (int d = 0; d < DIM; d++) {
            const int lane = Q_R + d - part * PART_LANES;
            const double first = sum[0][lane / PART_LANES][lane % PART_LANES];
            for (int h = 0; h < 2; h++) sum[1 + d][h] -= first * e[h];
        }
    }
    for (int k = 0; k <= DIM; k++)
        for (int h = 0; h < 2; h++) ((Part *)&fit[FIT_VALUE + k])[part + h] += sum[k][h];
}

static inline __attribute__((always_inline)) void add_run(const Grid *g, Wls *wls, const Deposit *w,
                                                          const Space *s, int from, int to)
{
    const size_t first = first_of(g, w->kernel, from);
    for (int node = 0; node < NEIGHBOURS; node++) {
        const size_t at = first + row_offset(g, 3, node / 3) + (size_t)(node % 3);
        double total = 0, beta = 0, most = wls->most[at];
        for (int p = from; p < to; p++) {
            const double W = s->W[node][p];
            total += W;
            beta += s->beta[node][p];
            most = W > most ? W : most;
        }
        wls->most[at] = most;
        wls->fit[at][FIT_MOMENTS][M_ONE] += total;
        wls->fit[at][FIT_MOMENTS][M_BETA] += beta;
        add_parts(s, node, from, to, 0, total, wls->fit[at]);
        if (PARTS > 2) add_parts(s, node, from, to, 2, total, wls->fit[at]);
        for (int part = 4; part < PARTS; part += 2)
            add_parts(s, node, from, to, part, total, wls->fit[at]);
    }
}

static inline void scatter_in_space(const Grid *g, Wls *wls, const Deposit *w, bool hermite)
{
    Space s;
    for (int node = 0; node < NEIGHBOURS; node++) {
        s.away[node] = (Line){0};
        for (int d = 0; d < DIM; d++) s.away[node][Q_R + d] = step_to(node, d);
    }
    multiply_tables(w->kernel, W_ONE, s.W);
    multiply_tables(w->kernel, W_TENT, s.beta);
    for (int from = 0, to; from < CHUNK; from = to) {
        for (to = from + 1; to < CHUNK && same_nodes(w->kernel, to - 1);) to++;
        load_samples(w, from, to, hermite, &s);
        add_run(g, wls, w, &s, from, to);
    }
}

#endif
