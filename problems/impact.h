/* impact.h: what disk_impact (W11 5.2) and ball_impact share: a soft round body slides into the
 * corner of a box with frictionless walls.
 *
 * The body flies freely until it meets the floor y = 0 at t ~ .5, rebounds with vy reversed while
 * vx stays, and meets the wall x = 1 at t ~ 2.5. Walls: v_n = a_n = 0 on their nodes and beyond,
 * always (bilateral) or only while the body pushes (unilateral). There is no exact solution: energy
 * and momentum are judged. */
#ifndef MPMLAB_IMPACT_H
#define MPMLAB_IMPACT_H

#include <math.h>
#include "common/contract/problem.h"

enum { IMPACT_WALL };

static const double impact_radius = 0.2, impact_start = 0.3, impact_speed = 0.2; /* [m] [m] [m/s] */

static const Param impact_params[] = {{"wall", 0, 0, 1, "",
                                       "holds always, or only while the body pushes against it",
                                       "W11 5.2", "bilateral|unilateral"},
                                      {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

/* A body of this kind at (.3, .3[, .3]) m in the unit box. */
static inline void impact_init(Scene *s, Body body)
{
    s->mat = material_make(NEO_HOOKEAN, 1000, 0.3, 1000);
    s->c = material_wave_speed_bound(&s->mat);
    s->t_end = 3;
    s->error_scale = 1;
    s->body = body;
    s->body.outer = impact_radius;
    for (int d = 0; d < DIM; d++) {
        s->body.centre[d] = impact_start;
        s->hi[d] = 1;
        s->body_lo[d] = impact_start - impact_radius;
        s->body_hi[d] = impact_start + impact_radius;
        for (int side = -1; side <= 1; side += 2)
            s->wall[s->nwall++] = (Wall){.axis = d,
                                         .side = side,
                                         .at = side < 0 ? 0 : 1,
                                         .hold = 1u << d,
                                         .unilateral = s->par[IMPACT_WALL] > 0};
    }
}

static inline bool impact_inside(const Scene *s, const Vec X)
{
    double square = 0;
    for (int d = 0; d < DIM; d++) square += pow(X[d] - s->body.centre[d], 2);
    return square <= impact_radius * impact_radius;
}

static inline void impact_begin(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F,
                                Fields L)
{
    (void)s, (void)X, (void)u, (void)F, (void)L;
    for (int p = 0; p < n; p++) {
        v[0][p] = impact_speed;
        v[1][p] = -impact_speed;
    }
}

#endif
