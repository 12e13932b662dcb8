/* passes.h: what one pass of a time step is made of, each over the whole scene: particles to nodes,
 * the nodes' own equations, nodes to particles. The bodies are scheme.h's loops; sums do not depend
 * on the number of threads. */
#ifndef MPMLAB_PASSES_H
#define MPMLAB_PASSES_H

#include "sim.h"

struct Work;

/* What is deposited: mass and momentum; these and forces at time t; or mass and m w, a round of a
 * velocity filter. */
typedef enum { MOTION, FORCES, ROUND } Deposit;

void deposit_all(Sim *sim, double t, Deposit what);

/* v = p/m, a = f/m times `scale`, walls, v += a dt, symmetry; adds the momentum that nodes give to
 * particles, less internal forces, to sim->impulse. `force`: forces were deposited. */
void solve_all(Sim *sim, double dt, double scale, bool force);

/* Updates what `take` (TAKE_*) names of all particles; travel and half_now, too. Returns whether a
 * particle may have gone wrong (sim_check says which). */
bool gather_all(Sim *sim, double dt, unsigned take);

/* Start of a method of moments: particles keep L D instead of L. */
void gather_start_moments(Sim *sim);

/* Of every slot: L [1/s] of the grid velocity (L NULL: not asked for), D = sum_i S (x_i - x_p)^2
 * along each axis [m^2]. */
void gather_gradient(Sim *sim, double *const L[NMAT], double *const D[DIM]);

/* w = S v of every particle, for a filter's round. */
void gather_velocity(Sim *sim);

/* Slope of tents for particles that lie on nodes; on_node.c. After a deposit with such particles
 * on_node_mark_body marks the nodes that have mass; then these particles' stress is deposited, and
 * later their L is gathered. (Their stencils: on_node_clear_slopes, sim.h.) */
void on_node_mark_body(Sim *sim);
void on_node_deposit(Sim *sim, const struct Work *w);
void on_node_gather(const Sim *sim, struct Work *w);

/* The method's filter of the grid velocity, after the nodes' equations; filter_open comes between
 * deposit and equations. takes_v: this pass updates particle velocities, so momentum that
 * walls absorb during filter rounds is added to sim->impulse; filter.c. */
void filter_open(Sim *sim);
void filter_all(Sim *sim, double dt, bool takes_v);

#endif
