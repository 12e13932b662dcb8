/* scheme.h: the particle-grid loops, written once: stencils of a chunk, deposit to nodes, gather
 * from nodes. Always inlined, so that stencil width and slopes are constants in each instance.
 *
 * One vector of LANES weights per particle and node serves both directions: lanes below FLUX carry
 * S, the lanes of axis b from FLUX on carry the derivative along b. It is the product of one vector
 * per axis; a row of nodes (along axis 0) shares the product over the other axes. */
#ifndef MPMLAB_SCHEME_H
#define MPMLAB_SCHEME_H

#include <math.h>
#include "lanes.h"
#include "sim.h"
#include "stretch.h"

/* Scratch of one thread for one chunk, on its stack. */
typedef struct Work {
    _Alignas(CACHE_LINE) Field x[DIM]; /* positions [cells], from node 0 */
    Field b[DIM];                      /* half widths [cells] */
    Stencil stencil[DIM];
    Payload payload;
    Field T[NMAT];
    Field sums[POINT_SUMS + MAX_PARTS * DIM];
    Field body[DIM];
    Line A[CHUNK]; /* payload by particle */
    Line B[CHUNK]; /* slopes per cell: lanes 4 d .. 4 d + 3 are those of A's lanes 0 .. 3 along d */
    NodeList list; /* of general weights, instead of the stencils */
    bool on_node;  /* a particle lies on a node, and G lacks its slope: on_node.c */
} Work;

/* Half widths of a chunk along an axis [cells], by a rule that is a constant in each instance. */
static inline __attribute__((always_inline)) void
half_widths_by(const Domain domain, const Sim *sim, const Chunk *c, int axis, Field b)
{
    for (int p = 0; p < CHUNK; p++) {
        double stretch = domain_stretch(domain, c->F, axis, p);
        stretch = stretch > LEAST_STRETCH ? stretch : LEAST_STRETCH;
        b[p] = sim->half * stretch;
        b[p] = b[p] < sim->half_max ? b[p] : sim->half_max;
    }
}

static inline void half_widths(const Sim *sim, const Chunk *c, int axis, Field b)
{
    if (sim->domain == DOMAIN_FXX)
        half_widths_by(DOMAIN_FXX, sim, c, axis, b);
    else if (sim->domain == DOMAIN_STRETCH)
        half_widths_by(DOMAIN_STRETCH, sim, c, axis, b);
    else
        half_widths_by(DOMAIN_UNDEFORMED, sim, c, axis, b);
}

/* Fills the stencils of all axes; returns their common width, the least that holds this chunk. */
static inline int make_stencils(const Sim *sim, const Chunk *c, Work *w)
{
    const Method *method = &sim->method;
    double most = 0.5;
    for (int d = 0; d < DIM; d++) {
        const double *x = sim->total ? c->X[d] : c->x[d];
        half_widths(sim, c, d, w->b[d]);
        for (int p = 0; p < CHUNK; p++) w->x[d][p] = x[p] * sim->g.cells - sim->g.origin[d];
        if (sim->half_now > 0.5)
            for (int p = 0; p < CHUNK; p++) most = w->b[d][p] > most ? w->b[d][p] : most;
    }
    const int width = method->width(most);
    w->on_node = false;
    for (int d = 0; d < DIM; d++) {
        w->stencil[d].on_node = false;
        method->shape(&sim->g.axis[d], width, w->x[d], w->b[d], &w->stencil[d]);
        if (w->stencil[d].on_node) on_node_clear_slopes(&w->stencil[d]);
        w->on_node |= w->stencil[d].on_node;
    }
    return width;
}

/* Which table each lane takes on each axis: e[d][t] is 1 in the lanes that take table t, else 0. */
typedef struct Pattern {
    Line e[DIM][TABLES];
} Pattern;

/* The usual one: S everywhere, but in the lanes FLUX + b DIM + a the given table on axis b. (Asking
 * of every lane whether (l - FLUX)/DIM == d comes out wrong from gcc 12 with AVX-512 in 3D.) */
static inline Pattern flux_pattern(int table)
{
    Pattern q;
    for (int d = 0; d < DIM; d++) {
        for (int t = 0; t < TABLES; t++)
            for (int l = 0; l < LANES; l++) q.e[d][t][l] = t == T_S;
        for (int l = FLUX + d * DIM; l < FLUX + (d + 1) * DIM; l++) {
            q.e[d][T_S][l] = 0;
            q.e[d][table][l] = 1;
        }
    }
    return q;
}

