/* contact.c: see contact.h. At a shared node with velocities v_a, v_b after their acceleration,
 * masses m_a, m_b and the unit normal n from a to b:
 *
 *   approach    (v_a - v_b) . n > 0, else the bodies are free of each other
 *   normal      P_n = -m (v_a - v_b) . n with m = m_a m_b/(m_a + m_b): both get the normal
 *               velocity of the centre of mass
 *   tangent     P_t = -m (v_a - v_b)_t, which lets them stick; no more than friction |P_n|
 *
 * Body a receives the momentum P, b receives -P. A body held by a wall has infinite mass.
 *
 *   n           difference of the mass gradients, central differences of nodal mass, which so are
 *               equal and opposite for the bodies; of a held body its own gradient (it does not
 *               move); of methods that reconstruct a surface (WLS) that surface's normal.
 *
 * Positions and strains follow the velocities after P. Particles receive of P only the share
 *
 *   seen        [(a_a - a_b) . n dt + k w] / [(v_a - v_b) . n], at least 0 and at most 1, where w
 *               is the approach before acceleration and k = min(1, c dt/(2 h)),
 *
 * so that accelerations are equal at once, and the approach that is left in particle velocities
 * decays in the time that a wave takes through two cells. With k = 1 every node that comes into
 * contact stops in one step, a plastic impact: two disks then lose up to twice the energy (H-16).
 * Where a method replaces particle velocities by the grid's (pic) they receive P at once.
 *
 * Every pass of an integrator ends in this. In the pass that accelerates (all of cd and usl) v and
 * a change, so that particles receive P. The velocities that uvf, musl and usf project without
 * acceleration are corrected in the same way for positions and F, but no particle receives momentum
 * there: contact strains the bodies without taking the work from them, and energy grows (H-16).
 * Without that correction it grows less in a short impact, but bodies at rest on each other sink
 * into one another. So Coulomb contact is valid with cd and usl alone.
 *
 * contact=none: both bodies have the v and a of their centre of mass in every pass, as if they were
 * one. */
#include <math.h>
#include <stdlib.h>
#include "contact.h"
#include "each.h"

/* A node that both bodies reach. */
typedef struct Spot {
    int row[2], index[2][DIM];
    size_t at[2];
    double mass[2];   /* [kg] */
    unsigned held[2]; /* bit a: a wall holds component a */
} Spot;

enum { WHOLE = (1 << DIM) - 1 };

bool contact_make(Contact *c, Sim *a, Sim *b, ContactLaw law, double friction)
{
    *c = (Contact){.body = {a, b}, .law = law, .friction = friction};
    c->rate =
        a->method.pic > 0 || b->method.pic > 0 ? INFINITY : 0.5 * a->setup->scene->c * a->g.cells;
    for (int d = 0; d < DIM; d++) c->shift[d] = a->g.origin[d] - b->g.origin[d];
    c->spent = calloc((size_t)a->g.rows, sizeof *c->spent);
    return c->spent != NULL;
}

void contact_free(Contact *c)
{
    free(c->spent);
}

/* Mass of node i of a row; 0 outside the live span. */
static double mass_at(const Grid *g, int row, int i)
{
    if (row < 0 || row >= g->rows || i < g->lo[row] || i >= g->hi[row]) return 0;
    return g->mass[(size_t)row * (size_t)g->n[0] + (size_t)i];
}

/* Outward normal of one body from its mass, not of unit length: -grad m times 2 h. */
static void mass_normal(const Grid *g, const Spot *s, int k, double n[DIM])
{
    const int row = s->row[k], i = s->index[k][0];
    int stride = 1;
    n[0] = mass_at(g, row, i - 1) - mass_at(g, row, i + 1);
    for (int d = 1; d < DIM; d++) {
        n[d] = mass_at(g, row - stride, i) - mass_at(g, row + stride, i);
        stride *= g->n[d];
    }
}

static double scale_to_unit(double n[DIM], double least)
{
    double square = 0;
    for (int d = 0; d < DIM; d++) square += n[d] * n[d];
    const double length = sqrt(square);
    for (int d = 0; d < DIM && length > least; d++) n[d] /= length;
    return length;
}

