/* textbook.c: see textbook.h. Equations: W07 2.1, 4.2; W11 26-30, A2. */
#include <math.h>
#include <string.h>
#include "textbook_modes.h"

/* What a gather is for. */
typedef struct Take {
    bool v, x, later, L, F; /* later: keep the displacement for after a re-projection */
} Take;

double twin_det(const double F[DIM][DIM])
{
    const int u = 1 % DIM, z = 2 % DIM;
    if (DIM == 1) return F[0][0];
    if (DIM == 2) return F[0][0] * F[u][u] - F[0][u] * F[u][0];
    return F[0][0] * (F[u][u] * F[z][z] - F[u][z] * F[z][u]) -
           F[0][u] * (F[u][0] * F[z][z] - F[u][z] * F[z][0]) +
           F[0][z] * (F[u][0] * F[z][u] - F[u][u] * F[z][0]);
}

/* W11 eq 32, or P F^T/J with P linear in F. */
void twin_cauchy(const Material *m, const double F[DIM][DIM], double sigma[DIM][DIM])
{
    const double J = twin_det(F);
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

static void multiply(double A[DIM][DIM], double B[DIM][DIM], double out[DIM][DIM])
{
    double C[DIM][DIM] = {{0}};
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++)
            for (int k = 0; k < DIM; k++) C[a][b] += A[a][k] * B[k][b];
    memcpy(out, C, sizeof C);
}

void twin_refer_gradient(TwinParticle *p)
{
    multiply(p->L, p->F, p->L);
}

/* First Piola stress P = J sigma F^-T: its column b is J sigma times row b of F^-1, which is the
 * gradient by x of coordinate b of X: det with row or column replaced, over det. */
static void piola(const double F[DIM][DIM], double sigma[DIM][DIM])
{
    double J_inverse_T[DIM][DIM], P[DIM][DIM] = {{0}};
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) {
            double M[DIM][DIM];
            memcpy(M, F, sizeof M);
            for (int k = 0; k < DIM; k++) M[a][k] = k == b;
            J_inverse_T[a][b] = twin_det((const double(*)[DIM])M);
        }
    multiply(sigma, J_inverse_T, P);
    memcpy(sigma, P, sizeof P);
}

/* Slopes of the velocity that a particle deposits [1/s]: L, or moments over their spread (Jiang et
 * al. 2015). */
static void slopes(const Twin *w, const TwinParticle *p, const Sight s[3], double A[DIM][DIM])
{
    memcpy(A, p->L, sizeof p->L);
    for (int b = 0; b < DIM && w->method.moments; b++) {
        const double D = spread(w, p, s, b);
        for (int a = 0; a < DIM; a++) A[a][b] = D > 0 ? A[a][b] / D : 0;
    }
}

static void deposit(Twin *w, const TwinParticle *p, bool force)
{
    Sight s[3];
    TwinModes modes;
    double stress[DIM][DIM] = {{0}}, A[DIM][DIM] = {{0}}, S, G[DIM], x[DIM];
    look_around(w, p, s);
    if (w->method.modes) find_modes(w, p, s, &modes);
    if (w->method.gradient) slopes(w, p, s, A);
    if (force && !w->method.cells) twin_cauchy(&w->setup->scene->mat, p->F, stress);
    if (is_total(w) && force) piola(p->F, stress);
    const double V = p->V0 * (is_total(w) ? 1 : twin_det(p->F));
    FOR_NODES(s, i)
    {
        TwinNode *node = node_of(w, s, i, &S, G, x);
        if (!node) continue;
        node->m += S * p->m;
        for (int a = 0; a < DIM; a++) {
            double v = p->v[a];
            for (int b = 0; b < DIM && w->method.gradient; b++)
                v += A[a][b] * (x[b] - place(w, p, b));
            if (w->method.modes) v += mode_velocity(w, p, &modes, i, a);
            node->p[a] += S * p->m * v;
            for (int b = 0; b < DIM && force; b++) node->f[a] -= V * stress[a][b] * G[b];
            if (force) node->f[a] += S * p->m * p->b[a];
        }
    }
}

