/* wave.h: a plane wave of wave number k_wave [1/cell] in the middle of a block of GE-WLS. */
#ifndef MPMLAB_WAVE_H
#define MPMLAB_WAVE_H

#include "tests/fixture.h"

enum { CELLS = 16 };
static const double k_wave = 2 * M_PI / 128; /* [1/cell] */
static const double epsilon = 3e-7;          /* amplitude of the strain */
static const double dx = 1.0 / (double)CELLS;

/* The block in the middle of its box, its lattice on the grid lines. */
static inline Sim *block_open(Fixture *r, const char *more)
{
    const Case block = {.dim = DIM, .problem = "block", .cells = CELLS};
    char set[256];
    snprintf(set, sizeof set, "dim=%d;layout=radial;%s", DIM, more);
    CU_ASSERT_FATAL(fixture_plan(r, &block, "ge_wls", CD, set));
    Sim *sim = fixture_sim(r);
    sim_sort(sim);
    return sim;
}

static inline double middle(const Sim *sim)
{
    return 0.5 * (sim->setup->scene->lo[0] + sim->setup->scene->hi[0]);
}

static inline size_t middle_node(const Sim *sim)
{
    const Grid *g = &sim->g;
    size_t at = 0;
    for (int d = DIM - 1; d >= 0; d--)
        at = at * (size_t)g->n[d] + (size_t)(lround(middle(sim) * (double)CELLS) - g->origin[d]);
    return at;
}

static inline double coefficient(double ratio)
{
    return (1 - ratio) / (k_wave * k_wave);
}

/* Within 1 % of what was derived; where that is 0, of the smallest that is not, 1/24. */
static inline void check_coefficient(double ratio, double derived)
{
    const double most = derived == 0 ? 1.0 / 24 : fabs(derived);
    CHECK_CLOSE(coefficient(ratio), derived, 0.01 * most);
}

#endif
