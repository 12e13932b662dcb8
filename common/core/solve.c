/* solve.c: the nodes' equations of motion (passes.h): W11 eqs 25, 26 with walls. */
#include "passes.h"
#include "each.h"

/* What all nodes of a pass share. `early`: internal forces enter the ledger as deposited, before
 * symmetry or a repair changes them, because over all nodes they sum to zero. (A repair records
 * what it adds at nodes that no wall holds: wls.h.) */
typedef struct Motion {
    double dt, scale; /* [s]; accelerations are multiplied by scale */
    bool force, early;
    Given given;
} Motion;

/* Subtracts the internal force on the real particles' nodes, and the momentum to be replaced. */
static void record_forces(Sim *sim, int row, const void *motion)
{
    const Motion *m = motion;
    Grid *g = &sim->g;
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const Line n = g->node[(size_t)row * (size_t)g->n[0] + (size_t)i];
        for (int l = FLUX; l < LANES; l++)
            g->impulse[row][(l - FLUX) % DIM] -= m->dt * m->scale * n[l];
        for (int a = 0; a < DIM; a++) g->impulse[row][a] -= m->given.v_share * n[1 + a];
    }
}

/* Adds the momentum that the body forces on all nodes give: before symmetry folds them. */
static void record_outside(Sim *sim, double dt)
{
    const Grid *g = &sim->g;
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++)
            for (int a = 0; a < DIM; a++)
                sim->outside[a] +=
                    dt * g->force[((size_t)row * (size_t)g->n[0] + (size_t)i) * DIM + (size_t)a];
}

static unsigned row_hold(const Grid *g, int row)
{
    unsigned held = 0;
    for (int d = 1; d < DIM; d++) {
        held |= g->hold[d][row % g->n[d]];
        row /= g->n[d];
    }
    return held;
}

/* Velocity that moving walls give to what they hold of a node. */
static void row_drive(const Grid *g, int row, Vec drive)
{
    drive[0] = 0;
    for (int d = 1; d < DIM; row /= g->n[d++])
        drive[d] = g->drive[d] ? g->drive[d][row % g->n[d]] : 0;
}

/* Work of moving walls over a step: minus the deposited force on the components that they hold,
 * times the distance that the wall moves. */
static void record_wall_work(Sim *sim, int row, const void *motion)
{
    const double dt = ((const Motion *)motion)->dt;
    Grid *g = &sim->g;
    Vec drive;
    row_drive(g, row, drive);
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
        const unsigned held = row_hold(g, row) | g->hold[0][i];
        drive[0] = g->drive[0][i];
        for (int a = 0; a < DIM; a++) {
            double f = g->force ? g->force[at * DIM + (size_t)a] : 0;
            for (int b = 0; b < DIM; b++) f += g->node[at][FLUX + b * DIM + a];
            if (held >> a & 1) g->work[row] -= f * drive[a] * dt;
        }
    }
}

/* Components that unilateral walls hold at a node: those of the walls into which the free momentum
 * p + f dt is directed. Otherwise the node is free, so that the body can leave the wall. */
unsigned sim_stops(const Grid *g, int row, int i, double dt)
{
    const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
    const Line n = g->node[at];
    unsigned held = 0;
    for (int k = 0; k < g->nstop; k++) {
        const Stop *s = &g->stop[k];
        int index = i, rest = row;
        for (int d = 1; d < DIM && d <= s->axis; d++) {
            index = rest % g->n[d];
            rest /= g->n[d];
        }
        if (s->side * (index - s->at) < 0) continue;
        double f = g->force ? g->force[at * DIM + (size_t)s->axis] : 0;
        for (int b = 0; b < DIM; b++) f += n[FLUX + b * DIM + s->axis];
        if (s->side * (n[1 + s->axis] + f * dt) > 0) held |= s->hold;
    }
    return held;
}

/* One node: v = p/m, a = f/m times `scale`, walls, v += a dt; then what a gather reads. Held
 * components get a = 0 and the wall's own v, `drive`, except `stopped` ones (unilateral walls),
 * whose a = -v/dt stops the particles themselves, so that they can leave again. Adds to `impulse`
 * the momentum that this node gives to particles, m (dt (1 - pic) a + pic v), minus what they lose
 * to it, pic p, and minus the internal force. `force`: the node's body force, or NULL. */
static inline __attribute__((always_inline)) void solve_node(Line *node, const double *force,
                                                             const Motion *m, unsigned held,
                                                             unsigned stopped, const Vec drive,
                                                             double impulse[DIM])
{
    const double dt = m->dt, scale = m->scale;
    const Line in = *node;
    const double inverse = 1 / in[0];
    Line out = {0};
    for (int a = 0; a < DIM; a++) {
        double f = 0;
        for (int b = 0; b < DIM; b++) f += in[FLUX + b * DIM + a];
        if (!m->early) impulse[a] -= dt * scale * f + m->given.v_share * in[1 + a];
        if (force) f += force[a];
        const bool hold = held >> a & 1;
        double acc = hold ? 0 : f * inverse * scale;
        if (stopped >> a & 1) acc = -in[1 + a] * inverse / dt;
        const double v = hold ? drive[a] : in[1 + a] * inverse + acc * dt;
        impulse[a] += m->given.a_share * in[1 + DIM] * acc;
        impulse[a] += m->given.v_share * in[1 + DIM] * v;
        out[a] = v;
        out[DIM + a] = acc;
        for (int b = 0; b < DIM; b++) out[FLUX + b * DIM + a] = v;
    }
    *node = out;
}

