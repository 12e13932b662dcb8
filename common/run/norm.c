/* norm.c: see norm.h. Sums run over blocks of slots in order, whatever the number of threads. */
#include <math.h>
#include <stdlib.h>
#include "norm.h"
#include "common/base/team.h"

bool norm_scratch_fit(Scratch *s, int n)
{
    n += CHUNK; /* room for sums, however few the points are */
    if (n <= s->room) return true;
    norm_scratch_free(s);
    bool ok = (s->w = malloc(sizeof(double) * (size_t)n)) != NULL;
    for (int d = 0; d < DIM; d++) ok = (s->v[d] = malloc(sizeof(double) * (size_t)n)) && ok;
    s->room = ok ? n : 0;
    return ok;
}

void norm_scratch_free(Scratch *s)
{
    free(s->w);
    for (int d = 0; d < DIM; d++) free(s->v[d]);
    *s = (Scratch){0};
}

const Errors norm_no_errors = {NAN, NAN, NAN};

/* The larger number, or NaN if one of them is. */
static double worse(double a, double b)
{
    return isnan(a) || b <= a ? a : b;
}

/* Of some points: max e, sum w e^2, sum w e, sum w. */
typedef struct Sums {
    double most, square, sum, weight;
} Sums;

static Sums sums_add(Sums a, Sums b)
{
    return (Sums){worse(a.most, b.most), a.square + b.square, a.sum + b.sum, a.weight + b.weight};
}

/* Sums over errors e[] with weights w[]; points without weight are left out. There are LANE partial
 * sums, so that the loop is vectorized. */
static Sums sums_of(int n, const double e[], const double w[])
{
    enum { LANE = 16 };
    Sums all = {0};
    double most[LANE] = {0}, square[LANE] = {0}, sum[LANE] = {0}, weight[LANE] = {0};
    const int whole = n - n % LANE;
    for (int at = 0; at < whole; at += LANE)
        for (int k = 0; k < LANE; k++) {
            const bool counts = w[at + k] > 0;
            const double own = counts ? w[at + k] : 0, error = counts ? e[at + k] : 0;
            most[k] = worse(most[k], error);
            square[k] += own * error * error;
            sum[k] += own * error;
            weight[k] += own;
        }
    for (int k = 0; k < LANE; k++)
        all = sums_add(all, (Sums){most[k], square[k], sum[k], weight[k]});
    for (int k = whole; k < n; k++)
        if (w[k] > 0) all = sums_add(all, (Sums){e[k], w[k] * e[k] * e[k], w[k] * e[k], w[k]});
    return all;
}

/* All norms are NaN if one error is NaN, or if no point has weight. */
static Errors norms(Sums s)
{
    if (!(s.weight > 0)) return norm_no_errors;
    return (Errors){s.most, sqrt(s.square / s.weight), s.sum / s.weight};
}

/* Of the slots from `at` on, at most n: e over the scale, into s->w; their sums. */
static Sums displacement_errors(const Scene *scene, const Points *p, double t, int at, int n,
                                Scratch *s)
{
    const double *X[DIM];
    double *u[DIM];
    for (int d = 0; d < DIM; d++) X[d] = p->X[d] + at, u[d] = s->v[d] + at;
    const double scale = scene->error_scale;
    if (n > p->n - at) n = p->n - at;
    scene->problem->exact(scene, n, X, t, u);
    for (int k = 0; k < n; k++) {
        double square = 0;
        for (int d = 0; d < DIM; d++) {
            const double e = p->x[d][at + k] - X[d][k] - u[d][k];
            square += e * e;
        }
        s->w[at + k] = sqrt(square) / scale;
    }
    return sums_of(n, s->w + at, p->V0 + at);
}

typedef struct Displacements {
    const Scene *scene;
    const Points *p;
    double t;
    Scratch *s;
} Displacements;

enum { BLOCK = 16 * CHUNK };

/* Sums of block b, stored in place of its displacements, which are no longer needed. */
static Sums *block_sums(const Scratch *s, int b)
{
    return (void *)(s->v[0] + (size_t)b * BLOCK);
}

static void blocks_of_errors(void *own, int first, int last)
{
    const Displacements *d = own;
    for (int b = first; b < last; b++)
        *block_sums(d->s, b) = displacement_errors(d->scene, d->p, d->t, b * BLOCK, BLOCK, d->s);
}

Errors norm_displacement(const Scene *scene, const Points *p, double t, int threads, Scratch *s)
{
    const int blocks = (p->n + BLOCK - 1) / BLOCK;
    Sums all = {0};
    team_share(threads, blocks, blocks_of_errors, &(Displacements){scene, p, t, s});
    for (int b = 0; b < blocks; b++) all = sums_add(all, *block_sums(s, b));
    return norms(all);
}

Errors norm_projection(const Scene *scene, const Nodes *n, Scratch *s)
{
    double *weight = s->v[0];
    scene->problem->exact(scene, n->n, n->x, 0, s->v);
    for (int k = 0; k < n->n; k++) {
        double error = 0, size = 0;
        bool inside = n->m[k] > 0;
        for (int d = 0; d < DIM; d++) {
            const double e = n->v[d][k] - s->v[d][k];
            error += e * e;
            size += s->v[d][k] * s->v[d][k];
            inside = inside && n->x[d][k] > scene->body_lo[d] && n->x[d][k] < scene->body_hi[d];
        }
        s->w[k] = sqrt(error / size);
        weight[k] = inside;
    }
    return norms(sums_of(n->n, s->w, weight));
}
