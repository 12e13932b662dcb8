/* textbook_modes.h: modes of a particle up to degree 2 (Fu et al. 2017), by the method of Gram and
 * Schmidt on the nodes that it sees along each axis. */
#ifndef MPMLAB_TEXTBOOK_MODES_H
#define MPMLAB_TEXTBOOK_MODES_H

#include "textbook_sight.h"

/* By axis, degree and node; and sum_k S P^2. */
typedef struct TwinModes {
    double P[3][3][REACH], norm[3][3];
} TwinModes;

#define FOR_DEGREES(e)                                                                             \
    for (int e[3] = {0}; e[2] < (DIM > 2 ? 3 : 1); e[2]++)                                         \
        for (e[1] = 0; e[1] < (DIM > 1 ? 3 : 1); e[1]++)                                           \
            for (e[0] = 0; e[0] < 3; e[0]++)                                                       \
                if (e[0] + e[1] + e[2] == 1 || e[0] + e[1] + e[2] == 2)

static inline double twin_inner(const Sight *s, const double f[], const double g[])
{
    double sum = 0;
    for (int k = 0; k < s->count; k++) sum += s->S[k] * f[k] * g[k];
    return sum;
}

static inline void find_modes(const Twin *w, const TwinParticle *p, const Sight s[3], TwinModes *m)
{
    *m = (TwinModes){0};
    for (int d = 0; d < 3; d++)
        for (int degree = 0; degree < (d < DIM ? 3 : 1); degree++) {
            double *P = m->P[d][degree];
            for (int k = 0; k < s[d].count; k++)
                P[k] = degree ? pow(s[d].first + k - place(w, p, d) / w->h, degree) : 1;
            for (int less = 0; less < degree; less++) {
                const double *Q = m->P[d][less], norm = m->norm[d][less];
                const double share = norm > 1e-9 ? twin_inner(&s[d], P, Q) / norm : 0;
                for (int k = 0; k < s[d].count; k++) P[k] -= share * Q[k];
            }
            m->norm[d][degree] = twin_inner(&s[d], P, P);
        }
}

/* Component a of the mode of these degrees [m/s]; a slope is kept as L [1/s]. */
static inline double *twin_mode(TwinParticle *p, const int e[3], int a)
{
    for (int d = 0; d < DIM && e[0] + e[1] + e[2] == 1; d++)
        if (e[d]) return &p->L[a][d];
    return &p->more->mode[e[0]][e[1]][e[2]][a];
}

/* What the modes add to v_a at node i. */
static inline double mode_velocity(const Twin *w, const TwinParticle *p, const TwinModes *m,
                                   const int i[3], int a)
{
    TwinParticle q = *p;
    double v = 0;
    FOR_DEGREES(e)
    {
        const double unit = e[0] + e[1] + e[2] == 1 ? w->h : 1;
        v += *twin_mode(&q, e, a) * unit * m->P[0][e[0]][i[0]] * m->P[1][e[1]][i[1]] *
             m->P[2][e[2]][i[2]];
    }
    return v;
}

/* Modes of the velocities of the nodes. */
static inline void take_twin_modes(const Twin *w, TwinParticle *p, const Sight s[3],
                                   const TwinModes *m)
{
    FOR_DEGREES(e)
    for (int a = 0; a < DIM; a++) {
        const double unit = e[0] + e[1] + e[2] == 1 ? w->h : 1;
        double sum = 0, norm = 1;
        bool none = false;
        for (int d = 0; d < 3; d++) norm *= m->norm[d][e[d]], none |= m->norm[d][e[d]] < 1e-9;
        FOR_NODES(s, i)
        {
            const TwinNode *node = node_at(w, s, i);
            double S = 1;
            for (int d = 0; d < 3; d++) S *= s[d].S[i[d]] * m->P[d][e[d]][i[d]];
            if (node) sum += S * node->v[a];
        }
        *twin_mode(p, e, a) = none ? 0 : sum / norm / unit;
    }
}

/* What a particle behind a symmetry line keeps: `to`. */
static inline TwinMore *mirror_more(const TwinMore *from, const Wall *wall, TwinMore *to)
{
    const int n = wall->axis;
    *to = *from;
    for (int c = 0; c < TWIN_CORNERS; c++) to->corner[c][n] = 2 * wall->at - from->corner[c][n];
    FOR_DEGREES(e)
    for (int a = 0; a < DIM; a++)
        if (((e[n] == 1) != (a == n)) && e[0] + e[1] + e[2] == 2)
            to->mode[e[0]][e[1]][e[2]][a] *= -1;
    return to;
}

#endif
