/* step.c: the stages of WLS in order (W11 section 4), and their workspace. */
#include <math.h>
#include <stdlib.h>
#include "methods/parts/shapes.h"
#include "wls.h"
#include "common/core/each.h"

static void read_choices(const double par[], Wls *w)
{
    w->linear = (int)par[P_STRESS] == STRESS_LINEAR;
    w->quadrature = (int)par[P_QUADRATURE];
    w->distance_by = (int)par[P_DISTANCE];
    w->extrapolate = (int)par[P_SPURIOUS] == SPURIOUS_EXTRAPOLATE;
    w->literal = (int)par[P_AVERAGE] == AVERAGE_LITERAL;
    w->corrected = (int)par[P_MASS] == MASS_CORRECTED;
    w->folded = w->corrected && (int)par[P_AVERAGE] == AVERAGE_FOLDED; /* into a0 of its step */
    w->sharpened = (int)par[P_VELOCITY] == VELOCITY_CORRECTED;
    w->lagged = w->corrected && (int)par[P_MOTION] == MOTION_LAGGED;
    w->hermite = par[P_HERMITE] * par[P_HERMITE];
    w->trigger = par[P_TRIGGER];
    w->condition = (int)par[P_CONDITION];
}

bool wls_alloc(const Sim *sim, Wls *w)
{
    const size_t n = (size_t)sim->g.rows * (size_t)sim->g.n[0];
    w->fit = sim_array(n, sizeof *w->fit);
    w->skin = sim_array(n, sizeof *w->skin);
    w->skinned = calloc(n + 1, sizeof *w->skinned);
    w->most = sim_array(n, sizeof *w->most);
    w->good = sim_array(n, 1);
    w->fallbacks = calloc((size_t)sim->g.rows, sizeof *w->fallbacks);
    return w->fit && w->skin && w->skinned && w->most && w->good && w->fallbacks;
}

void wls_release(Wls *w)
{
    free(w->fit), free(w->skin), free(w->skinned), free(w->most), free(w->good), free(w->fallbacks);
}

/* Are accelerations or velocities corrected by the mass matrix? */
static bool has_inertia(const Wls *w)
{
    return w->corrected || w->sharpened;
}

/* What wls_make allocates per grid node. */
static size_t node_bytes(const double par[])
{
    Wls w = {0};
    read_choices(par, &w);
    size_t n = sizeof *w.fit + sizeof *w.skin + sizeof *w.skinned + sizeof *w.most +
               sizeof *w.good + sizeof *w.distance;
    if (w.condition == CONDITION_COUNT) n += sizeof *w.count;
    if (w.distance_by == DISTANCE_CURVED) n += sizeof *w.bend;
    if (has_inertia(&w))
        n += sizeof *w.inertia + sizeof *w.cell_mass + sizeof *w.cut + sizeof *w.stops;
    return n;
}

bool wls_make(Sim *sim)
{
    const Grid *g = &sim->g;
    const size_t n = (size_t)g->rows * (size_t)g->n[0];
    Wls *w = sim->own = calloc(1, sizeof *w);
    if (!w) return false;
    read_choices(sim->setup->method_par, w);
    if (w->condition == CONDITION_COUNT) w->count = sim_array(n, sizeof *w->count);
    w->inside =
        2 * sim->setup->ppc / (double)CORNERS; /* eq 14: 2 with two particles per axis and cell */
    const double denser = sim->method.surface_per_cell / pow(sim->setup->ppc, 1.0 / DIM);
    w->surface_beta = 1;
    for (int d = 1; d < DIM && denser > 0; d++) w->surface_beta /= denser;
    if (has_inertia(w)) {
        w->inertia = sim_array(n, sizeof *w->inertia);
        w->cell_mass = sim_array(n, sizeof *w->cell_mass);
        w->cut = sim_array(n, sizeof *w->cut);
        w->stops = sim_array(n, 1);
    }
    if (w->distance_by == DISTANCE_CURVED) w->bend = sim_array(n, sizeof *w->bend);
    w->distance = sim_array(n, sizeof *w->distance);
    return wls_alloc(sim, w) && w->distance && (w->count || w->condition != CONDITION_COUNT) &&
           ((w->inertia && w->cell_mass && w->cut && w->stops) || !has_inertia(w)) &&
           (w->bend || w->distance_by != DISTANCE_CURVED);
}

void wls_free(Sim *sim)
{
    Wls *w = wls_of(sim);
    wls_release(w);
    free(w->count), free(w->inertia), free(w->distance);
    free(w->cell_mass), free(w->cut), free(w->stops), free(w->bend);
    free(w);
}

void wls_adapt(const double par[], Method *own)
{
    own->node_bytes = node_bytes(par);
    own->surface_per_cell = par[P_SURFACE_PER_CELL];
    own->keeps_L = par[P_HERMITE] > 0;
    own->scene_distance = (int)par[P_DISTANCE] == DISTANCE_EXACT;
    if ((int)par[P_RETURN] != RETURN_SPLINE) return;
    own->width = spline_width;
    own->shape = spline_shape;
    own->wall_images = true;
}

static void solve_row(Sim *sim, int row, const void *t)
{
    const Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    w->fallbacks[row] = 0;
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
        const bool whole = wls_solve_node(w, at);
        w->fallbacks[row] += !whole && w->fit[at][FIT_MOMENTS][M_BETA] > 0;
    }
    wls_distances(sim, row, *(const double *)t);
}

void wls_assemble(Sim *sim, double t, bool force)
{
    wls_deposit(sim, wls_of(sim), t, force);
    if (wls_of(sim)->count) wls_count(sim);
    each_row(sim, solve_row, &t);
    wls_integrate(sim);
}

/* Marks a row's good nodes with mass as SOUND, and notes in `body` whether any node has mass. */
static void mark_sound(Sim *sim, int row, const void *unused)
{
    const Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    bool any = false;
    (void)unused;
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
        const bool massive = g->node[at][0] > sim->mass_cut;
        if (w->good[at] && massive) w->good[at] |= SOUND;
        any |= massive;
    }
    if (!any) return;
#pragma omp atomic write /* by any thread of the team: team.h */
    w->body = true;
}

void wls_repair(Sim *sim, double dt)
{
    const Grid *g = &sim->g;
    wls_of(sim)->body = false;
    each_row(sim, mark_sound, NULL);
    if (wls_of(sim)->inertia) wls_correct(sim, dt);
    each_row(sim, wls_repair_row, &dt);
    for (int row = 0; row < g->rows; row++)
        if (g->lo[row] < g->hi[row]) sim->fallbacks += wls_of(sim)->fallbacks[row];
}
