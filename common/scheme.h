/* scheme.h: the particle-grid loops, written once: stencils of a chunk, deposit to nodes, gather from
 * nodes. Bodies are always inlined so that stencil width and slopes are constants in each instance.
 *
 * One vector of LANES weights per particle and node serves both directions: lanes below FLUX carry S,
 * the lanes of axis b from FLUX on carry the derivative along b. It is the product of one vector per
 * axis; a row of nodes (along axis 0) shares the product over the other axes. */
#ifndef MPMLAB_SCHEME_H
#define MPMLAB_SCHEME_H

#include <math.h>
#include "sim.h"

/* A particle's stretch is never taken as zero (l = l0 F_xx vanishes under a quarter turn). */
static const double LEAST_STRETCH = 1e-6;

/* What one thread needs for one chunk; lives on its stack. */
typedef struct Work {
    Field x[DIM], b[DIM]; /* positions and half widths [cells], from node 0 */
    Stencil stencil[DIM];
    Payload payload;
    Field T[NMAT];
    Field sums[LANES];
    Field body[DIM];
    Line A[CHUNK], B[DIM][CHUNK]; /* payload by particle; slopes per cell */
} Work;

/* Half width of a particle along an axis [cells]: l0 |F_dd|, W11's authors' rule. */
static inline void half_widths(const Sim *sim, const Chunk *c, int axis, Field b)
{
    const double *F = c->F[axis * (DIM + 1)];
    for (int p = 0; p < CHUNK; p++) {
        double stretch = fabs(F[p]);
        stretch = stretch > LEAST_STRETCH ? stretch : LEAST_STRETCH;
        b[p] = sim->half * stretch;
        b[p] = b[p] < sim->half_max ? b[p] : sim->half_max;
    }
}

/* Fills the stencils of all axes; returns their common width, the least that holds this chunk. */
static inline int make_stencils(const Sim *sim, const Chunk *c, Work *w)
{
    const Method *method = sim->setup->method;
    double most = 0.5;
    for (int d = 0; d < DIM; d++) {
        half_widths(sim, c, d, w->b[d]);
        for (int p = 0; p < CHUNK; p++)
            w->x[d][p] = c->x[d][p] * sim->g.cells - sim->g.origin[d];
        if (sim->half_now > 0.5)
            for (int p = 0; p < CHUNK; p++) most = w->b[d][p] > most ? w->b[d][p] : most;
    }
    const int width = method->width(most);
    for (int d = 0; d < DIM; d++) method->shape(width, w->x[d], w->b[d], &w->stencil[d]);
    return width;
}

/* 1 in the lanes that carry the derivative along axis d, 0 elsewhere. */
static inline Line gradient_lanes(int d)
{
    Line e;
    for (int l = 0; l < LANES; l++) e[l] = l >= FLUX && (l - FLUX) / DIM == d;
    return e;
}

static inline Line axis_weight(const Stencil *s, int k, int p, Line plain, Line gradient)
{
    return s->S[k][p] * plain + s->G[k][p] * gradient;
}

/* What a particle's loop over nodes runs on: row weights and row starts, for `width` nodes an axis. */
#define FOR_ROWS(r, width) for (int r = 0; r < (DIM == 1 ? 1 : DIM == 2 ? width : width * width); r++)

/* Node index of row r of the stencil of particle p. */
static inline size_t row_start(const Grid *g, const Stencil s[DIM], int p, int width, int r)
{
    size_t row = 0;
    for (int d = DIM - 1; d > 0; d--) {
        const int k = d == 1 ? r % width : r / width;
        row = row * (size_t)g->n[d] + (size_t)(s[d].base[p] + k);
    }
    return row * (size_t)g->n[0] + (size_t)s[0].base[p];
}

typedef struct Lanes {
    Line plain[DIM], gradient[DIM];
} Lanes;

static inline Lanes make_lanes(void)
{
    Lanes l;
    for (int d = 0; d < DIM; d++) {
        l.gradient[d] = gradient_lanes(d);
        l.plain[d] = 1 - l.gradient[d];
    }
    return l;
}

/* Product of the weights of all axes but the first, for row r. */
static inline __attribute__((always_inline)) Line row_weight(const Stencil s[DIM], const Lanes *e,
                                                             int p, int width, int r)
{
    Line y = axis_weight(&s[DIM > 1], DIM == 2 ? r : r % width, p, e->plain[DIM > 1],
                         e->gradient[DIM > 1]);
    for (int d = 2; d < DIM; d++)
        y *= axis_weight(&s[d], r / width, p, e->plain[d], e->gradient[d]);
    return y;
}

