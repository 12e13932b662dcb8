/* twin.c: see twin.h. Equations: W07 2.1, 4.2; W11 26-30, A2; PHYSICS 1, 2. */
#include <math.h>
#include <string.h>
#include "twin.h"

enum { REACH = 16 }; /* most nodes that a particle may see along one axis */

/* The nodes that a particle sees along one axis. */
typedef struct Sight {
    int first, count;
    double S[REACH], G[REACH]; /* [-] [1/m] */
} Sight;

/* What a gather is for. */
typedef struct Take {
    bool v, x, later, L, F; /* later: keep the displacement for after a re-projection */
} Take;

/* The part of [-b, b] in which 1 + side (r + s) is the tent of a node at distance r: s from lo to
 * hi. */
static inline void clip(double r, double b, int side, double *lo, double *hi)
{
    const double from = side > 0 ? -1 - r : -r, to = side > 0 ? -r : 1 - r;
    *lo = from > -b ? from : -b;
    *hi = to < b ? to : b;
}

/* Mean over [-b, b] of the tent and of its slope: each flank is a trapezium, midpoint times base.
 */
static void gimp_weight(double r, double b, double *S, double *G)
{
    *S = *G = 0;
    for (int side = -1; side <= 1; side += 2) {
        double lo, hi;
        clip(r, b, side, &lo, &hi);
        if (!(hi > lo)) continue;
        *S += (hi - lo) / (2 * b) * (1 + side * (r + 0.5 * (lo + hi)));
        *G += side * (hi - lo) / (2 * b);
    }
}

/* x in cells from node 0, b = l/h. A tent's cell is floor(x). */
static void look(const Twin *w, double x, double b, Sight *s)
{
    const double cells = w->setup->cells;
    if (!w->method->gimp) {
        s->first = (int)floor(x);
        s->count = 2;
        s->S[0] = 1 - (x - s->first), s->S[1] = x - s->first;
        s->G[0] = -cells, s->G[1] = cells;
        return;
    }
    s->first = (int)floor(x - 1 - b) + 1;
    s->count = (int)ceil(x + 1 + b) - s->first;
    for (int k = 0; k < s->count && k < REACH; k++) {
        gimp_weight(x - (s->first + k), b, &s->S[k], &s->G[k]);
        s->G[k] *= cells;
    }
}

/* l = l0 |F_dd|, never quite zero. Axes that the dimension lacks have one node of weight 1. */
static void look_around(const Twin *w, const TwinParticle *p, Sight s[3])
{
    for (int d = 0; d < DIM; d++)
        look(w, p->x[d] * w->setup->cells, w->half * fmax(fabs(p->F[d][d]), 1e-6), &s[d]);
    for (int d = DIM; d < 3; d++) s[d] = (Sight){.count = 1, .S = {1}};
}

/* Node i of what a particle sees: its weight, gradient, position; NULL beyond the grid. */
static inline TwinNode *node_of(const Twin *w, const Sight s[3], const int i[3], double *S,
                                double G[DIM], double x[DIM])
{
    long at = 0;
    *S = s[0].S[i[0]] * s[1].S[i[1]] * s[2].S[i[2]];
    for (int d = DIM - 1; d >= 0; d--) {
        const int node = s[d].first + i[d], index = node - w->origin[d];
        const int e = (d + 1) % 3, f = (d + 2) % 3;
        if (index < 0 || index >= w->size[d]) return NULL;
        at = at * w->size[d] + index;
        x[d] = w->h * node;
        G[d] = s[d].G[i[d]] * s[e].S[i[e]] * s[f].S[i[f]];
    }
    return &w->node[at];
}

/* The loops over the nodes that a particle sees, i[0] fastest. */
#define FOR_NODES(s, i)                                                                            \
    for (int i[3] = {0}; i[2] < (s)[2].count; i[2]++)                                              \
        for (i[1] = 0; i[1] < (s)[1].count; i[1]++)                                                \
            for (i[0] = 0; i[0] < (s)[0].count; i[0]++)

static double det(const double F[DIM][DIM])
{
    const int u = 1 % DIM, z = 2 % DIM;
    if (DIM == 1) return F[0][0];
    if (DIM == 2) return F[0][0] * F[u][u] - F[0][u] * F[u][0];
    return F[0][0] * (F[u][u] * F[z][z] - F[u][z] * F[z][u]) -
           F[0][u] * (F[u][0] * F[z][z] - F[u][z] * F[z][0]) +
           F[0][z] * (F[u][0] * F[z][u] - F[u][u] * F[z][0]);
}

/* Cauchy stress [Pa]: W11 eq 32, or P F^T/J with P linear in F. */
static void cauchy(const Material *m, const double F[DIM][DIM], double sigma[DIM][DIM])
{
    const double J = det(F);
    double trace = 0;
    for (int a = 0; a < DIM; a++) trace += F[a][a] - 1;
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) {
            double left = 0, linear = 0;
            for (int k = 0; k < DIM; k++) {
                const double P =
                    m->mu * (F[a][k] + F[k][a]) - (a == k ? 2 * m->mu - m->lambda * trace : 0);
                left += F[a][k] * F[b][k];
                linear += P * F[b][k];
            }
            const double I = a == b;
            sigma[a][b] =
                m->law == LINEAR ? linear / J : m->lambda * log(J) / J * I + m->mu / J * (left - I);
        }
}