/* A node without mass has no motion. The force on it acts on the wall if one holds it. */
static inline void clear_node(Grid *g, const Motion *m, size_t at, unsigned held,
                              double impulse[DIM])
{
    const Line in = g->node[at];
    for (int l = FLUX; l < LANES && !m->early; l++)
        if (held >> (l - FLUX) % DIM & 1) impulse[(l - FLUX) % DIM] -= m->dt * m->scale * in[l];
    g->node[at] = (Line){0};
}

/* Nodes of a row, *lo up to *hi, without ghosts beyond symmetry lines: mirror_unfold fills them. */
static void row_span(const Grid *g, int row, int *lo, int *hi)
{
    *lo = g->lo[row], *hi = g->hi[row];
    for (int k = 0; k < g->nmirror; k++) {
        const Mirror *m = &g->mirror[k];
        if (m->axis == 0 && m->side < 0 && *lo < m->at) *lo = m->at;
        if (m->axis == 0 && m->side > 0 && *hi > m->at + 1) *hi = m->at + 1;
    }
}

/* Solves a row without held nodes, if the run has no unilateral wall, symmetry line, body force,
 * repair of velocities (WLS) or record of nodal masses. Returns false, and changes nothing, where
 * there is any of these. */
static bool solve_free_row(Sim *sim, const Motion *motion, int row)
{
    Grid *g = &sim->g;
    Motion own = *motion;
    Line *node = g->node + (size_t)row * (size_t)g->n[0];
    double impulse[DIM] = {0};
    int live = 0;
    if (g->force || g->mass || g->nstop || motion->early || row_hold(g, row)) return false;
    for (int i = g->lo[row]; i < g->hi[row]; i++)
        if (g->hold[0][i]) return false;
    own.early = false; /* so that the compiler drops its branch */
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const bool empty = node[i][0] <= sim->mass_cut; /* false for NaN, which must spread */
        live += !empty;
        if (empty)
            node[i] = g->zero;
        else
            solve_node(&node[i], NULL, &own, 0, 0, NULL, impulse);
    }
    for (int a = 0; a < DIM; a++) g->impulse[row][a] = impulse[a];
    g->live[row] = live;
    return true;
}

static void solve_row(Sim *sim, const Motion *motion, int row)
{
    Grid *g = &sim->g;
    const size_t start = (size_t)row * (size_t)g->n[0];
    const unsigned held = row_hold(g, row);
    int lo, hi, live = 0;
    Vec drive;
    row_span(g, row, &lo, &hi);
    row_drive(g, row, drive);
    for (int i = lo; i < hi; i++) {
        const size_t at = start + (size_t)i;
        const double mass = g->node[at][0];
        const bool empty = mass <= sim->mass_cut; /* false for NaN, which must spread */
        const unsigned fixed = held | g->hold[0][i];
        const unsigned stops = g->nstop ? sim_stops(g, row, i, motion->dt * motion->scale) : 0;
        if (g->mass) g->mass[at] = empty ? 0 : mass;
        live += !empty;
        if (g->drive[0]) drive[0] = g->drive[0][i];
        if (empty)
            clear_node(g, motion, at, fixed | stops, g->impulse[row]);
        else
            solve_node(&g->node[at], g->force ? g->force + at * DIM : NULL, motion, fixed | stops,
                       motion->force ? stops & ~fixed : 0, drive, g->impulse[row]);
    }
    g->live[row] = live;
}

static void solve_any_row(Sim *sim, int row, const void *motion)
{
    if (!mirror_is_ghost_row(&sim->g, row, 0) && !solve_free_row(sim, motion, row))
        solve_row(sim, motion, row);
}

void solve_all(Sim *sim, double dt, double scale, bool force)
{
    Grid *g = &sim->g;
    const double pic = sim->method.pic;
    const Motion motion = {
        dt, scale, force, g->nmirror > 0 || sim->method.repair, {dt * (1 - pic), force ? pic : 0}};
    for (int row = 0; row < g->rows; row++) {
        for (int a = 0; a < DIM; a++) g->impulse[row][a] = 0;
        if (g->work) g->work[row] = 0;
    }
    if (motion.early && force) each_row(sim, record_forces, &motion);
    if (sim->setup->reactions && force && g->force) record_outside(sim, dt * scale);
    if (g->nmirror) mirror_fold(sim);
    if (g->work && force) each_row(sim, record_wall_work, &motion);
    if (sim->method.repair) sim->method.repair(sim, dt * scale);
    each_row(sim, solve_any_row, &motion);
    if (g->nmirror) mirror_unfold(sim, motion.given);
    if (sim->method.wall_images) mirror_wall_images(sim);
    long live = 0;
    for (int row = 0; row < g->rows; row++) {
        if (g->lo[row] < g->hi[row]) live += g->live[row];
        for (int a = 0; a < DIM; a++) sim->impulse[a] += g->impulse[row][a];
        if (g->work && force) sim->driven += g->work[row];
    }
    sim->live = live;
    if (live > sim->nodes) sim->nodes = live;
}