/* The particle behind one symmetry line; `more` is room for what else it keeps. */
static TwinParticle image(const TwinParticle *p, const Wall *wall, TwinMore *more)
{
    TwinParticle q = *p;
    const int n = wall->axis;
    q.more = p->more ? mirror_more(p->more, wall, more) : NULL;
    q.x[n] = 2 * wall->at - p->x[n];
    q.X[n] = 2 * wall->at - p->X[n];
    q.v[n] = -p->v[n];
    q.b[n] = -p->b[n];
    q.w[n] = -p->w[n];
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++)
            if ((a == n) != (b == n)) q.F[a][b] = -p->F[a][b], q.L[a][b] = -p->L[a][b];
    return q;
}

void twin_images(Twin *w, const TwinParticle *p, TwinDeposit *give, bool force, int k)
{
    const Scene *scene = w->setup->scene;
    while (k < scene->nwall && !scene->wall[k].mirror) k++;
    if (k == scene->nwall) {
        give(w, p, force);
        return;
    }
    TwinMore more;
    const TwinParticle q = image(p, &scene->wall[k], &more);
    twin_images(w, p, give, force, k + 1);
    twin_images(w, &q, give, force, k + 1);
}

static void weigh(Twin *w, const TwinParticle *p, bool force)
{
    Sight s[3];
    (void)force;
    look_around(w, p, s);
    FOR_NODES(s, i)
    {
        TwinNode *node = node_at(w, s, i);
        if (node) node->weight += s[0].S[i[0]] * s[1].S[i[1]] * s[2].S[i[2]] * p->m;
    }
}

/* The slope of a tent on a node asks which nodes have mass. */
static void weigh_nodes(Twin *w)
{
    bool kink = false;
    for (int k = 0; k < w->n && w->method.shape == TWIN_TENT; k++) {
        Sight s[3];
        look_around(w, &w->p[k], s);
        for (int d = 0; d < DIM; d++) kink |= s[d].kink;
    }
    for (int k = 0; k < w->n && kink; k++) twin_images(w, &w->p[k], weigh, false, 0);
}

static void project(Twin *w, double t, bool force)
{
    const Problem *problem = w->setup->scene->problem;
    for (long i = 0; i < w->nodes; i++) w->node[i] = (TwinNode){.held = w->node[i].held};
    weigh_nodes(w);
    for (int k = 0; k < w->n; k++) {
        TwinParticle *p = &w->p[k];
        const double *X[DIM];
        double *b[DIM];
        for (int d = 0; d < DIM; d++) X[d] = &p->X[d], b[d] = &p->b[d];
        if (force && problem->body) problem->body(w->setup->scene, 1, X, t, b);
        twin_images(w, p, deposit, force, 0);
    }
}

/* v = p/m, a = scale f/m, walls, v += a dt. */
static void solve(Twin *w, double dt, double scale)
{
    for (long i = 0; i < w->nodes; i++) {
        TwinNode *node = &w->node[i];
        if (node->m <= w->method.least * w->p[0].m) continue;
        for (int a = 0; a < DIM; a++) {
            if (node->held >> a & 1) continue;
            node->a[a] = scale * node->f[a] / node->m;
            node->v[a] = node->p[a] / node->m + node->a[a] * dt;
        }
    }
}

/* F += dt L F; of the reference grid L is dv/dX, and F += dt L. */
static void deform(const Twin *w, TwinParticle *p, double dt, double L[DIM][DIM])
{
    double rate[DIM][DIM];
    multiply(L, p->F, rate);
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) p->F[a][b] += dt * (is_total(w) ? L[a][b] : rate[a][b]);
}

/* FLIP: v += dt a; PIC: v = S v, or what a filter left of the particle's own (textbook_filter.c);
 * or a part of each. */
static void take_velocity(const Twin *w, TwinParticle *p, double dt, const double v[],
                          const double a[])
{
    const double pic = w->method.pic;
    for (int d = 0; d < DIM; d++) {
        const double flip = p->v[d] + dt * a[d];
        const double own = w->method.filter == TWIN_PARTICLES ? flip - p->w[d] : v[d];
        p->v[d] = (1 - pic) * flip + pic * own;
    }
}