/* node[lane] += w (A + sum_d B_d offset_d): A is the value at the stencil's first node. */
static inline __attribute__((always_inline)) void deposit(Grid *g, const Work *w, const int width,
                                                          const bool affine)
{
    const Lanes e = make_lanes();
    for (int p = 0; p < CHUNK; p++) {
        Line x[MAX_WIDTH];
        for (int i = 0; i < width; i++)
            x[i] = axis_weight(&w->stencil[0], i, p, e.plain[0], e.gradient[0]);
        FOR_ROWS(r, width)
        {
            Line *node = g->node + row_start(g, w->stencil, p, width, r);
            Line value = w->A[p], slope;
            if (affine && DIM > 1) value += (double)(DIM == 2 ? r : r % width) * w->B[DIM > 1][p];
            for (int d = 2; affine && d < DIM; d++) value += (double)(r / width) * w->B[d][p];
            if (affine) slope = w->B[0][p];
            if (DIM > 1) {
                const Line y = row_weight(w->stencil, &e, p, width, r);
                value *= y;
                if (affine) slope *= y;
            }
            for (int i = 0; i < width; i++) {
                node[i] += x[i] * value;
                if (affine) value += slope;
            }
        }
    }
}

static inline __attribute__((always_inline)) void gather(const Grid *g, Work *w, const int width)
{
    const Lanes e = make_lanes();
    for (int p = 0; p < CHUNK; p++) {
        Line x[MAX_WIDTH], sum = {0};
        for (int i = 0; i < width; i++)
            x[i] = axis_weight(&w->stencil[0], i, p, e.plain[0], e.gradient[0]);
        FOR_ROWS(r, width)
        {
            const Line *node = g->node + row_start(g, w->stencil, p, width, r);
            Line row = x[0] * node[0];
            for (int i = 1; i < width; i++) row += x[i] * node[i];
            if (DIM > 1) row *= row_weight(w->stencil, &e, p, width, r);
            sum += row;
        }
        w->A[p] = sum;
    }
}

/* Body force m b of the chunk to the nodes, weights S. */
static inline __attribute__((always_inline)) void deposit_force(Grid *g, const Work *w,
                                                                const int width)
{
    for (int p = 0; p < CHUNK; p++)
        FOR_ROWS(r, width)
        {
            double y = 1;
            for (int d = 1; d < DIM; d++)
                y *= w->stencil[d].S[d == 1 ? r % width : r / width][p];
            double *force = g->force + DIM * row_start(g, w->stencil, p, width, r);
            for (int i = 0; i < width; i++)
                for (int a = 0; a < DIM; a++)
                    force[i * DIM + a] += w->stencil[0].S[i][p] * y * w->body[a][p];
        }
}

/* Payload from fields to lines. A is given at the particle; with slopes it is moved to the stencil's
 * first node, and the slopes are scaled to steps of one cell. */
static inline void pack_payload(const Sim *sim, Work *w, bool affine)
{
    Payload *q = &w->payload;
    for (int d = 0; affine && d < DIM; d++)
        for (int a = 0; a < DIM; a++)
            for (int p = 0; p < CHUNK; p++) {
                q->B[d][a][p] *= sim->dx;
                q->A[1 + a][p] += q->B[d][a][p] * (w->stencil[d].base[p] - w->x[d][p]);
            }
    for (int p = 0; p < CHUNK; p++)
        for (int l = 0; l < LANES; l++) w->A[p][l] = q->A[l][p];
    for (int d = 0; affine && d < DIM; d++)
        for (int p = 0; p < CHUNK; p++) {
            w->B[d][p] = (Line){0};
            for (int a = 0; a < DIM; a++) w->B[d][p][1 + a] = q->B[d][a][p];
        }
}

/* Sums from lines to fields; derivatives from per cell to per metre. */
static inline void unpack_sums(const Sim *sim, Work *w)
{
    for (int p = 0; p < CHUNK; p++)
        for (int l = 0; l < LANES; l++) w->sums[l][p] = w->A[p][l];
    for (int l = FLUX; l < LANES; l++)
        for (int p = 0; p < CHUNK; p++) w->sums[l][p] *= sim->g.cells;
}

#endif
