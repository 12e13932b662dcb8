/* node.c: motion of the nodes (W11 A1, A5, A6), walls, and the momentum that comes from outside.
 *
 *   a = f/M + b(X, t),  v += dt a (dt/2 on the first step),  x += dt v.
 * Forces are summed node by node over its corners in a fixed order, and blocks in theirs, so that no
 * bit depends on the number of threads.
 *
 * Walls. A node whose reference position lies on a wall keeps the held components at zero velocity for
 * good (a mirror: the normal one); its wall may be one the body is glued to. Any other node, and every
 * node of a unilateral wall, meets the wall as a barrier if the normal is held: where a step would end
 * beyond, the node stops on the wall with the other held components at rest, and leaves as soon as it is
 * pulled away. So an impact never sticks, also where a grid method would call the wall bilateral. */
#include "fem.h"

/* Internal force on the nodes lo .. lo + n. */
static inline void gather_forces(const Fem *f, int lo, int n, double force[DIM][BLOCK])
{
    for (int i = 0; i < n; i++) {
        double sum[DIM] = {0};
        for (int k = f->first[lo + i]; k < f->first[lo + i + 1]; k++)
            for (int d = 0; d < DIM; d++) sum[d] += f->force[f->touching[k] + d * CHUNK];
        for (int d = 0; d < DIM; d++) force[d][i] = sum[d];
    }
}

static void body_force(const Fem *f, int lo, int n, double t, double b[DIM][BLOCK])
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

static bool any_beyond(const double *x, int n, double at, int side)
{
    int beyond = 0;
    for (int i = 0; i < n; i++) beyond |= side * (x[i] - at) > 0;
    return beyond;
}

/* Stops the nodes that went beyond wall w in this step. */
static void stop(Fem *f, const Wall *w, int lo, int n, double dt)
{
    double *x = f->x[w->axis] + lo, *v = f->v[w->axis] + lo;
    if (!any_beyond(x, n, w->at, w->side)) return;
    for (int i = 0; i < n; i++) {
        if (!(w->side * (x[i] - w->at) > 0)) continue;
        double before = x[i] - dt * v[i];
        for (int d = 0; d < DIM; d++)
            if (d != w->axis && (w->hold >> d & 1)) {
                f->x[d][lo + i] -= dt * f->v[d][lo + i];
                f->v[d][lo + i] = 0;
            }
        v[i] = (w->at - before) / dt;
        x[i] = w->at;
    }
}

/* One block of nodes. What it gains beyond the internal forces came from body forces and walls. */
static void move_block(Fem *f, int block, double t, double dt, double dt_v)
{
    const int lo = block * BLOCK, n = f->nodes - lo < BLOCK ? f->nodes - lo : BLOCK;
    double force[DIM][BLOCK], b[DIM][BLOCK], before[DIM][BLOCK];
    const double *m = f->m + lo;
    gather_forces(f, lo, n, force);
    body_force(f, lo, n, t, b);
    for (int d = 0; d < DIM; d++) {
        double *x = f->x[d] + lo, *v = f->v[d] + lo, *keep = f->keep[d] + lo;
        for (int i = 0; i < n; i++) {
            before[d][i] = v[i];
            v[i] = keep[i] * (v[i] + dt_v * (force[d][i] / m[i] + b[d][i]));
            x[i] += dt * v[i];
        }
    }
    for (int w = 0; w < f->barriers; w++) stop(f, &f->barrier[w], lo, n, dt);
    for (int d = 0; d < DIM; d++) {
        double sum = 0;
        const double *v = f->v[d] + lo;
        for (int i = 0; i < n; i++) sum += m[i] * (v[i] - before[d][i]) - dt_v * force[d][i];
        f->given[d][block] = sum;
    }
}

void fem_move(Fem *f, double t, double dt, bool first)
{
    const double dt_v = first ? 0.5 * dt : dt;
#pragma omp parallel for schedule(static) num_threads(f->threads) if (f->threads > 1)
    for (int block = 0; block < f->blocks; block++) move_block(f, block, t, dt, dt_v);
    for (int d = 0; d < DIM; d++)
        for (int block = 0; block < f->blocks; block++) f->impulse[d] += f->given[d][block];
}
