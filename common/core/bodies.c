/* bodies.c: see bodies.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "bodies.h"

/* Fields that views show; a method's own only where both bodies have the same. */
static bool is_viewed(const Bodies *b, int field)
{
    const bool same = b->sim[0]->method.own == b->sim[1]->method.own;
    return (field <= AT_VOL || (same && field >= AT_OWN)) && b->sim[0]->p.field[field];
}

/* Contact of two bodies, and room for the view of both. */
static bool join(Bodies *b)
{
    const Scene *scene = &b->scene[0];
    const size_t n = (size_t)(b->sim[0]->p.room + b->sim[1]->p.room);
    Joined *both = b->both = calloc(1, sizeof *both);
    bool ok = both && (both->id = malloc(n * sizeof(int)));
    for (int f = 0; f < FIELDS && both; f++)
        if (is_viewed(b, f)) ok = (both->field[f] = malloc(n * sizeof(double))) && ok;
    return contact_make(&b->contact, b->sim[0], b->sim[1], scene->contact, scene->friction) && ok;
}

void bodies_free(Bodies *b)
{
    for (int k = 0; k < MAX_BODIES; k++) sim_free(b->sim[k]);
    for (int f = 0; f < FIELDS && b->both; f++) free(b->both->field[f]);
    if (b->both) free(b->both->id);
    free(b->both);
    contact_free(&b->contact);
}

/* Setup of body b of two. A number of particles is divided in proportion to the bodies' lengths. */
static void set_part(Bodies *c, const Setup *whole, int b)
{
    Setup *s = &c->setup[b];
    double length[2];
    *s = *whole;
    s->scene = &c->scene[b];
    s->snapshot_nodes = true; /* contact needs the nodes' masses */
    if (b && whole->method_b) s->method = whole->method_b, s->method_par = whole->method_b_par;
    for (int k = 0; k < 2; k++) {
        c->scene[b] = *whole->scene;
        whole->scene->problem->part(&c->scene[b], k ? b : 1 - b);
        length[k] = c->scene[b].body_hi[0] - c->scene[b].body_lo[0];
    }
    s->count = (int)lround(whole->count * length[1] / (length[0] + length[1]));
}

bool bodies_make(Bodies *b, const Setup *setup, Fault *fault)
{
    b->n = setup->scene->problem->part ? 2 : 1;
    for (int k = 0; k < b->n; k++) {
        if (b->n > 1) set_part(b, setup, k);
        if (!(b->sim[k] = sim_new(b->n > 1 ? &b->setup[k] : setup, fault))) return false;
    }
    if (b->n == 1 || join(b)) return true;
    fault_set(fault, FAULT_MACHINE, "out of memory");
    return false;
}

Status bodies_step(Bodies *b, double t, double dt, bool first)
{
    int culprit = 0;
    if (b->both) b->both->fresh = false;
    if (b->n == 1) return sim_step(b->sim[0], t, dt, first);
    Status s = sim_step_bodies(b->sim, b->n, t, dt, first, contact_meet, &b->contact, &culprit);
    if (culprit > 0 && s.point >= 0) s.point += b->sim[0]->p.count;
    return s;
}

/* Copies both bodies' particles, once a step however often they are viewed. */
static const Joined *join_particles(const Bodies *b)
{
    Joined *both = b->both;
    if (both->fresh) return both;
    int n = 0;
    for (int k = 0; k < b->n; k++) {
        const Particles *p = &b->sim[k]->p;
        const size_t size = sizeof(double) * (size_t)p->n;
        for (int f = 0; f < FIELDS; f++)
            if (both->field[f]) memcpy(both->field[f] + n, p->field[f], size);
        for (int s = 0; s < p->n; s++)
            both->id[n + s] = p->id[s] < 0 ? -1 : p->id[s] + (k ? b->sim[0]->p.count : 0);
        n += p->n;
    }
    both->n = n;
    both->fresh = true;
    return both;
}

void bodies_view(const Bodies *b, Points *points, Samples *samples)
{
    const Particles *p = &b->sim[0]->p;
    const Joined *both = b->both ? join_particles(b) : NULL;
    double *const *field = both ? both->field : p->field;
    const int n = both ? both->n : p->n;
    *points = (Points){.n = n,
                       .id = both ? both->id : p->id,
                       .m = field[AT_M],
                       .V0 = field[AT_VOL],
                       .second = both ? p->count : 0};
    if (!both || b->sim[0]->method.own == b->sim[1]->method.own)
        points->own_name = b->sim[0]->method.own;
    points->own = field + AT_OWN;
    for (int d = 0; d < DIM; d++) {
        points->X[d] = field[AT_X0 + d];
        points->x[d] = field[AT_X + d];
        points->v[d] = field[AT_V + d];
    }
    *samples = (Samples){.n = n, .V0 = field[AT_VOL], .strength = field[AT_STRENGTH]};
    for (int k = 0; k < NMAT; k++) samples->F[k] = field[AT_F + k];
}

void bodies_counts(const Bodies *b, Counts *counts)
{
    double cells = 0;
    *counts = (Counts){.elements = -1, .fallbacks = -1};
    for (int k = 0; k < b->n; k++) {
        const Sim *sim = b->sim[k];
        const int own = sim->p.count - sim->surface;
        cells += own / sim->ppc;
        counts->ppc = k ? (counts->particles + own) / cells : sim->ppc;
        counts->particles += own;
        counts->surface += sim->surface;
        counts->nodes += sim->nodes;
        counts->moved |= sim->moved;
        counts->particle_bytes = fmax(counts->particle_bytes, sim_particle_bytes(sim));
        counts->node_bytes = fmax(counts->node_bytes, sim_node_bytes(sim));
        if (sim->method.assemble || sim->method.integrate)
            counts->fallbacks = (counts->fallbacks > 0 ? counts->fallbacks : 0) + sim->fallbacks;
    }
    if (counts->nodes == 0) counts->nodes = -1;
}

void bodies_stash(Bodies *b, Stash *s)
{
    for (int k = 0; k < b->n; k++) sim_stash(b->sim[k], s);
    if (b->both) b->both->fresh = false;
    STASH(s, b->contact.work);
}
