/* traction.c: tractions on the boundary of the mesh (W11 eq 3): every side that belongs to one
 * element gives each of its nodes a share 1/DIM of its reference area times the nominal traction
 * P N there. */
#include <math.h>
#include <stdlib.h>
#include "fem.h"

typedef struct Side {
    int node[DIM]; /* sorted: equal in both elements that share a side */
    int element, opposite;
} Side;

typedef struct Sides {
    int n;             /* places: DIM to a side */
    int *node;         /* of each place */
    double *area;      /* [m^(DIM-1)] its share */
    double *X[DIM];    /* [m] */
    double *N[DIM];    /* [-] outward normal in the reference */
    double *P[DIM];    /* [Pa] traction */
    double *load[DIM]; /* [N] [nodes] */
    double work;
    double *memory;
} Sides;

static int by_nodes(const void *a, const void *b)
{
    const Side *s = a, *t = b;
    for (int k = 0; k < DIM; k++)
        if (s->node[k] != t->node[k]) return s->node[k] < t->node[k] ? -1 : 1;
    return (s->element > t->element) - (s->element < t->element);
}

static void sort_nodes(int node[DIM])
{
    for (int pass = 0; pass + 1 < DIM; pass++)
        for (int k = 0; k + 1 < DIM; k++)
            if (node[k] > node[k + 1]) {
                const int swap = node[k];
                node[k] = node[k + 1];
                node[k + 1] = swap;
            }
}

static bool are_twins(const Side *a, const Side *b)
{
    for (int k = 0; k < DIM; k++)
        if (a->node[k] != b->node[k]) return false;
    return true;
}

/* Lists the sides of all elements, those that belong to one element only first. Returns how many
 * these are. */
static int find_single(const Fem *f, Side *side)
{
    int n = 0, single = 0;
    for (int e = 0; e < f->elements; e++)
        for (int o = 0; o < CORNERS; o++, n++) {
            side[n] = (Side){.element = e, .opposite = o};
            for (int k = 0; k < DIM; k++) side[n].node[k] = f->corner[k + (k >= o)][e];
            sort_nodes(side[n].node);
        }
    qsort(side, (size_t)n, sizeof *side, by_nodes);
    for (int k = 0; k < n; k++) {
        if (k + 1 < n && are_twins(&side[k], &side[k + 1]))
            k++;
        else
            side[single++] = side[k];
    }
    return single;
}

/* The outward normal of a side times (DIM - 1)! its area: a row of cofactors of its edges and one
 * towards the opposite corner. */
static void area_vector(const Fem *f, const Side *s, double out[DIM])
{
    Mat edge;
    double towards = 0;
    const int far = f->corner[s->opposite][s->element];
    for (int d = 0; d < DIM; d++) {
        for (int k = 1; k < DIM; k++)
            edge[(k - 1) * DIM + d] = f->X[d][s->node[k]] - f->X[d][s->node[0]];
        edge[(DIM - 1) * DIM + d] = f->X[d][far] - f->X[d][s->node[0]];
    }
    for (int d = 0; d < DIM; d++) {
        out[d] = cofactor(edge, DIM - 1, d);
        towards += out[d] * edge[(DIM - 1) * DIM + d];
    }
    for (int d = 0; d < DIM; d++) out[d] *= towards > 0 ? -1 : 1;
}

static bool allocate(Sides *e, int n, int nodes)
{
    const size_t places = (size_t)n;
    double *at = e->memory = calloc((3 * DIM + 1) * places + DIM * (size_t)nodes, sizeof(double));
    e->node = calloc(places + 1, sizeof *e->node);
    e->n = n;
    e->area = at;
    for (int d = 0; at && d < DIM; d++) {
        e->X[d] = at + (size_t)(1 + d) * places;
        e->N[d] = at + (size_t)(1 + DIM + d) * places;
        e->P[d] = at + (size_t)(1 + 2 * DIM + d) * places;
        e->load[d] = at + (size_t)(1 + 3 * DIM) * places + (size_t)d * (size_t)nodes;
    }
    return e->memory && e->node;
}

static void fill(const Fem *f, Sides *e, const Side *side)
{
    for (int at = 0; at < e->n; at++) {
        const Side *s = &side[at / DIM];
        double vector[DIM], square = 0;
        area_vector(f, s, vector);
        for (int d = 0; d < DIM; d++) square += vector[d] * vector[d];
        e->node[at] = s->node[at % DIM];
        e->area[at] = sqrt(square) / (double)FACTORIAL; /* (DIM - 1)! and DIM shares */
        for (int d = 0; d < DIM; d++) {
            e->X[d][at] = f->X[d][e->node[at]];
            e->N[d][at] = vector[d] / sqrt(square);
        }
    }
}

bool fem_find_sides(Fem *f)
{
    if (!f->scene->traction) return true;
    Side *side = malloc(sizeof *side * CORNERS * (size_t)f->elements);
    f->sides = calloc(1, sizeof *f->sides);
    bool ok = side && f->sides;
    const int single = ok ? find_single(f, side) : 0;
    ok = ok && allocate(f->sides, DIM * single, f->nodes);
    if (ok) fill(f, f->sides, side);
    free(side);
    return ok;
}

void fem_free_sides(Fem *f)
{
    if (!f->sides) return;
    free(f->sides->memory), free(f->sides->node);
    free(f->sides);
}

void fem_load_sides(Fem *f, double t)
{
    Sides *e = f->sides;
    f->scene->problem->traction(f->scene, e->n, (const double *const *)e->X,
                                (const double *const *)e->N, t, e->P);
    for (int d = 0; d < DIM; d++) {
        for (int i = 0; i < f->nodes; i++) e->load[d][i] = 0;
        for (int at = 0; at < e->n; at++) e->load[d][e->node[at]] += e->area[at] * e->P[d][at];
    }
}

const double *fem_load(const Fem *f, int axis)
{
    return f->sides->load[axis];
}

/* sum of load times way; a node moved by dt v. */
static double work_of_step(const Fem *f, double dt)
{
    double sum = 0;
    for (int d = 0; d < DIM; d++)
        for (int i = 0; i < f->nodes; i++) sum += f->sides->load[d][i] * dt * f->v[d][i];
    return sum;
}

void fem_record_work(Fem *f, double t, double dt)
{
    const double before = work_of_step(f, dt);
    fem_load_sides(f, t + dt);
    f->sides->work += 0.5 * (before + work_of_step(f, dt));
}

void fem_stash_work(Fem *f, Stash *s)
{
    STASH(s, f->sides->work);
}

double fem_work(const Fem *f)
{
    return f->sides ? f->sides->work : 0;
}