/* Lanes of weights of one node on one axis; `tables` (bit t: table t occurs) is a constant. */
static inline __attribute__((always_inline)) Line
axis_weight(const Stencil s[DIM], int d, int k, int p, const Pattern *q, const unsigned tables)
{
    const int own = tables == 1u << T_G ? T_G : T_R;
    Line w = {0};
    if (PARTS == 1 && tables == 1u << own) {
        *(Part *)&w = weight_part(s[d].table[T_S][k][p], s[d].table[own][k][p], d, 0);
        return w;
    }
    w = s[d].table[T_S][k][p] * q->e[d][T_S];
    for (int t = 1; t < TABLES; t++)
        if (tables >> t & 1) w += s[d].table[t][k][p] * q->e[d][t];
    return w;
}

/* A particle's loop over rows of nodes, for `width` nodes per axis. */
#define FOR_ROWS(r, width)                                                                         \
    for (int r = 0; r < (DIM == 1 ? 1 : DIM == 2 ? width : width * width); r++)

/* Index of the first node of particle p's stencil. */
static inline size_t first_node(const Grid *g, const Stencil s[DIM], int p)
{
    size_t row = 0;
    for (int d = DIM - 1; d > 0; d--) row = row * (size_t)g->n[d] + (size_t)s[d].base[p];
    return row * (size_t)g->n[0] + (size_t)s[0].base[p];
}

/* Nodes from a stencil's first node to the start of its row r. */
static inline size_t row_offset(const Grid *g, int width, int r)
{
    if (DIM == 1) return 0;
    if (DIM == 2) return (size_t)r * (size_t)g->n[0];
    return ((size_t)(r / width) * (size_t)g->n[AXIS_Y] + (size_t)(r % width)) * (size_t)g->n[0];
}

/* Product of the weights of all axes but the first, for row r (DIM > 1). */
static inline __attribute__((always_inline)) Line
row_weight(const Stencil s[DIM], const Pattern *q, int p, int width, int r, const unsigned tables)
{
    Line y = axis_weight(s, DIM > 1, DIM == 2 ? r : r % width, p, q, tables);
    for (int d = 2; d < DIM; d++) y *= axis_weight(s, d, r / width, p, q, tables);
    return y;
}

/* Does a stencil of 3 nodes per axis fit in vector registers? */
#define FITS_REGISTERS(width)                                                                      \
    ((width) <= 3 && IN_THIS_DIM(3, 9, 27) * (int)sizeof(Line) <= REGISTERS * VECTOR_BYTES)

static inline __attribute__((always_inline)) void flush_run(Grid *g, Line sum[9], size_t at,
                                                            const int width)
{
    for (int r = 0; r < (DIM == 1 ? 1 : width); r++)
        for (int i = 0; i < width; i++) {
            g->node[at + row_offset(g, width, r) + (size_t)i] += sum[r * width + i];
            sum[r * width + i] = (Line){0};
        }
}

/* The slopes along axis d in the lanes of momentum. */
static inline __attribute__((always_inline)) Line slope_lanes(const Line *B, int d)
{
    Line s = {0};
    if (PARTS == 1)
        *(Part *)&s = slope_part(B, d, 0);
    else
        for (int a = 0; a < DIM; a++) s[1 + a] = (*B)[FOUR * d + 1 + a];
    return s;
}

/* node[lane] += w (A + sum_d B_d offset_d): A is the value at the stencil's first node. Particles
 * are sorted by stencil, so that many in a row share all nodes: where `runs` is set they are summed
 * in registers and the nodes are touched once a run. */
