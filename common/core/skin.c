/* skin.c: see skin.h. The force of a point is its reference area times the nominal traction P N.
 *
 * Methods that integrate at particles share it among the corners of its cell that have mass, by
 * tents (scaled up to a sum of 1, so that no force is lost where a corner is empty; in a cell
 * without mass all goes to the nearest node that has some). The point moves with the mean velocity
 * of those nodes, weighted with their masses too: a node that hardly has any may move far.
 *
 * Methods that integrate over cells (WLS) know the boundary of those cells: sum_q V_q dS_i/dx is
 * the integral of S_i n over it. A node's force is that share times the mean traction of the points
 * about it, so that a uniform stress balances its traction exactly. */
#include "skin.h"
#include <stdlib.h>
#include <string.h>
#include "common/contract/layout.h"
#include "sim.h"

enum { SKIN_CORNERS = 1 << DIM };

/* The n corners of a point's cell that have mass, and their weights. */
typedef struct Foot {
    int n;
    size_t node[SKIN_CORNERS];
    double weight[SKIN_CORNERS];     /* of its force */
    double motion[SKIN_CORNERS];     /* of the nodes' velocities */
    double slope[SKIN_CORNERS][DIM]; /* [1/m] */
} Foot;

struct Skin {
    int n;
    double *X[DIM], *N[DIM], *x[DIM]; /* [m] [-] [m] reference, its outward normal, current */
    double *area;                     /* [m^(DIM-1)] share of the reference surface */
    double *force[DIM];               /* [N] */
    double *move[DIM];                /* [m] of the last step */
    double *F[NMAT];                  /* [-] */
    double (*sum)[2 * DIM]; /* [nodes] with cells: forces, and areas times normals; else NULL */
    Foot *foot;             /* of the last deposit */
    double work;
    double *memory; /* of so many numbers: */
    size_t numbers;
};

static bool allocate(Skin *s, int n)
{
    double **const fields[] = {s->X, s->N, s->x, s->force, s->move};
    const int count = sizeof fields / sizeof *fields;
    s->n = n;
    s->numbers = (size_t)(count * DIM + NMAT + 1) * (size_t)(n + 1);
    s->memory = calloc(s->numbers, sizeof(double));
    s->foot = calloc((size_t)n + 1, sizeof *s->foot);
    if (!s->memory || !s->foot) return false;
    for (int f = 0; f < count; f++)
        for (int d = 0; d < DIM; d++) fields[f][d] = s->memory + (size_t)(f * DIM + d) * (size_t)n;
    s->area = s->memory + (size_t)(count * DIM) * (size_t)n;
    for (int k = 0; k < NMAT; k++) s->F[k] = s->area + (size_t)(1 + k) * (size_t)n;
    return true;
}

/* x = X + u of the scene's start. */
static bool place(Skin *s, const Scene *scene)
{
    const size_t n = (size_t)s->n;
    double *room = calloc((NMAT + DIM) * (n + 1), sizeof(double));
    double *v[DIM], *L[NMAT];
    if (!room) return false;
    for (int d = 0; d < DIM; d++) v[d] = room + (size_t)d * n;
    for (int k = 0; k < NMAT; k++) {
        L[k] = room + (size_t)(DIM + k) * n;
        for (size_t p = 0; p < n; p++) s->F[k][p] = k % (DIM + 1) == 0;
    }
    if (scene->problem->start)
        scene->problem->start(scene, s->n, (const double *const *)s->X, s->x, v, s->F, L);
    for (int d = 0; d < DIM; d++)
        for (size_t p = 0; p < n; p++) s->x[d][p] += s->X[d][p];
    free(room);
    return true;
}

bool skin_new(Skin **out, const Sim *sim, double spacing)
{
    const Scene *scene = sim->setup->scene;
    const size_t nodes = (size_t)sim->g.rows * (size_t)sim->g.n[0];
    Layout points = {0};
    if (!scene->traction) return true;
    scene->problem->surface(scene, spacing, &points);
    Skin *s = *out = calloc(1, sizeof *s);
    bool ok = s && !points.lost && allocate(s, points.n);
    if (ok && sim->g.outward) ok = (s->sum = calloc(nodes, sizeof *s->sum)) != NULL;
    for (int p = 0; ok && p < s->n; p++) {
        s->area[p] = points.volume[p];
        for (int d = 0; d < DIM; d++) s->X[d][p] = points.X[d][p], s->N[d][p] = points.normal[d][p];
    }
    layout_free(&points);
    return ok && place(s, scene);
}