static void deposit(Twin *w, const TwinParticle *p, bool force)
{
    Sight s[3];
    double sigma[DIM][DIM] = {{0}}, S, G[DIM], x[DIM];
    look_around(w, p, s);
    const double V = p->V0 * det(p->F);
    if (force) cauchy(&w->setup->scene->mat, p->F, sigma);
    FOR_NODES(s, i)
    {
        TwinNode *node = node_of(w, s, i, &S, G, x);
        if (!node) continue;
        node->m += S * p->m;
        for (int a = 0; a < DIM; a++) {
            double v = p->v[a];
            for (int b = 0; b < DIM && w->method->gradient; b++) v += p->L[a][b] * (x[b] - p->x[b]);
            node->p[a] += S * p->m * v;
            for (int b = 0; b < DIM && force; b++) node->f[a] -= V * sigma[a][b] * G[b];
            if (force) node->f[a] += S * p->m * p->b[a];
        }
    }
}

/* The particle behind one symmetry line. */
static TwinParticle image(const TwinParticle *p, const Wall *wall)
{
    TwinParticle q = *p;
    const int n = wall->axis;
    q.x[n] = 2 * wall->at - p->x[n];
    q.v[n] = -p->v[n];
    q.b[n] = -p->b[n];
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++)
            if ((a == n) != (b == n)) q.F[a][b] = -p->F[a][b], q.L[a][b] = -p->L[a][b];
    return q;
}

/* The particle and its images in all symmetry lines, and their images, from wall k on. */
static void deposit_images(Twin *w, const TwinParticle *p, bool force, int k)
{
    const Scene *scene = w->setup->scene;
    while (k < scene->nwall && !scene->wall[k].mirror) k++;
    if (k == scene->nwall) {
        deposit(w, p, force);
        return;
    }
    const TwinParticle q = image(p, &scene->wall[k]);
    deposit_images(w, p, force, k + 1);
    deposit_images(w, &q, force, k + 1);
}

static void project(Twin *w, double t, bool force)
{
    const Problem *problem = w->setup->scene->problem;
    for (long i = 0; i < w->nodes; i++) w->node[i] = (TwinNode){.held = w->node[i].held};
    for (int k = 0; k < w->n; k++) {
        TwinParticle *p = &w->p[k];
        const double *X[DIM];
        double *b[DIM];
        for (int d = 0; d < DIM; d++) X[d] = &p->X[d], b[d] = &p->b[d];
        if (force && problem->body) problem->body(w->setup->scene, 1, X, t, b);
        deposit_images(w, p, force, 0);
    }
}

/* v = p/m, a = scale f/m, walls, v += a dt. */
static void solve(Twin *w, double dt, double scale)
{
    for (long i = 0; i < w->nodes; i++) {
        TwinNode *node = &w->node[i];
        if (node->m <= w->method->least * w->p[0].m) continue;
        for (int a = 0; a < DIM; a++) {
            if (node->held >> a & 1) continue;
            node->a[a] = scale * node->f[a] / node->m;
            node->v[a] = node->p[a] / node->m + node->a[a] * dt;
        }
    }
}

/* F += dt L F */
static void deform(TwinParticle *p, double dt, double L[DIM][DIM])
{
    double old[DIM][DIM];
    memcpy(old, p->F, sizeof old);
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++)
            for (int k = 0; k < DIM; k++) p->F[a][b] += dt * L[a][k] * old[k][b];
}

static void gather_one(const Twin *w, TwinParticle *p, double dt, Take take)
{
    Sight s[3];
    double S, G[DIM], x[DIM], v[DIM] = {0}, a[DIM] = {0}, L[DIM][DIM] = {{0}};
    look_around(w, p, s);
    FOR_NODES(s, i)
    {
        const TwinNode *node = node_of(w, s, i, &S, G, x);
        for (int d = 0; d < DIM && node; d++) {
            v[d] += S * node->v[d];
            a[d] += S * node->a[d];
            for (int b = 0; b < DIM; b++) L[d][b] += node->v[d] * G[b];
        }
    }
    for (int d = 0; d < DIM; d++) {
        if (take.v) p->v[d] += dt * a[d];
        if (take.x) p->x[d] += dt * v[d];
        if (take.later) p->u[d] = dt * v[d];
    }
    if (take.L || take.F) memcpy(p->L, L, sizeof L);
    if (take.F) deform(p, dt, L);
}

static void gather(Twin *w, double dt, Take take)
{
    for (int k = 0; k < w->n; k++) gather_one(w, &w->p[k], dt, take);
}

void twin_step(Twin *w, double t, double dt, bool first)
{
    const Integrator I = w->setup->integrator;
    const bool fresh = w->setup->refresh;
    const double scale = first && (I == CD || I == UVF || I == MUSL) ? 0.5 : 1;
    if (I == USF) {
        project(w, t, false);
        solve(w, dt, 1);
        gather(w, dt, (Take){.F = true});
    }
    project(w, t, true);
    solve(w, dt, scale);
    if (I == CD || I == USL) gather(w, dt, (Take){.v = true, .x = true, .F = true});
    if (I == USF) gather(w, dt, (Take){.v = true, .x = true});
    if (I == UVF || I == MUSL) {
        gather(w, dt, (Take){.v = true, .later = I == MUSL, .L = fresh});
        project(w, t, false);
        solve(w, dt, 1);
        gather(w, dt, (Take){.x = I == UVF, .F = true});
    }
    for (int k = 0; k < w->n && I == MUSL; k++)
        for (int d = 0; d < DIM; d++) w->p[k].x[d] += w->p[k].u[d];
}
