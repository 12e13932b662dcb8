/* test_peers.c: particle states computed by codes of other authors, in tests/data/peers:
 *
 *   matter_*   Matter (github.com/larsblatny/matter, commit bf948b6), unmodified
 *   nairn_*    NairnMPM (github.com/nairnj/nairn-mpm-fea, commit 7f47b022), deformation gradient
 *              to first order in dt L, with one line changed (below)
 *
 * Each is free_block at 16 cells, 4 particles per cell, CFL .3, after the number of steps in the
 * file's name; of its 1024 particles every 11th is stored, with the 17 digits that the code
 * printed.
 *
 * Conventions that differ:
 *   position   NairnMPM moves particles by dt S v - (dt^2/2) S a, v the accelerated velocity of the
 *              nodes. mpmlab moves them by dt S v, and so does NairnMPM in these files (the changed
 *              line). Unmodified, positions differ by 2.7e-4 m at this dt and half as much at dt/2:
 *              first order in dt.
 *   walls      NairnMPM gives a node on a wall a = (v_wall - v)/dt, mpmlab a = 0. Both converge,
 *              with an error of O(h^2). free_block has no wall.
 *   domains    NairnMPM's uGIMP keeps the initial half widths: here domain=undeformed. */
#include <stdlib.h>
#include <string.h>
#include "common/run/plan.h"
#include "common/run/state.h"
#include "common/base/table.h"
#include "tests/check.h"

typedef struct Peer {
    const char *file, *method, *integrator, *set;
    int steps;
} Peer;

static const Peer peers[] = {
    {"matter_bspline_flip_usl_60", "bspline", "usl", NULL, 60},
    {"matter_apic_usl_60", "apic", "usl", NULL, 60},
    {"nairn_linear_usf_40", "mpm", "usf", NULL, 40},
    {"nairn_bspline_usf_40", "bspline", "usf", NULL, 40},
    {"nairn_ugimp_usf_40", "gimp", "usf", "domain=undeformed", 40},
    {"nairn_ugimp_musl_40", "gimp", "musl", "domain=undeformed", 40},
};

enum { STORED = 94 };                           /* particles in a file */
static const double dt = 1.4252192813739222e-4; /* [s] of all files */

/* The state after all steps; to be freed with state_free. */
static State advance(const Peer *peer)
{
    RunSpec spec = {.problem = "free_block", .cells = 16, .ppc = 4, .cfl = 0.3};
    Plan plan;
    State s;
    strcpy(spec.method, peer->method);
    strcpy(spec.integrator, peer->integrator);
    if (peer->set) CU_ASSERT_FATAL(spec_set(&spec, peer->set, NULL) == 0);
    check_context_of(DIM, &spec);
    CU_ASSERT_FATAL(plan_make(&spec, &plan, NULL) == 0);
    CHECK_CLOSE(plan.cfl * plan.scene.cell / plan.scene.c / dt, 1, 1e-15);
    void *self = plan.solver->make(&plan.setup, NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(self);
    for (int k = 0; k < peer->steps; k++)
        CU_ASSERT(plan.solver->step(self, k * dt, dt, k == 0).code == OK);
    CU_ASSERT_FATAL(state_of_points(&s, &plan.scene, plan.solver, self, NULL) == 0);
    plan.solver->free(self);
    return s;
}

/* The particle with this reference position, which both codes compute without round-off. */
static int at_position(const State *s, double X, double Y)
{
    for (int k = 0; k < s->n; k++)
        if (!(s->X[k][0] < X || s->X[k][0] > X || s->X[k][1] < Y || s->X[k][1] > Y)) return k;
    return -1;
}

/* A quantity's columns in the files, and where State has them. */
typedef struct Columns {
    const char *name[4];
    size_t array; /* of the pointer to the first particle's numbers in State */
    int width, at[4];
} Columns;

static const Columns quantities[] = {
    {{"x", "y"}, offsetof(State, x), 3, {0, 1}},
    {{"vx", "vy"}, offsetof(State, v), 3, {0, 1}},
    {{"Fxx", "Fxy", "Fyx", "Fyy"}, offsetof(State, F), 9, {0, 1, 3, 4}},
    {{"sxx", "syy", "sxy"}, offsetof(State, sigma), 9, {0, 4, 1}},
};

/* max |a - b| / max |b| over all stored particles and all components of one quantity, a computed
 * here, b from the file; NAN wins. Returns the number of values that were compared. */
static int distance(const State *s, const Table *t, const Columns *q, double *out)
{
    const double *numbers = *(double *const *)((const char *)s + q->array);
    double gap = 0, size = 0;
    int n = 0;
    for (int row = 0; row < t->nrow; row++) {
        const int k = at_position(s, table_number(t, row, "X"), table_number(t, row, "Y"));
        CU_ASSERT_FATAL(k >= 0);
        for (int c = 0; c < 4 && q->name[c]; c++, n++) {
            const double b = table_number(t, row, q->name[c]);
            const double off = fabs(numbers[k * q->width + q->at[c]] - b);
            gap = off <= gap ? gap : off;
            size = fmax(size, fabs(b));
        }
    }
    *out = gap / size;
    return n;
}

/* Position, velocity, and F (Matter) or Cauchy stress (NairnMPM). */
static void check_peer(const Peer *peer)
{
    char path[512];
    int compared = 0;
    snprintf(path, sizeof path, "%s/%s.csv", PEERS, peer->file);
    Table *t = table_read(path, NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    State s = advance(peer);
    CU_ASSERT(t->nrow == STORED);
    for (size_t q = 0; q < sizeof quantities / sizeof *quantities; q++) {
        double off;
        if (table_column(t, quantities[q].name[0]) < 0) continue;
        compared += distance(&s, t, &quantities[q], &off);
        CU_ASSERT(off <= 1e-13);
    }
    CU_ASSERT(compared == STORED * (t->ncol - 2)); /* all columns but X, Y */
    state_free(&s);
    table_free(t);
}

static void test_peers(void)
{
    for (size_t k = 0; k < sizeof peers / sizeof *peers; k++) check_peer(&peers[k]);
}

static const TestCase tests[] = {
    {"Matter and NairnMPM compute the same states", test_peers},
    {NULL, NULL},
};
CHECK_SUITE(tests)
