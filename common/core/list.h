/* list.h: deposit and gather with general weights: a list of nodes per particle (NodeList), for
 * methods whose weights are not products over the axes. Lanes and sums are those of scheme.h. */
#ifndef MPMLAB_LIST_H
#define MPMLAB_LIST_H

#include "scheme.h"

static inline void make_list(const Sim *sim, const Chunk *c, Work *w)
{
    const Place place = sim_place(sim);
    const Chunk at = sim_weight_chunk(sim, c);
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < CHUNK; p++) w->x[d][p] = at.x[d][p] * place.cells - place.origin[d];
    w->on_node = false;
    sim->method.list(&at, &place, (const Field *)w->x, &w->list);
}

/* 1 in the lanes of S alone, and in the lanes of the flux through each axis. */
typedef struct ListLanes {
    Line S, G[DIM];
} ListLanes;

static inline ListLanes list_lanes(void)
{
    const Pattern q = flux_pattern(T_G);
    ListLanes out = {.S = q.e[0][T_S]};
    for (int d = 1; d < DIM; d++) out.S *= q.e[d][T_S];
    for (int d = 0; d < DIM; d++) out.G[d] = q.e[d][T_G];
    return out;
}

/* Lanes of weights of part c. */
static inline __attribute__((always_inline)) Line list_weight(const NodeList *list, int c, int p,
                                                              const ListLanes *one)
{
    Line w = list->S[c][p] * one->S;
    for (int d = 0; d < DIM; d++) w += list->G[d][c][p] * one->G[d];
    return w;
}

/* m v of part c in the lanes of momentum, v beyond the particle's. */
static inline __attribute__((always_inline)) Line part_momentum(const Work *w, int c, int p)
{
    Line mv = {0};
    for (int a = 0; a < DIM; a++) mv[1 + a] = w->A[p][0] * w->list.v[a][c][p];
    return mv;
}

/* `part` and `modes` are constants in each instance. */
static inline __attribute__((always_inline)) void deposit_parts(Grid *g, const Work *w,
                                                                const int part, const bool modes)
{
    const ListLanes one = list_lanes();
    const NodeList *list = &w->list;
    for (int p = 0; p < CHUNK; p++)
        for (int c = 0; c < list->points; c++) {
            const Line A = modes ? w->A[p] + part_momentum(w, c, p) : w->A[p];
            const Line value = list_weight(list, c, p, &one) * A;
            for (int k = c * part; k < (c + 1) * part; k++)
                g->node[list->at[k][p]] += list->N[k][p] * value;
        }
}

/* Gathers with general weights; own[c DIM + a], if own is not NULL: v_a of part c, for methods that
 * move points of their own. */
static inline __attribute__((always_inline)) void gather_parts(const Grid *g, Work *w, Field own[],
                                                               const int part)
{
    const ListLanes one = list_lanes();
    const NodeList *list = &w->list;
    for (int p = 0; p < CHUNK; p++) {
        Line sum = {0};
        for (int c = 0; c < list->points; c++) {
            Line at = {0};
            for (int k = c * part; k < (c + 1) * part; k++)
                at += list->N[k][p] * g->node[list->at[k][p]];
            sum += list_weight(list, c, p, &one) * at;
            for (int a = 0; own && a < DIM; a++) own[c * DIM + a][p] = at[a];
        }
        w->A[p] = sum;
    }
}

enum { USUAL_PART = 1 << DIM }; /* the corners of a cell */

/* Always inlined: gcc 12 with -O1 believes that gather_list changes nothing, and drops its call. */
static inline __attribute__((always_inline)) void deposit_list(Grid *g, const Work *w,
                                                               const bool modes)
{
    if (modes)
        deposit_parts(g, w, w->list.part, true);
    else if (w->list.part == USUAL_PART)
        deposit_parts(g, w, USUAL_PART, false);
    else
        deposit_parts(g, w, w->list.part, false);
}

static inline __attribute__((always_inline)) void gather_list(const Grid *g, Work *w)
{
    if (w->list.part == USUAL_PART)
        gather_parts(g, w, NULL, USUAL_PART);
    else
        gather_parts(g, w, NULL, w->list.part);
}

/* Gathers also the velocities of a particle's parts. On the reference grid points do not move: they
 * are 0, except of modes. */
static inline void gather_list_and_points(const Sim *sim, Work *w)
{
    const int points = sim->method.points;
    const bool still = sim->total && !sim->method.modes;
    Field *own = w->sums + POINT_SUMS;
    if (!points || still)
        gather_list(&sim->g, w);
    else
        gather_parts(&sim->g, w, own, w->list.part);
    for (int k = 0; still && k < points * DIM; k++)
        for (int p = 0; p < CHUNK; p++) own[k][p] = 0;
}

static inline __attribute__((always_inline)) void deposit_force_list(Grid *g, const Work *w)
{
    const NodeList *list = &w->list;
    for (int p = 0; p < CHUNK; p++)
        for (int k = 0; k < list->points * list->part; k++)
            for (int a = 0; a < DIM; a++)
                g->force[list->at[k][p] * DIM + a] +=
                    list->S[k / list->part][p] * list->N[k][p] * w->body[a][p];
}

/* D = sum_i S (x_i - x_p)^2 [m^2] along an axis. */
static inline void list_spread(const Sim *sim, const Work *w, int axis, Field D)
{
    const Place place = sim_place(sim);
    const NodeList *list = &w->list;
    for (int p = 0; p < CHUNK; p++) {
        D[p] = 0;
        for (int k = 0; k < list->points * list->part; k++) {
            const long long index = list->at[k][p] / place.stride[axis] % sim->g.n[axis];
            const double r = ((double)index - w->x[axis][p]) * sim->dx;
            D[p] += list->S[k / list->part][p] * list->N[k][p] * r * r;
        }
    }
}

#endif