static inline __attribute__((always_inline)) void deposit(Grid *g, const Work *w, const int width,
                                                          const bool affine)
{
    const Pattern q = flux_pattern(T_G);
    const unsigned tables = 1u << T_G;
    const bool runs = FITS_REGISTERS(width);
    const int rows = DIM == 1 ? 1 : DIM == 2 ? width : width * width;
    Line sum[9] = {{0}};
    size_t at = first_node(g, w->stencil, 0);
    for (int p = 0; p < CHUNK; p++) {
        Line x[MAX_WIDTH];
        const size_t first = first_node(g, w->stencil, p);
        Line s[DIM];
        for (int d = 0; affine && d < DIM; d++) s[d] = slope_lanes(&w->B[p], d);
        for (int i = 0; i < width; i++) x[i] = axis_weight(w->stencil, 0, i, p, &q, tables);
        if (runs && first != at) {
            flush_run(g, sum, at, width);
            at = first;
        }
        for (int r = 0; r < rows; r++) {
            Line *node = g->node + first + row_offset(g, width, r);
            Line value = w->A[p], slope;
            for (int d = 1; affine && d < DIM; d++)
                value += (double)(d == 2 ? r / width : DIM == 2 ? r : r % width) * s[d];
            if (affine) slope = s[0];
            if (DIM > 1) {
                const Line y = row_weight(w->stencil, &q, p, width, r, tables);
                value *= y;
                if (affine) slope *= y;
            }
            for (int i = 0; i < width; i++) {
                *(runs ? &sum[(r * width + i) % 9] : &node[i]) += x[i] * value;
                if (affine) value += slope;
            }
        }
    }
    if (runs) flush_run(g, sum, at, width);
}

/* A_p[lane] = sum_i w node[lane], the lanes from FLUX on with the given table: T_G or T_R. */
static inline __attribute__((always_inline)) void gather(const Grid *g, Work *w, const int width,
                                                         const int table)
{
    const Pattern q = flux_pattern(table);
    const unsigned tables = 1u << table;
    for (int p = 0; p < CHUNK; p++) {
        Line x[MAX_WIDTH], sum = {0};
        const size_t first = first_node(g, w->stencil, p);
        x[0] = axis_weight(w->stencil, 0, 0, p, &q, tables);
        for (int i = 1; i < width; i++) x[i] = axis_weight(w->stencil, 0, i, p, &q, tables);
        FOR_ROWS(r, width)
        {
            const Line *node = g->node + first + row_offset(g, width, r);
            Line row = x[0] * node[0];
            for (int i = 1; i < width; i++) row += x[i] * node[i];
            if (DIM > 1) row *= row_weight(w->stencil, &q, p, width, r, tables);
            sum += row;
        }
        w->A[p] = sum;
    }
}

/* Product of S over all axes but the first. */
static inline double row_share(const Stencil s[DIM], int p, int width, int r)
{
    double y = 1;
    for (int d = 1; d < DIM; d++) y *= s[d].table[T_S][d == 1 ? r % width : r / width][p];
    return y;
}

/* Body force m b of the chunk to the nodes, weights S. */
static inline __attribute__((always_inline)) void deposit_force(Grid *g, const Work *w,
                                                                const int width)
{
    for (int p = 0; p < CHUNK; p++) {
        const size_t first = first_node(g, w->stencil, p);
        FOR_ROWS(r, width)
        {
            const double y = row_share(w->stencil, p, width, r);
            double *force = g->force + DIM * (first + row_offset(g, width, r));
            for (int i = 0; i < width; i++)
                for (int a = 0; a < DIM; a++)
                    force[i * DIM + a] += w->stencil[0].table[T_S][i][p] * y * w->body[a][p];
        }
    }
}

/* Payload from fields to lines. A is given at the particle; with slopes it is moved to the
 * stencil's first node, and the slopes are scaled to steps of one cell. */
static inline void pack_payload(const Sim *sim, Work *w, bool affine)
{
    Payload *q = &w->payload;
    for (int d = 0; affine && d < DIM; d++) {
        Field r;
        for (int p = 0; p < CHUNK; p++) r[p] = (w->stencil[d].base[p] - w->x[d][p]) * sim->dx;
        for (int a = 0; a < DIM; a++)
            for (int p = 0; p < CHUNK; p++) q->A[1 + a][p] += q->B[d][a][p] * r[p];
    }
    four_lines_from_fields(q->A, w->A);
    for (int d = 0; affine && d < DIM; d++) four_momentum_lanes(q->B[d], sim->dx, w->B, d);
}

/* Lines to fields, from lane `at` on; from FLUX on per cell to per metre, or cells to metres. */
static inline void unpack_sums(Work *w, int at, double scale)
{
    four_fields_from_lines(w->A, scale, w->sums + at);
}

#endif
