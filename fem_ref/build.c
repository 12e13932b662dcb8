/* build.c: from a scene to a mesh with masses (W11 A2), constraints and initial state. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "fem.h"
#include "mesh.h"

typedef struct Arena {
    char *base; /* NULL: only count */
    size_t used;
} Arena;

static void *slice(Arena *a, int count, size_t size)
{
    void *at = a->base ? a->base + a->used : NULL;
    a->used += ((size_t)count * size + 63) / 64 * 64; /* cache lines */
    return at;
}

static double *doubles(Arena *a, int count)
{
    return slice(a, count, sizeof(double));
}

/* Lays all arrays out in the block at `base`; with base NULL it only adds up their sizes. Returns
 * the bytes. */
static size_t lay_out(Fem *f, char *base)
{
    Arena a = {base, 0};
    for (int d = 0; d < DIM; d++) {
        f->X[d] = doubles(&a, f->nodes);
        f->x[d] = doubles(&a, f->nodes);
        f->v[d] = doubles(&a, f->nodes);
        f->keep[d] = doubles(&a, f->nodes);
        f->given[d] = doubles(&a, f->nodes);
    }
    f->now = slice(&a, f->nodes, sizeof(Packed));
    f->m = doubles(&a, f->nodes);
    f->V0 = doubles(&a, f->nodes);
    f->id = slice(&a, f->nodes, sizeof(int));
    f->touching = slice(&a, f->nodes, sizeof *f->touching);
    for (int c = 0; c < CORNERS; c++) f->corner[c] = slice(&a, f->slots, sizeof(int));
    for (int k = 0; k < NMAT; k++) f->F[k] = doubles(&a, f->slots);
    f->inverse = slice(&a, f->slots / CHUNK, sizeof *f->inverse);
    f->A0 = doubles(&a, f->slots);
    f->force = slice(&a, no_force(f) + 1, sizeof(Packed));
    for (int d = 0; d < DIM && f->integrate; d++) f->middle[d] = doubles(&a, f->slots);
    if (f->integrate) f->pull = slice(&a, f->slots + 1, sizeof(Packed));
    return a.used;
}

static int allocate(Fem *f, int cells, Fault *fault)
{
    const double have = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    const size_t need = lay_out(f, NULL);
    if ((double)need > have)
        return fault_set(
            fault, FAULT_MACHINE,
            "fem: %d cells make %d elements, which take %.3g GB of memory; there are %.3g", cells,
            f->elements, (double)need * 1e-9, have * 1e-9);
    f->memory = aligned_alloc(64, need);
    if (!f->memory)
        return fault_set(fault, FAULT_MACHINE, "fem: no memory for %d elements", f->elements);
    memset(f->memory, 0, need);
    f->bytes = need;
    lay_out(f, f->memory);
    return 0;
}

/* Volume and inverse of the reference edges of the element in a slot. Returns its least altitude,
 * DIM times the volume over the largest side: the columns of the cofactors, and their sum, are
 * vectors of (DIM - 1)! times the sides' areas. */
static double measure(Fem *f, int slot)
{
    Mat edge;
    double total[DIM] = {0}, largest = 0;
    for (int k = 0; k < NMAT; k++) {
        const int d = k / DIM, c = k % DIM + 1;
        edge[k] = f->X[d][f->corner[c][slot]] - f->X[d][f->corner[0][slot]];
    }
    const double det = determinant(edge);
    Field *B = f->inverse[slot / CHUNK];
    for (int k = 0; k < DIM; k++) {
        double square = 0;
        for (int a = 0; a < DIM; a++) {
            const double side = cofactor(edge, a, k);
            B[k * DIM + a][slot % CHUNK] = side / det;
            square += side * side;
            total[a] += side;
        }
        largest = fmax(largest, square);
    }
    double square = 0;
    for (int a = 0; a < DIM; a++) square += total[a] * total[a];
    f->A0[slot] = slot < f->elements ? det / (double)FACTORIAL : 0;
    for (int d = 0; d < DIM && f->integrate; d++) {
        f->middle[d][slot] = 0;
        for (int c = 0; c < CORNERS; c++)
            f->middle[d][slot] += f->X[d][f->corner[c][slot]] / (double)CORNERS;
    }
    return det / sqrt(fmax(largest, square));
}

/* All elements; padding repeats the last one. The length in the time step limit is the least
 * altitude, in 2D at most h; for boxes and rings in 2D it is h, as in the published runs. */
static void measure_all(Fem *f)
{
    const BodyKind kind = f->scene->body.kind;
    const bool published = DIM == 2 && (kind == BODY_BOX || kind == BODY_RING);
    double least = INFINITY;
    for (int slot = 0; slot < f->slots; slot++) {
        const int e = slot < f->elements ? slot : f->elements - 1;
        for (int k = 0; k < CORNERS; k++) f->corner[k][slot] = f->corner[k][e];
        least = fmin(least, measure(f, slot));
    }
    if (DIM > 2 || (!published && least < f->edge)) f->edge = least;
}