/* CPDI2's corners go with the grid. */
static void move_corners(const Twin *w, TwinParticle *p, double dt, const Sight s[3])
{
    const TwinMore old = *p->more;
    for (int c = 0; c < TWIN_CORNERS; c++) FOR_NODES(s, i)
        {
            double y[DIM], node[DIM];
            const TwinNode *at = node_at(w, s, i);
            for (int d = 0; d < DIM; d++) {
                y[d] = old.corner[c][d] * w->setup->cells;
                node[d] = s[d].first + i[d];
            }
            for (int d = 0; d < DIM && at; d++)
                p->more->corner[c][d] += dt * corner_tent(y, node) * at->v[d];
        }
}

static void gather_one(const Twin *w, TwinParticle *p, double dt, Take take)
{
    const TwinMethod *m = &w->method;
    Sight s[3];
    TwinModes modes;
    double S, G[DIM], x[DIM], v[DIM] = {0}, a[DIM] = {0}, L[DIM][DIM] = {{0}}, B[DIM][DIM] = {{0}};
    look_around(w, p, s);
    if (m->modes) find_modes(w, p, s, &modes);
    FOR_NODES(s, i)
    {
        const TwinNode *node = node_of(w, s, i, &S, G, x);
        for (int d = 0; d < DIM && node; d++) {
            v[d] += S * node->v[d];
            a[d] += S * node->a[d];
            for (int b = 0; b < DIM; b++) L[d][b] += node->v[d] * G[b];
            for (int b = 0; b < DIM && m->moments; b++)
                B[d][b] += S * node->v[d] * (x[b] - place(w, p, b));
        }
    }
    if (take.v) take_velocity(w, p, dt, v, a);
    for (int d = 0; d < DIM; d++) {
        if (take.x) p->x[d] += dt * v[d];
        if (take.later) p->u[d] = dt * v[d];
    }
    if (m->pic > 0 ? take.v : take.L || take.F) memcpy(p->L, m->moments ? B : L, sizeof L);
    if (m->modes && take.v) take_twin_modes(w, p, s, &modes);
    const bool moves = take.x || (take.F && w->setup->integrator == MUSL);
    if (moves && m->shape == TWIN_CPDI2 && !is_total(w)) move_corners(w, p, dt, s);
    if (take.F) deform(w, p, dt, L);
}

static void gather(Twin *w, double dt, Take take)
{
    for (int k = 0; k < w->n; k++) gather_one(w, &w->p[k], dt, take);
}

/* Deposit, nodes, filter; the particles' own velocity is filtered where they will take it. */
static void solve_pass(Twin *w, double t, double dt, double scale, bool force)
{
    project(w, t, force);
    if (w->method.cells && force) twin_add_cell_forces(w);
    if (w->method.cells) twin_fit_velocities(w);
    solve(w, dt, scale);
    if (w->method.filter == TWIN_NODES) twin_filter_nodes(w);
    if (w->method.filter == TWIN_PARTICLES && force) twin_filter_particles(w);
}

void twin_step(Twin *w, double t, double dt, bool first)
{
    const Integrator I = w->setup->integrator;
    const bool fresh = w->setup->refresh;
    const double scale = first && (I == CD || I == UVF || I == MUSL) ? 0.5 : 1;
    if (I == USF) {
        solve_pass(w, t, dt, 1, false);
        gather(w, dt, (Take){.F = true});
    }
    solve_pass(w, t, dt, scale, true);
    if (I == CD || I == USL) gather(w, dt, (Take){.v = true, .x = true, .F = true});
    if (I == USF) gather(w, dt, (Take){.v = true, .x = true});
    if (I == UVF || I == MUSL) {
        gather(w, dt, (Take){.v = true, .later = I == MUSL, .L = fresh});
        solve_pass(w, t, dt, 1, false);
        gather(w, dt, (Take){.x = I == UVF, .F = true});
    }
    for (int k = 0; k < w->n && I == MUSL; k++)
        for (int d = 0; d < DIM; d++) w->p[k].x[d] += w->p[k].u[d];
}
