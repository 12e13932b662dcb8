/* ledger.c: see ledger.h. Sums run over the 64 lanes of chunks, then over lanes and blocks of
 * chunks in order: no number of threads changes them. */
#include <math.h>
#include <string.h>
#include "ledger.h"
#include "common/base/team.h"

/* Sums of one lane each. */
typedef struct Lanes {
    Field kinetic, speeds, p[DIM], strain;
} Lanes;

enum { BLOCK = 32 * CHUNK, SUMS = 3 + DIM };

static int least_int(int a, int b)
{
    return a < b ? a : b;
}

static void add_motion(Lanes *restrict s, const double *m, const double *const v[DIM])
{
    for (int p = 0; p < CHUNK; p++) {
        double square = 0;
        for (int d = 0; d < DIM; d++) square += v[d][p] * v[d][p];
        s->kinetic[p] += 0.5 * m[p] * square;
        s->speeds[p] += m[p] * sqrt(square);
        for (int d = 0; d < DIM; d++) s->p[d][p] += m[p] * v[d][p];
    }
}

/* The slots from `at` on, at most a chunk; what is missing has no mass. */
static void add_points(Lanes *s, const Points *q, int at)
{
    const int n = least_int(q->n - at, CHUNK);
    const double *v[DIM];
    Field rest[1 + DIM];
    for (int d = 0; d < DIM; d++) v[d] = q->v[d] + at;
    if (n == CHUNK) {
        add_motion(s, q->m + at, v);
        return;
    }
    memset(rest, 0, sizeof rest);
    memcpy(rest[0], q->m + at, sizeof(double) * (size_t)n);
    for (int d = 0; d < DIM; d++) memcpy(rest[1 + d], v[d], sizeof(double) * (size_t)n);
    for (int d = 0; d < DIM; d++) v[d] = rest[1 + d];
    add_motion(s, rest[0], v);
}

/* Of points that are broken. */
static void forget_tension(const Material *mat, const double *const F[NMAT],
                           const double strength[], int n, Field psi)
{
    for (int p = 0; p < n; p++) {
        Mat f, T;
        if (strength[p] > 0) continue;
        for (int k = 0; k < NMAT; k++) f[k] = F[k][p];
        psi[p] = material_without_tension(mat, f, T);
    }
}

static void add_strain(Lanes *s, const Material *mat, const Samples *q, int at)
{
    const int n = least_int(q->n - at, CHUNK);
    const double *F[NMAT];
    Field psi;
    for (int k = 0; k < NMAT; k++) F[k] = q->F[k] + at;
    material_stored_energy(mat, n, F, psi);
    if (q->strength) forget_tension(mat, F, q->strength + at, n, psi);
    for (int p = 0; p < n; p++) s->strain[p] += q->V0[at + p] > 0 ? q->V0[at + p] * psi[p] : 0;
}

static double sum_of(const Field lanes)
{
    double sum = 0;
    for (int p = 0; p < CHUNK; p++) sum += lanes[p];
    return sum;
}

typedef struct Motions {
    const Points *q;
    double (*part)[SUMS]; /* [blocks] */
} Motions;

static void sum_motions(void *own, int first, int last)
{
    const Motions *m = own;
    for (int b = first; b < last; b++) {
        Lanes s;
        memset(&s, 0, sizeof s);
        for (int at = b * BLOCK; at < least_int(m->q->n, (b + 1) * BLOCK); at += CHUNK)
            add_points(&s, m->q, at);
        m->part[b][0] = sum_of(s.kinetic);
        m->part[b][1] = sum_of(s.speeds);
        for (int d = 0; d < DIM; d++) m->part[b][2 + d] = sum_of(s.p[d]);
    }
}

Side ledger_motion(const Points *q, int threads, Scratch *scratch)
{
    const int blocks = (q->n + BLOCK - 1) / BLOCK;
    double(*part)[SUMS] = (double(*)[SUMS])(void *)scratch->w;
    Side out = {0};
    team_share(threads, blocks, sum_motions, &(Motions){q, part});
    for (int b = 0; b < blocks; b++) {
        out.kinetic += part[b][0];
        out.mv += part[b][1];
        for (int d = 0; d < DIM; d++) out.p[d] += part[b][2 + d];
    }
    return out;
}

typedef struct Strains {
    const Samples *q;
    const Material *mat;
    double *part; /* [blocks] */
} Strains;

static void sum_strains(void *own, int first, int last)
{
    const Strains *e = own;
    for (int b = first; b < last; b++) {
        Lanes s;
        memset(s.strain, 0, sizeof s.strain);
        for (int at = b * BLOCK; at < least_int(e->q->n, (b + 1) * BLOCK); at += CHUNK)
            add_strain(&s, e->mat, e->q, at);
        e->part[b] = sum_of(s.strain);
    }
}

double ledger_strain(const Scene *scene, const Samples *q, int threads, Scratch *scratch)
{
    const int blocks = (q->n + BLOCK - 1) / BLOCK;
    double *part = scratch->w, sum = 0;
    team_share(threads, blocks, sum_strains, &(Strains){q, &scene->mat, part});
    for (int b = 0; b < blocks; b++) sum += part[b];
    return sum;
}

typedef struct Works {
    const Scene *scene;
    const Points *p;
    double t;
    BodyLoad *before;
    double *part; /* [blocks] */
} Works;

static double work_of_slots(const Works *w, int at, int n)
{
    const Points *p = w->p;
    const double *X[DIM];
    Field b[DIM];
    double *to[DIM], sum = 0;
    for (int d = 0; d < DIM; d++) X[d] = p->X[d] + at, to[d] = b[d];
    w->scene->problem->body(w->scene, n, X, w->t, to);
    for (int k = 0; k < n; k++) {
        if (p->id[at + k] < 0) continue;
        BodyLoad *was = &w->before[p->id[at + k]];
        double work = 0;
        for (int d = 0; d < DIM; d++) {
            const double x = p->x[d][at + k];
            work += 0.5 * (b[d][k] + was->b[d]) * (x - was->x[d]);
            was->x[d] = x, was->b[d] = b[d][k];
        }
        sum += p->m[at + k] * work;
    }
    return sum;
}

static void sum_works(void *own, int first, int last)
{
    const Works *w = own;
    for (int b = first; b < last; b++) {
        const int end = least_int(w->p->n, (b + 1) * BLOCK);
        w->part[b] = 0;
        for (int at = b * BLOCK; at < end; at += CHUNK)
            w->part[b] += work_of_slots(w, at, least_int(end - at, CHUNK));
    }
}

double ledger_work(const Scene *scene, const Points *p, double t, BodyLoad before[], int threads,
                   Scratch *s)
{
    const int blocks = (p->n + BLOCK - 1) / BLOCK;
    double sum = 0;
    if (!scene->problem->body) return 0;
    team_share(threads, blocks, sum_works, &(Works){scene, p, t, before, s->w});
    for (int b = 0; b < blocks; b++) sum += s->w[b];
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
