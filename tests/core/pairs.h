/* pairs.h: the free block in every dimension, and a check of every method in it. */
#ifndef MPMLAB_TESTS_PAIRS_H
#define MPMLAB_TESTS_PAIRS_H

#include "tests/fixture.h"

/* By dimension; several blocks of rows, half-filled chunks. */
static const Case blocks[] = {{1, "free_block", 200, 2, 0, NULL},
                              {2, "free_block", 20, 4, 0, NULL},
                              {3, "free_block", 14, 1, 0, "box=1.2857142857142858"}};

/* Their edges midway between nodes. */
static const Case between[] = {{1, "free_block", 200, 2, 0, "box=1.505"},
                               {2, "free_block", 20, 4, 0, "box=1.55"},
                               {3, "free_block", 6, 8, 0, "box=1.5"}};

/* Particles on nodes: a third of them along an axis; all, edges and corners included. */
static const Case on_nodes[][2] = {
    {{1, "free_block", 200, 3, 0.1, "box=1.505"}, {1, "free_block", 200, 1, 0.1, "box=1.505"}},
    {{2, "free_block", 20, 9, 0.1, "box=1.55"}, {2, "free_block", 20, 1, 0.1, "box=1.55"}},
    {{3, "free_block", 5, 27, 0.1, "box=1.6"},
     {3, "free_block", 12, 1, 0.1, "box=1.4166666666666667"}}};

/* Steps of the tests that compare thread counts (test_invariants.c) and that fill unused memory
 * with NaN (test_unread.c). */
enum { FEW = IN_THIS_DIM(10, 10, 3) };

typedef void Check(Fixture *r);

/* Runs a check over every pair, with and without refresh where it matters; variants with one pass
 * and two; in 3D, where it takes long, all with the first integrator alone: steps and loops are the
 * same source. */
static inline void for_cases(const Case *scene, Check *check)
{
    char set[VARIANT_TEXT];
    FOR_METHODS(m) for (int k = 0; k < VARIANTS; k++) FOR_INTEGRATORS(i) for (int f = 0; f < 2; f++)
    {
        Fixture r;
        if ((f && i != UVF && i != MUSL) || (DIM > 2 && i != CD) || (k && i > UVF)) continue;
        if (!fixture_variant(*m, k, f ? "allow_unstable=1;refresh=1" : "allow_unstable=1", set))
            continue;
        CU_ASSERT_FATAL(fixture_plan(&r, scene, (*m)->info.name, i, set));
        check(&r);
    }
}

/* The same on the reference grid, with one integrator of two projections. */
static inline void for_total(const Case *scene, Check *check)
{
    FOR_METHODS(m)
    {
        Fixture r;
        if ((*m)->assemble || (*m)->integrate) continue;
        CU_ASSERT_FATAL(
            fixture_plan(&r, scene, (*m)->info.name, UVF, "allow_unstable=1;frame=total"));
        check(&r);
    }
}

static inline void for_pairs(Check *check)
{
    for_cases(&blocks[DIM - 1], check);
}

/* A free block whose result must keep its bits in a box twice as wide on the same grid lines. */
static const Case apart = {3, "free_block", 8, 1, 0, "box=2"};

/* The free block with enough particles for methods that integrate over cells. */
static inline const Case *full(void)
{
    return DIM < 3 ? &blocks[DIM - 1] : &between[DIM - 1];
}

#endif
