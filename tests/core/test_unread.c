/* test_unread.c: what must never be read: nodes outside the spans, the motion of padding. */
#include <stdlib.h>
#include <string.h>
#include "pairs.h"

static void poison(Sim *sim)
{
    const Particles *p = &sim->p;
    const Grid *g = &sim->g;
    double *lane = (double *)g->node;
    for (size_t i = 0; i < (size_t)g->rows * (size_t)g->n[0] * LANES; i++) lane[i] = NAN;
    for (int s = 0; s < p->n; s++) {
        if (p->id[s] >= 0) continue;
        CU_ASSERT(!(p->field[AT_M][s] > 0) && !(p->field[AT_VOL][s] > 0));
        for (int d = 0; d < DIM; d++) p->field[AT_V + d][s] = 1e6;
    }
}

static void check_poison(Fixture *r)
{
    Sim *clean = fixture_sim(r), *dirty = fixture_sim(r);
    sim_sort(dirty); /* so that there is padding */
    CU_ASSERT(dirty->p.n > dirty->p.count);
    for (int k = 0; k < FEW; k++) {
        poison(dirty);
        CU_ASSERT_FATAL(fixture_steps(r, clean, k, k + 1) && fixture_steps(r, dirty, k, k + 1));
    }
    double *a = fixture_state(clean), *b = fixture_state(dirty);
    CU_ASSERT(memcmp(a, b, sizeof(double) * FIELDS * (size_t)clean->p.count) == 0);
    free(a), free(b), sim_free(clean), sim_free(dirty);
}

static void test_poison(void)
{
    for_pairs(check_poison), for_total(&blocks[DIM - 1], check_poison);
    for_cases(&on_nodes[DIM - 1][0], check_poison);
}

/* Stencils wider than three nodes, and a block so fast that it drifts a cell between two sorts. */
static void test_poison_wide(void)
{
    const Case wide[] = {{1, "free_block", 100, 0.7, 0, "drift=6;box=2"},
                         {2, "free_block", 12, 1, 0, "drift=4;swing=3;box=2"},
                         {3, "free_block", 6, 1, 0, "drift=4;swing=3;box=2"}};
    FOR_METHODS(m)
    {
        Fixture r;
        CU_ASSERT_FATAL(fixture_plan(&r, &wide[DIM - 1], (*m)->info.name, UVF, "allow_unstable=1"));
        check_poison(&r);
    }
}

static const TestCase tests[] = {
    {"unused nodes and padding are never read", test_poison},
    {"nor with wide stencils", test_poison_wide},
    {NULL, NULL},
};
CHECK_SUITE(tests)
