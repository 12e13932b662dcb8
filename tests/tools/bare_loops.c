/* bare_loops.c: what a user would write instead of using a testbed: two plain loops in 2D, arrays
 * of structs, one thread, no output, no ledger, no checks. `make bench` times them beside the core.
 *
 * Both: neo-Hookean block [1/4, 5/4]^2 in a box of 3/2, four particles per cell, tau = mu (b - I) +
 * lambda ln J I, spinning at w with free edges; symplectic steps dt, a step being: clear the grid,
 * particles to grid, v = p/m + dt f/m, grid to particles. */
#define _GNU_SOURCE
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "tests/tools/bare_loops.h"

typedef struct Particle {
    double x[2], v[2], C[2][2], F[2][2];
} Particle;
typedef struct Node {
    double m, v[2], f[2];
} Node;

typedef struct Loop {
    int cells, wide, n; /* per metre, nodes per axis, particles */
    double h, dt, mass, volume, mu, lambda;
    Particle *p;
    Node *node;
} Loop;

/* Quadratic B-spline weights of the three nodes from base[a] on, at x in cells. */
static void spline(const double x[2], int base[2], double w[2][3], double fx[2])
{
    for (int a = 0; a < 2; a++) {
        base[a] = (int)(x[a] - 0.5);
        fx[a] = x[a] - base[a];
        w[a][0] = 0.5 * (1.5 - fx[a]) * (1.5 - fx[a]);
        w[a][1] = 0.75 - (fx[a] - 1) * (fx[a] - 1);
        w[a][2] = 0.5 * (fx[a] - 0.5) * (fx[a] - 0.5);
    }
}

/* GIMP weights of a box of half width b = 1/4 [cells], and their derivatives, about the nearest
 * node. */
static void boxes(const double x[2], int base[2], double S[2][3], double G[2][3])
{
    const double b = 0.25;
    for (int a = 0; a < 2; a++) {
        const int c = (int)(x[a] + 0.5);
        const double r = x[a] - c, in = r < -b ? -b : r > b ? b : r;
        base[a] = c - 1;
        S[a][2] = (b + in) * (b + in) / (4 * b) + (r - in > 0 ? r - in : 0);
        S[a][0] = (b - in) * (b - in) / (4 * b) + (in - r > 0 ? in - r : 0);
        S[a][1] = 1 - S[a][0] - S[a][2];
        G[a][2] = (b + in) / (2 * b);
        G[a][0] = -(b - in) / (2 * b);
        G[a][1] = -G[a][0] - G[a][2];
    }
}

static void kirchhoff(const Loop *l, double F[2][2], double tau[2][2])
{
    const double pressure = l->lambda * log(F[0][0] * F[1][1] - F[0][1] * F[1][0]);
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++)
            tau[a][b] = l->mu * (F[a][0] * F[b][0] + F[a][1] * F[b][1] - (a == b)) +
                        (a == b ? pressure : 0);
}

static void deform(Particle *p, double L[2][2], double dt)
{
    double F[2][2];
    memcpy(F, p->F, sizeof F);
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++) p->F[a][b] += dt * (L[a][0] * F[0][b] + L[a][1] * F[1][b]);
}

static void solve(Loop *l)
{
    for (int k = 0; k < l->wide * l->wide; k++) {
        Node *n = &l->node[k];
        for (int a = 0; a < 2 && n->m > 0; a++) n->v[a] = (n->v[a] + l->dt * n->f[a]) / n->m;
        for (int a = 0; a < 2 && n->m > 0; a++) n->f[a] /= n->m;
    }
}

/* MLS-MPM (Hu et al. 2018): stress and affine velocity in one matrix. */
static void step_mls(Loop *l)
{
    memset(l->node, 0, sizeof *l->node * (size_t)(l->wide * l->wide));
    for (Particle *p = l->p; p < l->p + l->n; p++) {
        const double x[2] = {p->x[0] / l->h, p->x[1] / l->h};
        double w[2][3], fx[2], tau[2][2], A[2][2];
        int base[2];
        spline(x, base, w, fx);
        kirchhoff(l, p->F, tau);
        for (int a = 0; a < 2; a++)
            for (int b = 0; b < 2; b++)
                A[a][b] = l->mass * p->C[a][b] - l->dt * l->volume * 4 / (l->h * l->h) * tau[a][b];
        for (int j = 0; j < 3; j++)
            for (int i = 0; i < 3; i++) {
                const double W = w[0][i] * w[1][j], r[2] = {(i - fx[0]) * l->h, (j - fx[1]) * l->h};
                Node *n = &l->node[(base[1] + j) * l->wide + base[0] + i];
                n->m += W * l->mass;
                for (int a = 0; a < 2; a++)
                    n->v[a] += W * (l->mass * p->v[a] + A[a][0] * r[0] + A[a][1] * r[1]);
            }
    }
    solve(l);
    for (Particle *p = l->p; p < l->p + l->n; p++) {
        const double x[2] = {p->x[0] / l->h, p->x[1] / l->h};
        double w[2][3], fx[2], v[2] = {0}, B[2][2] = {{0}};
        int base[2];
        spline(x, base, w, fx);
        for (int j = 0; j < 3; j++)
            for (int i = 0; i < 3; i++) {
                const double W = w[0][i] * w[1][j], r[2] = {i - fx[0], j - fx[1]};
                const Node *n = &l->node[(base[1] + j) * l->wide + base[0] + i];
                for (int a = 0; a < 2; a++) {
                    v[a] += W * n->v[a];
                    for (int b = 0; b < 2; b++) B[a][b] += 4 / l->h * W * n->v[a] * r[b];
                }
            }
        for (int a = 0; a < 2; a++) p->v[a] = v[a], p->x[a] += l->dt * v[a];
        memcpy(p->C, B, sizeof B);
        deform(p, p->C, l->dt);
    }
}