/* Unit normal from the first body to the second; false: none is defined. */
static bool find_normal(const Contact *c, const Spot *s, double n[DIM])
{
    double own[2][DIM];
    bool surface[2], rigid[2];
    for (int k = 0; k < 2; k++) {
        const Sim *sim = c->body[k];
        surface[k] = sim->method.normal && sim->method.normal(sim, s->at[k], own[k]);
        rigid[k] = s->held[k] == WHOLE;
        if (!surface[k]) mass_normal(&sim->g, s, k, own[k]);
    }
    bool used[2] = {true, true};
    for (int k = 0; k < 2; k++) {
        const bool better = surface[k] != surface[1 - k] ? surface[k] : rigid[k];
        if (better && !(rigid[0] && rigid[1])) used[1 - k] = false;
    }
    const double least = surface[0] || surface[1] ? 1e-6 : 1e-9 * (s->mass[0] + s->mass[1]);
    for (int d = 0; d < DIM; d++) n[d] = (used[0] ? own[0][d] : 0) - (used[1] ? own[1][d] : 0);
    return scale_to_unit(n, least) > least;
}

static double dot(const double a[DIM], const double b[DIM])
{
    double sum = 0;
    for (int d = 0; d < DIM; d++) sum += a[d] * b[d];
    return sum;
}

static void velocity_difference(const Contact *c, const Spot *s, double v[DIM])
{
    const Line a = c->body[0]->g.node[s->at[0]], b = c->body[1]->g.node[s->at[1]];
    for (int d = 0; d < DIM; d++) v[d] = a[d] - b[d];
}

/* Sets component a of a node's velocity and acceleration. */
static void set_motion(Grid *g, size_t at, int a, double v, double acc)
{
    Line *node = &g->node[at];
    (*node)[a] = v;
    (*node)[DIM + a] = acc;
    for (int b = 0; b < DIM; b++) (*node)[FLUX + b * DIM + a] = v;
}

/* Gives P to the first body's node and -P to the second's; particles receive the share `seen` of
 * it. Of held components the wall bears that share: added to `impulse`. */
static void give(Contact *c, const Spot *s, const double P[DIM], double seen, double dt,
                 double impulse[DIM])
{
    for (int k = 0; k < 2; k++)
        for (int a = 0; a < DIM; a++) {
            Grid *g = &c->body[k]->g;
            const Line node = g->node[s->at[k]];
            const double given = k ? -P[a] : P[a], dv = given / s->mass[k];
            if (s->held[k] >> a & 1)
                impulse[a] -= seen * given;
            else
                set_motion(g, s->at[k], a, node[a] + dv, node[DIM + a] + seen * dv / dt);
        }
}

/* Share of P that particles receive in this step. */
static double find_share(const Contact *c, const Spot *s, const double n[DIM], double approach,
                         double dt)
{
    const Line a = c->body[0]->g.node[s->at[0]], b = c->body[1]->g.node[s->at[1]];
    const double k = fmin(1, c->rate * dt);
    double pull = 0;
    for (int d = 0; d < DIM; d++) pull += (a[DIM + d] - b[DIM + d]) * n[d] * dt;
    return fmin(1, fmax(0, (pull + k * (approach - pull)) / approach));
}

/* Coulomb contact at one node; returns the work of friction on both bodies, P_t . (v_a - v_b) with
 * the velocities that move them [J]. */
static double collide(Contact *c, const Spot *s, double dt, double impulse[DIM])
{
    double n[DIM], v[DIM], P[DIM], square = 0, inverse = 0;
    velocity_difference(c, s, v);
    if (!find_normal(c, s, n)) return 0;
    const double approach = dot(v, n);
    for (int k = 0; k < 2; k++) inverse += s->held[k] == WHOLE ? 0 : 1 / s->mass[k];
    if (!(approach > 0) || !(inverse > 0)) return 0;
    for (int d = 0; d < DIM; d++) {
        v[d] -= approach * n[d];
        square += v[d] * v[d];
    }
    const double slip = sqrt(square), bound = c->friction * approach;
    const double share = slip > bound ? bound / slip : 1; /* 1: they stick */
    for (int d = 0; d < DIM; d++)
        P[d] = -(approach * n[d] + (slip > 0 ? share * v[d] : 0)) / inverse;
    const double seen = find_share(c, s, n, approach, dt);
    give(c, s, P, seen, dt, impulse);
    return -seen * share * (1 - share) * square / inverse;
}

