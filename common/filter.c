/* filter.c: extra velocity-only rounds (XPIC, FMPM): with S from nodes to particles and S+ from
 * particles to nodes by mass, the grid velocity v becomes sum_l c_l (S+ S)^l v.
 * Hammerquist & Nairn 2017; Nairn & Hammerquist 2021. Each round is a gather and a deposit more. */
#include "passes.h"

typedef void VisitNode(Line *node, Line *keep, double c, double dt);

static void each_node(Sim *sim, VisitNode *visit, double c, double dt)
{
    Grid *g = &sim->g;
#pragma omp parallel for schedule(static) num_threads(sim->setup->threads)
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            visit(&g->node[at], &g->keep[at], c, dt);
        }
}

/* keep = {sum, a}; the sum starts with c_0 v. */
static void open_sum(Line *node, Line *keep, double c, double dt)
{
    (void)dt;
    for (int a = 0; a < DIM; a++) {
        (*keep)[a] = c * (*node)[a];
        (*keep)[DIM + a] = (*node)[DIM + a];
    }
}

/* XPIC filters the velocity before its acceleration. */
static void take_back(Line *node, Line *keep, double c, double dt)
{
    (void)c, (void)keep;
    for (int a = 0; a < DIM; a++) (*node)[a] -= dt * (*node)[DIM + a];
}

static void add_round(Line *node, Line *keep, double c, double dt)
{
    (void)dt;
    for (int a = 0; a < DIM; a++) (*keep)[a] += c * (*node)[a];
}

/* dt 0, or the step if the acceleration comes after the filter. */
static void close_sum(Line *node, Line *keep, double c, double dt)
{
    (void)c;
    for (int a = 0; a < DIM; a++) {
        const double v = (*keep)[a] + dt * (*keep)[DIM + a];
        (*node)[a] = v;
        (*node)[DIM + a] = (*keep)[DIM + a];
        for (int b = 0; b < DIM; b++) (*node)[FLUX + b * DIM + a] = v;
    }
}

void filter_all(Sim *sim, double dt)
{
    const Method *method = &sim->method;
    const double after = method->filter_first ? dt : 0;
    double c[MAX_ROUNDS + 1] = {1};
    const int rounds = method->filter(sim->setup->method_par, c);
    if (method->filter_first) each_node(sim, take_back, 0, dt);
    each_node(sim, open_sum, c[0], dt);
    for (int l = 1; l <= rounds; l++) {
        gather_velocity(sim);
        deposit_all(sim, 0, ROUND);
        solve_all(sim, 0, 1, false);
        each_node(sim, add_round, c[l], dt);
    }
    each_node(sim, close_sum, 0, after);
}