/* Lumped masses (W11 A2), and for each node the element corners that meet in it, in the order of
 * elements. */
static void connect(Fem *f)
{
    for (int i = 0; i < f->nodes; i++) {
        f->id[i] = i;
        for (int k = 0; k < VALENCE; k++) f->touching[i][k] = no_force(f);
    }
    for (int e = 0; e < f->elements; e++)
        for (int c = 0; c < CORNERS; c++) {
            int i = f->corner[c][e], k = 0;
            while (f->touching[i][k] != no_force(f)) k++;
            f->touching[i][k] = force_at(e, c);
            f->V0[i] += f->A0[e] / (double)CORNERS;
        }
    for (int i = 0; i < f->nodes; i++) f->m[i] = f->scene->mat.rho * f->V0[i];
}

/* Nodes whose reference position lies on wall w: the components that it holds are fixed for good,
 * and the nodes are put on it exactly. */
static void bind_to_wall(Fem *f, const Wall *w)
{
    const Scene *s = f->scene;
    const double near = 1e-9 * (s->body_hi[w->axis] - s->body_lo[w->axis]);
    const unsigned hold = w->mirror ? 1u << w->axis : w->hold;
    if (!w->unilateral)
        for (int i = 0; i < f->nodes; i++) {
            if (fabs(f->X[w->axis][i] - w->at) > near) continue;
            f->X[w->axis][i] = w->at;
            for (int d = 0; d < DIM; d++)
                if (hold >> d & 1) f->keep[d][i] = 0;
        }
    if (hold >> w->axis & 1) {
        f->barrier[f->barriers] = *w;
        f->barrier[f->barriers++].hold = hold;
    }
}

static void start_block(Fem *f, int lo, int n)
{
    const Scene *s = f->scene;
    Field u[DIM] = {{0}}, unused[2][NMAT] = {{{0}}};
    const double *X[DIM];
    double *pu[DIM], *pv[DIM], *pF[NMAT], *pL[NMAT];
    for (int d = 0; d < DIM; d++) X[d] = f->X[d] + lo, pu[d] = u[d], pv[d] = f->v[d] + lo;
    for (int k = 0; k < NMAT; k++) {
        pF[k] = unused[0][k];
        pL[k] = unused[1][k];
        for (int i = 0; i < n; i++) pF[k][i] = k % (DIM + 1) == 0;
    }
    if (s->problem->start) s->problem->start(s, n, X, pu, pv, pF, pL);
    for (int d = 0; d < DIM; d++)
        for (int i = 0; i < n; i++) f->now[lo + i][d] = f->x[d][lo + i] = X[d][i] + u[d][i];
}

/* Threads to use: at most `asked`, with at least 32 chunks (some 20 us of work) for each, since
 * waking a thread costs more than less work would take. */
static int threads_for(int asked, int slots)
{
    const int worth = slots / (32 * CHUNK);
    const int threads = asked < worth ? asked : worth;
    return threads > 1 ? threads : 1;
}

Fem *fem_new(const Setup *setup, Fault *fault)
{
    Mesh mesh;
    if (mesh_plan(&mesh, setup->scene, setup->cells, fault)) return NULL;
    Fem *f = calloc(1, sizeof *f);
    if (!f) {
        fault_set(fault, FAULT_MACHINE, "fem: no memory");
        return NULL;
    }
    f->scene = setup->scene;
    f->integrate = setup->method_par && setup->method_par[0] > 0 && setup->scene->problem->body;
    f->reactions = setup->reactions;
    f->nodes = mesh.nodes;
    f->elements = mesh.elements;
    f->slots = (mesh.elements + CHUNK - 1) / CHUNK * CHUNK;
    f->threads = threads_for(setup->threads, f->slots);
    f->edge = 1.0 / setup->cells;
    if (allocate(f, setup->cells, fault)) {
        free(f);
        return NULL;
    }
    mesh_fill(&mesh, f->X, f->corner);
    for (int d = 0; d < DIM; d++)
        for (int i = 0; i < f->nodes; i++) f->keep[d][i] = 1;
    for (int w = 0; w < f->scene->nwall; w++) bind_to_wall(f, &f->scene->wall[w]);
    measure_all(f);
    connect(f);
    for (int lo = 0; lo < f->nodes; lo += CHUNK)
        start_block(f, lo, f->nodes - lo < CHUNK ? f->nodes - lo : CHUNK);
    fem_strain(f);
    if (fem_find_sides(f)) return f;
    fault_set(fault, FAULT_MACHINE, "fem: no memory");
    fem_free(f);
    return NULL;
}

void fem_free(Fem *f)
{
    if (f) fem_free_sides(f), free(f->memory);
    free(f);
}
