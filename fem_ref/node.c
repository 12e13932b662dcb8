/* node.c: motion of the nodes (W11 A1, A5, A6), walls, and the momentum that comes from outside.
 *
 *   a = f/M + b(X, t),  v += dt a (dt/2 on the first step),  x += dt v.
 *
 * b is that at the node (A1) or the mean over the elements around it, with their shares of its
 * mass, of b at their centres.
 *
 * Forces are summed node by node over its corners in a fixed order: no bit depends on the number of
 * threads.
 *
 * Walls. A node whose reference position lies on a wall keeps the held components at zero velocity
 * for good (a mirror: the normal one); its wall may be one the body is glued to. Any other node,
 * and every node of a unilateral wall, meets the wall as a barrier if the normal is held: where a
 * step would end beyond, the node stops on the wall with the other held components at rest, and
 * leaves as soon as it is pulled away. So an impact never sticks, also where a grid method would
 * call the wall bilateral. */
#include "fem.h"
#include "common/base/team.h"

/* Sum over a node's corners of what lies at their places, in groups and a fixed order. */
static inline Packed sum_corners(const Packed *value, const int at[VALENCE], int none)
{
    Packed total = {0};
    for (int first = 0; first < VALENCE; first += GROUP) {
        Packed sum[GROUP];
        if (first > 0 && at[first] == none) break;
        for (int k = 0; k < GROUP; k++) sum[k] = value[at[first + k]];
        for (int half = GROUP / 2; half > 0; half /= 2)
            for (int k = 0; k < half; k++) sum[k] += sum[k + half];
        total += sum[0];
    }
    return total;
}

/* Internal force on the nodes lo .. lo + n. */
static inline void gather_forces(const Fem *f, int lo, int n, double force[DIM][BLOCK])
{
    for (int i = 0; i < n; i++) {
        const Packed sum = sum_corners(f->force, f->touching[lo + i], no_force(f));
        for (int d = 0; d < DIM; d++) force[d][i] = sum[d];
    }
}

/* rho V b at the centre of each element, in equal shares for its corners. */
static void pull_chunk(Fem *f, int start, double t)
{
    Field b[DIM];
    const double *X[DIM];
    double *out[DIM];
    for (int d = 0; d < DIM; d++) {
        X[d] = f->middle[d] + start;
        out[d] = b[d];
    }
    f->scene->problem->body(f->scene, CHUNK, X, t, out);
    for (int e = 0; e < CHUNK; e++) {
        const double share = f->scene->mat.rho * f->A0[start + e] / (double)CORNERS;
        Packed own = {0};
        for (int d = 0; d < DIM; d++) own[d] = share * b[d][e];
        f->pull[start + e] = own;
    }
}

/* Body force per mass from the elements around the nodes lo .. lo + n. */
static void integrated_force(const Fem *f, int lo, int n, double b[DIM][BLOCK])
{
    for (int i = 0; i < n; i++) {
        int element[VALENCE];
        for (int k = 0; k < VALENCE; k++) element[k] = element_at(f->touching[lo + i][k]);
        const Packed sum = sum_corners(f->pull, element, f->slots);
        for (int d = 0; d < DIM; d++) b[d][i] = sum[d] / f->m[lo + i];
    }
}

static void own_force(const Fem *f, int lo, int n, double t, double b[DIM][BLOCK])
{
    const double *X[DIM];
    double *out[DIM];
    for (int d = 0; d < DIM; d++) {
        X[d] = f->X[d] + lo;
        out[d] = b[d];
        for (int i = 0; i < n; i++) b[d][i] = 0;
    }
    if (f->scene->problem->body) f->scene->problem->body(f->scene, n, X, t, out);
}

/* Force per mass from outside: body force and traction. */
static void body_force(const Fem *f, int lo, int n, double t, double b[DIM][BLOCK])
{
    if (f->integrate)
        integrated_force(f, lo, n, b);
    else
        own_force(f, lo, n, t, b);
    for (int d = 0; d < DIM && f->sides; d++)
        for (int i = 0; i < n; i++) b[d][i] += fem_load(f, d)[lo + i] / f->m[lo + i];
}