void skin_free(Skin *skin)
{
    if (!skin) return;
    free(skin->memory), free(skin->foot), free(skin->sum), free(skin);
}

void skin_stash(Skin *skin, Stash *s)
{
    if (!stash_same(s, skin ? skin->n : 0) || !skin) return;
    stash_bytes(s, skin->memory, sizeof(double) * skin->numbers);
    STASH(s, skin->work);
}

void skin_take_over(Skin *to, const Skin *from)
{
    if (!to) return;
    memcpy(to->memory, from->memory, sizeof(double) * to->numbers);
    to->work = from->work;
}

double skin_work(const Skin *skin)
{
    return skin ? skin->work : 0;
}

/* Forces of time t: A P N. */
static void find_forces(Skin *s, const Scene *scene, double t)
{
    scene->problem->traction(scene, s->n, (const double *const *)s->X, (const double *const *)s->N,
                             t, s->force);
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < s->n; p++) s->force[d][p] *= s->area[p];
}

/* Number of the node at grid index `index`; NOWHERE if it has no mass or is not live. */
static size_t massive_node(const Sim *sim, const int index[DIM])
{
    const Grid *g = &sim->g;
    int row = 0;
    for (int d = DIM - 1; d > 0; d--) {
        if (index[d] < 0 || index[d] >= g->n[d]) return NOWHERE;
        row = row * g->n[d] + index[d];
    }
    if (index[0] < g->lo[row] || index[0] >= g->hi[row]) return NOWHERE;
    const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)index[0];
    return g->node[at][0] > sim->mass_cut ? at : NOWHERE;
}

/* The nearest node with mass within 2 cells, all weight on it. */
static void stand_on_nearest(const Sim *sim, const int base[DIM], const double from[DIM], Foot *f)
{
    enum { SIDE = 6 };
    const int own = f->n; /* behind corners of no weight */
    double least = INFINITY;
    int cube = 1;
    for (int d = 0; d < DIM; d++) cube *= SIDE;
    for (int k = 0; k < cube; k++) {
        int index[DIM];
        double square = 0;
        for (int d = 0, rest = k; d < DIM; d++, rest /= SIDE) {
            index[d] = base[d] + rest % SIDE - 2;
            square += pow(rest % SIDE - 2 - from[d], 2);
        }
        const size_t at = massive_node(sim, index);
        if (at == NOWHERE || !(square < least)) continue;
        least = square;
        f->n = own + 1;
        f->node[own] = at;
        f->weight[own] = f->motion[own] = 1;
    }
}

/* Derivative of corner k's tent along axis b [1/cell]. */
static double slope_of(const double from[DIM], int k, int b)
{
    double G = 1;
    for (int d = 0; d < DIM; d++) {
        const double S = k >> d & 1 ? from[d] : 1 - from[d];
        G *= d == b ? (k >> d & 1 ? 1 : -1) : S;
    }
    return G;
}

static void find_foot(const Sim *sim, const Skin *s, int p, Foot *f)
{
    int base[DIM];
    double from[DIM], total = 0, mass = 0;
    *f = (Foot){.n = 0};
    for (int d = 0; d < DIM; d++) {
        const double at = s->x[d][p] * sim->g.cells - sim->g.origin[d];
        base[d] = (int)floor(fmin(fmax(at, -9), 1e9));
        from[d] = at - base[d];
    }
    for (int k = 0; k < SKIN_CORNERS; k++) {
        int index[DIM];
        double S = 1;
        for (int d = 0; d < DIM; d++) {
            index[d] = base[d] + (k >> d & 1);
            S *= k >> d & 1 ? from[d] : 1 - from[d];
        }
        const size_t at = massive_node(sim, index);
        if (at == NOWHERE) continue;
        const int own = f->n++;
        f->node[own] = at;
        f->weight[own] = S;
        for (int b = 0; b < DIM; b++) f->slope[own][b] = slope_of(from, k, b) * sim->g.cells;
        f->motion[own] = sim->method.assemble ? S : S * sim->g.node[at][0];
        total += S;
        mass += f->motion[own];
    }
    for (int k = 0; k < f->n && total > 0; k++) {
        f->weight[k] /= total;
        f->motion[k] /= mass;
    }
    if (!(total > 0)) stand_on_nearest(sim, base, from, f);
}

