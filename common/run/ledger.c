/* ledger.c: see ledger.h. Sums run in slot order, which no number of threads changes. */
#include <math.h>
#include "ledger.h"

double ledger_kinetic(const Points *p)
{
    double sum = 0;
    for (int k = 0; k < p->n; k++) {
        double square = 0;
        for (int d = 0; d < DIM; d++) square += p->v[d][k] * p->v[d][k];
        sum += 0.5 * p->m[k] * square;
    }
    return sum;
}

double ledger_strain(const Scene *scene, const Samples *q, Scratch *s)
{
    double sum = 0;
    material_stored_energy(&scene->mat, q->n, q->F, s->w);
    for (int k = 0; k < q->n; k++) sum += q->V0[k] > 0 ? q->V0[k] * s->w[k] : 0;
    return sum;
}

double ledger_work(const Scene *scene, const Points *p, ConstFields from, double t, Scratch *s)
{
    double sum = 0;
    if (!scene->problem->body) return 0;
    scene->problem->body(scene, p->n, p->X, t, s->v);
    for (int d = 0; d < DIM; d++)
        for (int k = 0; k < p->n; k++)
            if (p->m[k] > 0) sum += p->m[k] * s->v[d][k] * (p->x[d][k] - from[d][p->id[k]]);
    return sum;
}

double ledger_momentum(const Points *p, Vec out)
{
    double sum = 0;
    for (int d = 0; d < DIM; d++) out[d] = 0;
    for (int k = 0; k < p->n; k++) {
        double square = 0;
        for (int d = 0; d < DIM; d++) {
            out[d] += p->m[k] * p->v[d][k];
            square += p->v[d][k] * p->v[d][k];
        }
        sum += p->m[k] * sqrt(square);
    }
    return sum;
}

/* sum m (r_a v_b - r_b v_a) about the centre of mass. */
static double spin_in_plane(const Points *p, int a, int b)
{
    double mass = 0, x[2] = {0}, mv[2] = {0}, sum = 0;
    for (int k = 0; k < p->n; k++) {
        const double r[] = {p->x[a][k], p->x[b][k]}, v[] = {p->v[a][k], p->v[b][k]};
        mass += p->m[k];
        sum += p->m[k] * (r[0] * v[1] - r[1] * v[0]);
        for (int c = 0; c < 2; c++) x[c] += p->m[k] * r[c], mv[c] += p->m[k] * v[c];
    }
    return sum - (x[0] * mv[1] - x[1] * mv[0]) / mass;
}

void ledger_angular_momentum(const Points *p, double out[3])
{
    for (int c = 0; c < 3; c++) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        out[c] = a < DIM && b < DIM ? spin_in_plane(p, a % DIM, b % DIM) : NAN;
    }
}

Volumes ledger_volumes(const Samples *q)
{
    Volumes out = {0, NAN, NAN};
    bool any = false;
    for (int k = 0; k < q->n; k++) {
        if (!(q->V0[k] > 0)) continue;
        Mat F;
        for (int e = 0; e < NMAT; e++) F[e] = q->F[e][k];
        const double J = determinant(F);
        out.sum += q->V0[k] * J;
        if (!any || !(J >= out.least)) out.least = J;
        if (!any || !(J <= out.most)) out.most = J;
        any = true;
    }
    return out;
}

int ledger_fastest_point(const Points *p, double *speed)
{
    int fastest = -1;
    *speed = 0;
    for (int k = 0; k < p->n; k++) {
        double square = 0;
        for (int d = 0; d < DIM; d++) square += p->v[d][k] * p->v[d][k];
        const double own = sqrt(square);
        if (!(p->m[k] > 0) || own < *speed) continue;
        if (own > *speed || fastest < 0 || p->id[k] < fastest) fastest = p->id[k];
        *speed = own;
    }
    return fastest;
}