static bool any_beyond(const double *x, int n, double at, int side)
{
    int beyond = 0;
    for (int i = 0; i < n; i++) beyond |= side * (x[i] - at) > 0;
    return beyond;
}

/* Moves component d of node i to position x as if the step just taken had ended there. */
static void correct(Fem *f, int d, int i, double x, double dt)
{
    double dv = (x - f->x[d][i]) / dt;
    f->x[d][i] = x;
    f->v[d][i] += dv;
    f->given[d][i] += f->m[i] * dv;
}

/* Stops the nodes that went beyond wall w in this step. */
static void stop(Fem *f, const Wall *w, int lo, int n, double dt)
{
    const double *x = f->x[w->axis];
    if (!any_beyond(x + lo, n, w->at, w->side)) return;
    for (int i = lo; i < lo + n; i++) {
        if (!(w->side * (x[i] - w->at) > 0)) continue;
        for (int d = 0; d < DIM; d++)
            if (d == w->axis)
                correct(f, d, i, w->at, dt);
            else if (w->hold >> d & 1)
                correct(f, d, i, f->x[d][i] - dt * f->v[d][i], dt);
    }
}

/* One component of n nodes. What they gain beyond the internal force came from outside. */
static inline void move(int n, const double force[], const double b[], const double m[],
                        const double keep[], double dt, double dt_v, double *restrict x,
                        double *restrict v, double *restrict given)
{
    for (int i = 0; i < n; i++) {
        double new = keep[i] * (v[i] + dt_v * (force[i] / m[i] + b[i]));
        given[i] += m[i] * (new - v[i]) - dt_v * force[i];
        v[i] = new;
        x[i] += dt * new;
    }
}

static void move_block(Fem *f, int lo, double t, double dt, double dt_v)
{
    const int n = f->nodes - lo < BLOCK ? f->nodes - lo : BLOCK;
    double force[DIM][BLOCK], b[DIM][BLOCK];
    gather_forces(f, lo, n, force);
    body_force(f, lo, n, t, b);
    for (int d = 0; d < DIM; d++)
        move(n, force[d], b[d], f->m + lo, f->keep[d] + lo, dt, dt_v, f->x[d] + lo, f->v[d] + lo,
             f->given[d] + lo);
    for (int w = 0; w < f->barriers; w++) stop(f, &f->barrier[w], lo, n, dt);
    for (int i = lo; i < lo + n; i++)
        for (int d = 0; d < DIM; d++) f->now[i][d] = f->x[d][i];
}

/* Adds the momentum that the body force gives over dt. */
static void record_outside(Fem *f, double t, double dt)
{
    double b[DIM][BLOCK];
    for (int lo = 0; lo < f->nodes; lo += BLOCK) {
        const int n = f->nodes - lo < BLOCK ? f->nodes - lo : BLOCK;
        body_force(f, lo, n, t, b);
        for (int d = 0; d < DIM; d++)
            for (int i = 0; i < n; i++) f->outside[d] += dt * f->m[lo + i] * b[d][i];
    }
}

typedef struct Move {
    Fem *f;
    double t, dt, dt_v;
} Move;

static void pull_chunks(void *own, int first, int last)
{
    const Move *m = own;
    for (int k = first; k < last; k++) pull_chunk(m->f, k * CHUNK, m->t);
}

static void move_blocks(void *own, int first, int last)
{
    const Move *m = own;
    for (int k = first; k < last; k++) move_block(m->f, k * BLOCK, m->t, m->dt, m->dt_v);
}

void fem_move(Fem *f, double t, double dt, bool first)
{
    const double before = first ? 0 : f->dt_before > 0 ? f->dt_before : dt;
    const double dt_v = 0.5 * (before + dt); /* from the middle of one step to that of the next */
    Move all = {f, t, dt, dt_v};
    if (f->integrate) team_share(f->threads, f->slots / CHUNK, pull_chunks, &all);
    if (f->sides) fem_load_sides(f, t);
    if (f->reactions) record_outside(f, t, dt_v);
    team_share(f->threads, (f->nodes + BLOCK - 1) / BLOCK, move_blocks, &all);
    if (f->sides) fem_record_work(f, t, dt);
    f->dt_before = dt;
}