/* One velocity and acceleration for both bodies; 0 where a wall holds one of them, which then bears
 * what the particles of the other lose. */
static void merge(Contact *c, const Spot *s, double dt, double impulse[DIM])
{
    const double whole = s->mass[0] + s->mass[1];
    for (int a = 0; a < DIM; a++) {
        const bool held = (s->held[0] | s->held[1]) >> a & 1;
        double v = 0, acc = 0;
        for (int k = 0; k < 2 && !held; k++) {
            const Line node = c->body[k]->g.node[s->at[k]];
            v += s->mass[k] / whole * node[a];
            acc += s->mass[k] / whole * node[DIM + a];
        }
        for (int k = 0; k < 2; k++) {
            Grid *g = &c->body[k]->g;
            const Line node = g->node[s->at[k]];
            const double pic = c->body[k]->method.pic;
            if (held) impulse[a] -= s->mass[k] * (dt * (1 - pic) * node[DIM + a] + pic * node[a]);
            set_motion(g, s->at[k], a, v, acc);
        }
    }
}

static unsigned held_at(const Grid *g, const int index[DIM])
{
    unsigned held = 0;
    for (int d = 0; d < DIM; d++) held |= g->hold[d][index[d]];
    return held;
}

/* Row of the second grid that lies on a row of the first, or -1; their indices beyond the first
 * axis. */
static int row_of_second(const Contact *c, Spot *s)
{
    const Grid *a = &c->body[0]->g, *b = &c->body[1]->g;
    int rest = s->row[0], row = 0, stride = 1;
    for (int d = 1; d < DIM; d++) {
        s->index[0][d] = rest % a->n[d];
        rest /= a->n[d];
        s->index[1][d] = s->index[0][d] + c->shift[d];
        if (s->index[1][d] < 0 || s->index[1][d] >= b->n[d]) return -1;
        row += stride * s->index[1][d];
        stride *= b->n[d];
    }
    return row;
}

typedef struct Meeting {
    Contact *contact;
    double dt;
    bool force;
} Meeting;

static void meet_row(Sim *sim, int row, const void *own)
{
    const Meeting *m = own;
    Contact *c = m->contact;
    Grid *g[2] = {&sim->g, &c->body[1]->g};
    Spot s = {.row = {row}};
    Vec impulse = {0};
    c->spent[row] = 0;
    for (int a = 0; a < DIM; a++) g[0]->impulse[row][a] = 0;
    if ((s.row[1] = row_of_second(c, &s)) < 0) return;
    if (g[1]->lo[s.row[1]] >= g[1]->hi[s.row[1]]) return; /* an empty span has no place to shift */
    const int lo = g[1]->lo[s.row[1]] - c->shift[0], hi = g[1]->hi[s.row[1]] - c->shift[0];
    for (int i = g[0]->lo[row] > lo ? g[0]->lo[row] : lo; i < g[0]->hi[row] && i < hi; i++) {
        for (int k = 0; k < 2; k++) {
            s.index[k][0] = i + (k ? c->shift[0] : 0);
            s.at[k] = (size_t)s.row[k] * (size_t)g[k]->n[0] + (size_t)s.index[k][0];
            s.mass[k] = g[k]->mass[s.at[k]];
            s.held[k] = held_at(g[k], s.index[k]);
        }
        if (!(s.mass[0] > 0 && s.mass[1] > 0)) continue;
        if (c->law == CONTACT_NONE)
            merge(c, &s, m->dt, impulse);
        else
            c->spent[row] += collide(c, &s, m->dt, impulse);
    }
    for (int a = 0; a < DIM && m->force; a++) g[0]->impulse[row][a] = impulse[a];
}

void contact_meet(void *own, double dt, bool force)
{
    Contact *c = own;
    Sim *sim = c->body[0];
    const Grid *g = &sim->g;
    each_row(sim, meet_row, &(Meeting){c, dt, force});
    for (int row = 0; row < g->rows && force; row++) {
        if (g->lo[row] >= g->hi[row]) continue;
        for (int a = 0; a < DIM; a++) sim->impulse[a] += g->impulse[row][a];
        c->work += c->spent[row];
    }
}
