/* test_memory.c: a method takes the memory that `describe` and the rows say: bytes per grid node,
 * from two runs of one body on a small and on a large grid. */
#include <malloc.h>
#include "tests/fixture.h"

static double bytes_in_use(void)
{
    const struct mallinfo2 all = mallinfo2();
    return (double)all.uordblks + (double)all.hblkhd;
}

/* Memory [bytes] of a sim of a block in a box, and how many nodes its grid has. */
static double bytes_of(const char *method, const char *box, double *nodes, double *said)
{
    const Case block = {DIM, "block", DIM == 3 ? 6 : 24, 0, 0, box};
    Fixture r;
    CU_ASSERT_FATAL(fixture_plan(&r, &block, method, CD, "allow_unstable=1"));
    const double before = bytes_in_use(); /* 0 under sanitizers: they have a heap of their own */
    Sim *sim = fixture_sim(&r);
    const double taken = bytes_in_use() - before;
    *nodes = (double)sim->g.rows * sim->g.n[0];
    *said = sim_node_bytes(sim);
    sim_free(sim);
    return taken;
}

static void test_nodes(void)
{
    FOR_METHODS(m)
    {
        double few, many, said;
        const double small = bytes_of((*m)->info.name, DIM == 3 ? "box=2" : "box=8", &few, &said);
        const double large = bytes_of((*m)->info.name, DIM == 3 ? "box=8" : "box=20", &many, &said);
        if (large > 0) CHECK_CLOSE((large - small) / (many - few) / said, 1, 0.04);
    }
}

static const TestCase tests[] = {
    {"bytes per node", test_nodes},
    {NULL, NULL},
};
CHECK_SUITE(tests)
