/* norm.c: see norm.h. Sums run in slot order, which no number of threads changes. */
#include <math.h>
#include <stdlib.h>
#include "norm.h"
#include "common/base/team.h"

bool norm_scratch_fit(Scratch *s, int n)
{
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

/* Norms of e[] with weights w[]; a NaN error makes every norm NaN, and so does the lack of any. */
static Errors norms(int n, const double e[], const double w[])
{
    double most = 0, square = 0, sum = 0, weight = 0;
    for (int k = 0; k < n; k++) {
        if (!(w[k] > 0)) continue;
        most = isnan(most) || e[k] <= most ? most : e[k];
        square += w[k] * e[k] * e[k];
        sum += w[k] * e[k];
        weight += w[k];
    }
    if (!(weight > 0)) return norm_no_errors;
    return (Errors){most, sqrt(square / weight), sum / weight};
}

/* Of the slots from `at` on, at most n: e over the scale, into s->w. */
static void displacement_errors(const Scene *scene, const Points *p, double t, int at, int n,
                                Scratch *s)
{
    const double *X[DIM];
    double *u[DIM];
    for (int d = 0; d < DIM; d++) X[d] = p->X[d] + at, u[d] = s->v[d] + at;
    if (n > p->n - at) n = p->n - at;
    scene->problem->exact(scene, n, X, t, u);
    for (int k = 0; k < n; k++) {
        double square = 0;
        for (int d = 0; d < DIM; d++) {
            const double e = p->x[d][at + k] - X[d][k] - u[d][k];
            square += e * e;
        }
        s->w[at + k] = sqrt(square) / scene->error_scale;
    }
}

typedef struct Displacements {
    const Scene *scene;
    const Points *p;
    double t;
    Scratch *s;
} Displacements;

enum { BLOCK = 16 * CHUNK };

static void blocks_of_errors(void *own, int first, int last)
{
    const Displacements *d = own;
    for (int b = first; b < last; b++)
        displacement_errors(d->scene, d->p, d->t, b * BLOCK, BLOCK, d->s);
}

Errors norm_displacement(const Scene *scene, const Points *p, double t, int threads, Scratch *s)
{
    team_share(threads, (p->n + BLOCK - 1) / BLOCK, blocks_of_errors,
               &(Displacements){scene, p, t, s});
    return norms(p->n, s->w, p->V0);
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
    return norms(n->n, s->w, weight);
}