/* GIMP with undeformed boxes and the FLIP update. */
static void step_gimp(Loop *l)
{
    memset(l->node, 0, sizeof *l->node * (size_t)(l->wide * l->wide));
    for (Particle *p = l->p; p < l->p + l->n; p++) {
        const double x[2] = {p->x[0] / l->h, p->x[1] / l->h};
        double S[2][3], G[2][3], tau[2][2];
        int base[2];
        boxes(x, base, S, G);
        kirchhoff(l, p->F, tau);
        for (int j = 0; j < 3; j++)
            for (int i = 0; i < 3; i++) {
                const double W = S[0][i] * S[1][j];
                const double grad[2] = {G[0][i] * S[1][j] / l->h, S[0][i] * G[1][j] / l->h};
                Node *n = &l->node[(base[1] + j) * l->wide + base[0] + i];
                n->m += W * l->mass;
                for (int a = 0; a < 2; a++) {
                    n->v[a] += W * l->mass * p->v[a];
                    n->f[a] -= l->volume * (tau[a][0] * grad[0] + tau[a][1] * grad[1]);
                }
            }
    }
    solve(l);
    for (Particle *p = l->p; p < l->p + l->n; p++) {
        const double x[2] = {p->x[0] / l->h, p->x[1] / l->h};
        double S[2][3], G[2][3], L[2][2] = {{0}};
        int base[2];
        boxes(x, base, S, G);
        for (int j = 0; j < 3; j++)
            for (int i = 0; i < 3; i++) {
                const double W = S[0][i] * S[1][j];
                const double grad[2] = {G[0][i] * S[1][j] / l->h, S[0][i] * G[1][j] / l->h};
                const Node *n = &l->node[(base[1] + j) * l->wide + base[0] + i];
                for (int a = 0; a < 2; a++) {
                    p->v[a] += l->dt * W * n->f[a];
                    p->x[a] += l->dt * W * n->v[a];
                    for (int b = 0; b < 2; b++) L[a][b] += n->v[a] * grad[b];
                }
            }
        deform(p, L, l->dt);
    }
}

static bool loop_make(Loop *l, int cells)
{
    const double E = 1e4, nu = 0.3, spin = 30; /* [Pa] [-] [1/s]; rho = 1 kg/m^3 */
    const int row = 2 * cells;
    *l = (Loop){.cells = cells, .wide = 3 * cells / 2 + 1, .n = row * row, .h = 1.0 / cells};
    l->mu = E / (2 * (1 + nu));
    l->lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    l->dt = 0.3 * l->h / sqrt(l->lambda + 2 * l->mu);
    l->mass = l->volume = 1.0 / l->n;
    l->p = calloc((size_t)l->n, sizeof *l->p);
    l->node = calloc((size_t)(l->wide * l->wide), sizeof *l->node);
    for (int k = 0; k < l->n && l->p; k++) {
        const double x = (k % row + 0.5) / row - 0.5, y = (k / row + 0.5) / row - 0.5;
        l->p[k] = (Particle){
            {x + 0.75, y + 0.75}, {-spin * y, spin * x}, {{0, -spin}, {spin, 0}}, {{1, 0}, {0, 1}}};
    }
    return l->p && l->node;
}

static double angular(const Loop *l)
{
    double sum = 0;
    for (const Particle *p = l->p; p < l->p + l->n; p++)
        sum += l->mass * ((p->x[0] - 0.75) * p->v[1] - (p->x[1] - 0.75) * p->v[0]);
    return sum;
}

double bare_ns(BareLoop which, int cells, int steps, double *kept)
{
    Loop l;
    double ns = NAN;
    struct timespec from, to;
    if (loop_make(&l, cells)) {
        const double before = angular(&l);
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &from);
        for (int k = 0; k < steps; k++) which == BARE_MLS ? step_mls(&l) : step_gimp(&l);
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &to);
        ns = (1e9 * (double)(to.tv_sec - from.tv_sec) + (double)(to.tv_nsec - from.tv_nsec)) /
             ((double)l.n * steps);
        *kept = angular(&l) / before;
    }
    free(l.p), free(l.node);
    return ns;
}