/* Forces of the points as they are, for methods that integrate at particles. */
static void deposit_points(Sim *sim, const Skin *s)
{
    for (int p = 0; p < s->n; p++)
        for (int k = 0; k < s->foot[p].n; k++)
            for (int a = 0; a < DIM; a++)
                sim->g.force[s->foot[p].node[k] * DIM + (size_t)a] +=
                    s->foot[p].weight[k] * s->force[a][p];
}

/* Force and current area vector a n = J F^-T N A of point p onto its corners. */
static void sum_point(Skin *s, int p)
{
    Mat F;
    double own[2 * DIM];
    for (int k = 0; k < NMAT; k++) F[k] = s->F[k][p];
    for (int a = 0; a < DIM; a++) {
        own[a] = s->force[a][p];
        own[DIM + a] = 0;
        for (int b = 0; b < DIM; b++) own[DIM + a] += cofactor(F, a, b) * s->N[b][p] * s->area[p];
    }
    for (int k = 0; k < s->foot[p].n; k++)
        for (int c = 0; c < 2 * DIM; c++)
            s->sum[s->foot[p].node[k]][c] += s->foot[p].weight[k] * own[c];
}

/* The mean traction near a node times its share of the boundary of the cells, projected on the mean
 * normal of the loaded points. On a symmetry plane the cells' boundary includes the plane, whose
 * share the mirrored body takes back. The sums are cleared, so that each node counts once. */
static void load_node(Sim *sim, Skin *s, size_t at)
{
    double *sum = s->sum[at], square = 0, share = 0;
    const size_t row = at / (size_t)sim->g.n[0];
    for (int a = 0; a < DIM; a++) square += sum[DIM + a] * sum[DIM + a];
    for (int a = 0; a < DIM && square > 0; a++)
        if (!mirror_has_node(&sim->g, a, (int)(at % (size_t)sim->g.n[0]), (int)row))
            share += sum[DIM + a] * sim->g.outward[at * DIM + (size_t)a] / square;
    for (int a = 0; a < DIM; a++) sim->g.force[at * DIM + (size_t)a] += share * sum[a];
    for (int c = 0; c < 2 * DIM; c++) sum[c] = 0;
}

void skin_deposit(Sim *sim, double t)
{
    Skin *s = sim->skin;
    find_forces(s, sim->setup->scene, t);
    for (int p = 0; p < s->n; p++) find_foot(sim, s, p, &s->foot[p]);
    if (!sim->g.outward) deposit_points(sim, s);
    for (int p = 0; p < s->n && sim->g.outward; p++) sum_point(s, p);
    for (int p = 0; p < s->n && sim->g.outward; p++)
        for (int k = 0; k < s->foot[p].n; k++) load_node(sim, s, s->foot[p].node[k]);
}

static double work_of_step(const Skin *s)
{
    double sum = 0;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < s->n; p++) sum += s->force[d][p] * s->move[d][p];
    return sum;
}

/* F += dt L F with the slopes of the nodes' velocities. */
static void strain_point(const Sim *sim, Skin *s, int p, double dt)
{
    Mat F, L = {0};
    for (int k = 0; k < NMAT; k++) F[k] = s->F[k][p];
    for (int k = 0; k < s->foot[p].n; k++)
        for (int c = 0; c < NMAT; c++)
            L[c] += s->foot[p].slope[k][c % DIM] * sim->g.node[s->foot[p].node[k]][c / DIM];
    for (int c = 0; c < NMAT; c++)
        for (int b = 0; b < DIM; b++)
            s->F[c][p] += dt * L[c / DIM * DIM + b] * F[b * DIM + c % DIM];
}

void skin_move(Sim *sim, double t, double dt)
{
    Skin *s = sim->skin;
    for (int p = 0; p < s->n && s->sum; p++) strain_point(sim, s, p, dt);
    for (int p = 0; p < s->n; p++)
        for (int d = 0; d < DIM; d++) {
            s->move[d][p] = 0;
            for (int k = 0; k < s->foot[p].n; k++)
                s->move[d][p] += dt * s->foot[p].motion[k] * sim->g.node[s->foot[p].node[k]][d];
            s->x[d][p] += s->move[d][p];
        }
    const double before = work_of_step(s);
    find_forces(s, sim->setup->scene, t + dt);
    s->work += 0.5 * (before + work_of_step(s));
}
