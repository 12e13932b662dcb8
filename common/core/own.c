/* own.c: fields of a method's own, and the widest half width at the start (sim.h). */
#include <math.h>
#include "sim.h"
#include "stretch.h"

Place sim_place(const Sim *sim)
{
    const Grid *g = &sim->g;
    Place place = {.cells = g->cells, .axis = g->axis, .half = sim->half, .reach = sim->half_max};
    for (int d = 0; d < DIM; d++) {
        place.origin[d] = g->origin[d];
        place.stride[d] = d == 0 ? 1 : place.stride[d > 0 ? d - 1 : 0] * g->n[d > 0 ? d - 1 : 0];
    }
    return place;
}

#define EIGHT(x) x, x, x, x, x, x, x, x
#define ALL(x)                                                                                     \
    {                                                                                              \
        EIGHT(x), EIGHT(x), EIGHT(x), EIGHT(x), EIGHT(x), EIGHT(x), EIGHT(x), EIGHT(x)             \
    }
static const Field none = ALL(0), one = ALL(1);

Chunk sim_weight_chunk(const Sim *sim, const Chunk *c)
{
    Chunk out = *c;
    if (!sim->total) return out;
    for (int d = 0; d < DIM; d++) out.x[d] = (double *)c->X[d];
    for (int k = 0; k < NMAT; k++) out.F[k] = (double *)(k % (DIM + 1) == 0 ? one : none);
    return out;
}

/* Widest half width now [cells]. (gcc 12 for arm64 fails at -O3 with `half` inside the loop.) */
static double widest_box(const Sim *sim)
{
    double most = 0;
    for (int d = 0; d < DIM; d++)
        for (int s = 0; s < sim->p.n; s++)
            most = fmax(most, domain_stretch(sim->domain, sim->p.field + AT_F, d, s));
    return sim->half * most;
}

/* The last chunk is filled up with copies of the last particle. */
static void fill_last(Particles *p)
{
    for (int f = 0; f < FIELDS; f++)
        for (int s = p->n; p->field[f] && s % CHUNK; s++) p->field[f][s] = p->field[f][p->n - 1];
}

void sim_start_own(Sim *sim)
{
    const Method *method = &sim->method;
    const Place place = sim_place(sim);
    double most = widest_box(sim);
    if (sim->p.n > 0) fill_last(&sim->p);
    for (int k = 0; k * CHUNK < sim->p.n; k++) {
        const Chunk now = sim_chunk(sim, k), c = sim_weight_chunk(sim, &now);
        Field reach = {0};
        if (method->start) method->start(&c, &place);
        if (method->list) method->reach(&c, &place, reach);
        for (int p = 0; p < CHUNK; p++) most = fmax(most, reach[p]);
    }
    sim->half_now = fmin(most, sim->half_max);
}

int sim_own_count(const Method *method)
{
    int n = 0;
    while (method->own && method->own[n]) n++;
    return n;
}

void sim_refer_gradient(Particles *p)
{
    double *const *L = p->field + AT_L, *const *F = p->field + AT_F;
    for (int s = 0; s < p->n; s++)
        for (int a = 0; a < DIM; a++) {
            double row[DIM] = {0};
            for (int k = 0; k < NMAT; k++) row[k % DIM] += L[a * DIM + k / DIM][s] * F[k][s];
            for (int b = 0; b < DIM; b++) L[a * DIM + b][s] = row[b];
        }
}
