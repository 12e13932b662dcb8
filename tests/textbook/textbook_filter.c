/* textbook_filter.c: the twin's velocity filters, as their papers write them: XPIC takes the part
 * of the particles' velocities V that k rounds of V - S S+ V leave (Hammerquist & Nairn 2017), FMPM
 * adds k terms of the inverse of A = S+ S to the grid's (Nairn & Hammerquist 2021). S+ is by mass
 * and knows the walls; S is the gather. */
#include "textbook_sight.h"

static void scatter_one(Twin *w, const TwinParticle *p, bool force)
{
    Sight s[3];
    double S, G[DIM], x[DIM];
    (void)force;
    look_around(w, p, s);
    FOR_NODES(s, i)
    {
        TwinNode *node = node_of(w, s, i, &S, G, x);
        for (int d = 0; d < DIM && node; d++) node->r[d] += S * p->m * p->w[d];
    }
}

/* r = S+ w */
static void scatter(Twin *w)
{
    for (long i = 0; i < w->nodes; i++)
        for (int d = 0; d < DIM; d++) w->node[i].r[d] = 0;
    for (int k = 0; k < w->n; k++) twin_images(w, &w->p[k], scatter_one, false, 0);
    for (long i = 0; i < w->nodes; i++) {
        TwinNode *node = &w->node[i];
        const bool empty = node->m <= w->method.least * w->p[0].m;
        for (int d = 0; d < DIM; d++)
            node->r[d] = empty || node->held >> d & 1 ? 0 : node->r[d] / node->m;
    }
}

/* sum = S r */
static void gather_round(const Twin *w, const TwinParticle *p, double sum[DIM])
{
    Sight s[3];
    double S, G[DIM], x[DIM];
    for (int d = 0; d < DIM; d++) sum[d] = 0;
    look_around(w, p, s);
    FOR_NODES(s, i)
    {
        const TwinNode *node = node_of(w, s, i, &S, G, x);
        for (int d = 0; d < DIM && node; d++) sum[d] += S * node->r[d];
    }
}

void twin_filter_particles(Twin *w)
{
    double Sr[DIM];
    for (int k = 0; k < w->n; k++)
        for (int d = 0; d < DIM; d++) w->p[k].w[d] = w->p[k].v[d];
    for (int l = 0; l < w->order; l++) {
        scatter(w);
        for (int k = 0; k < w->n; k++) {
            gather_round(w, &w->p[k], Sr);
            for (int d = 0; d < DIM; d++) w->p[k].w[d] -= Sr[d];
        }
    }
}

void twin_filter_nodes(Twin *w)
{
    for (long i = 0; i < w->nodes; i++)
        for (int d = 0; d < DIM; d++) w->node[i].rest[d] = w->node[i].v[d];
    for (int l = 1; l < w->order; l++) {
        for (long i = 0; i < w->nodes; i++)
            for (int d = 0; d < DIM; d++) w->node[i].r[d] = w->node[i].rest[d];
        for (int k = 0; k < w->n; k++) gather_round(w, &w->p[k], w->p[k].w);
        scatter(w);
        for (long i = 0; i < w->nodes; i++)
            for (int d = 0; d < DIM; d++) {
                w->node[i].rest[d] -= w->node[i].r[d];
                w->node[i].v[d] += w->node[i].rest[d];
            }
    }
}
