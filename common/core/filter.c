/* filter.c: extra velocity-only rounds (XPIC, FMPM): with S from nodes to particles and S+ from
 * particles to nodes by mass, the grid velocity v becomes sum_l c_l (S+ S)^l v.
 * Hammerquist & Nairn 2017; Nairn & Hammerquist 2021. Each round is a gather and a deposit more. */
#include "passes.h"
#include "common/base/team.h"

/* Lanes of Grid.keep: the sum, v and a before filtering, the mass of the real particles. */
enum { K_SUM = 0, K_V = DIM, K_A = 2 * DIM, K_MASS = LANES - 1 };

typedef void VisitNode(Line *node, Line *keep, double c, double impulse[DIM]);

typedef struct Visit {
    const Grid *g;
    VisitNode *visit;
    double c;
} Visit;

static void visit_rows(void *own, int first, int last)
{
    const Visit *v = own;
    const Grid *g = v->g;
    for (int row = first; row < last; row++) {
        for (int a = 0; a < DIM; a++) g->impulse[row][a] = 0;
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            v->visit(&g->node[at], &g->keep[at], v->c, g->impulse[row]);
        }
    }
}

static void each_node(Sim *sim, VisitNode *visit, double c)
{
    team_share(sim->setup->threads, sim->g.rows, visit_rows, &(Visit){&sim->g, visit, c});
}

static void note_mass(Line *node, Line *keep, double c, double impulse[DIM])
{
    (void)c, (void)impulse;
    (*keep)[K_MASS] = (*node)[1 + DIM];
}

/* Starts the sum. The rounds filter v - dt a; dt = 0 if the accelerated velocity is filtered. */
static void open_sum(Line *node, Line *keep, double dt, double impulse[DIM])
{
    (void)impulse;
    for (int a = 0; a < DIM; a++) {
        (*keep)[K_V + a] = (*node)[a];
        (*keep)[K_A + a] = (*node)[DIM + a];
        (*node)[a] -= dt * (*node)[DIM + a];
        (*keep)[K_SUM + a] = 0;
    }
}

static void add_round(Line *node, Line *keep, double c, double impulse[DIM])
{
    (void)impulse;
    for (int a = 0; a < DIM; a++) (*keep)[K_SUM + a] += c * (*node)[a];
}

/* Puts the filtered velocity into the lanes of a, where particle velocities come from, and adds the
 * momentum that walls absorbed during the rounds to `impulse`. */
static void close_sum(Line *node, Line *keep, double dt, double impulse[DIM])
{
    for (int a = 0; a < DIM; a++) {
        const double plain = (*keep)[K_V + a], v = (*keep)[K_SUM + a] + dt * (*keep)[K_A + a];
        impulse[a] += (*keep)[K_MASS] * (v - plain);
        (*node)[DIM + a] = v;
        (*node)[a] = dt > 0 ? plain : v;
        for (int b = 0; b < DIM; b++) (*node)[FLUX + b * DIM + a] = (*node)[a];
    }
}

void filter_open(Sim *sim)
{
    each_node(sim, note_mass, 0);
}

void filter_all(Sim *sim, double dt, bool takes_v)
{
    const Method *method = &sim->method;
    const double before = method->filter_first ? dt : 0;
    double c[MAX_ROUNDS + 1] = {1};
    const int rounds = method->filter(sim->setup->method_par, c);
    each_node(sim, open_sum, before);
    each_node(sim, add_round, c[0]);
    for (int l = 1; l <= rounds; l++) {
        gather_velocity(sim);
        deposit_all(sim, 0, ROUND);
        solve_all(sim, 0, 1, false);
        each_node(sim, add_round, c[l]);
    }
    each_node(sim, close_sum, before);
    for (int row = 0; takes_v && row < sim->g.rows; row++)
        for (int a = 0; a < DIM; a++) sim->impulse[a] += sim->g.impulse[row][a];
}
