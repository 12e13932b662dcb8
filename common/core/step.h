/* step.h: one explicit time step of the particle core, for every integrator. */
#ifndef MPMLAB_STEP_H
#define MPMLAB_STEP_H

#include "common/contract/solver.h"
#include "sim.h"

/* What each integrator is called and does, in the order of Integrator. */
extern const Info step_integrators[INTEGRATORS];

/* Does its first step take half the acceleration, so that velocities belong to t + dt/2? */
bool step_half_first(Integrator i);

/* True if F follows the velocities before they are accelerated (usf). */
bool step_strain_first(Integrator i);

/* One step from t to t + dt [s]; `first` takes the half first step where the integrator has one;
 * there a changes v over the mean of this dt and the one before, from middle to middle.
 * Returns the first thing that went wrong (lowest particle id), with the particles left as they
 * are; a Sim that went wrong takes no more steps and returns the same status again. */
Status sim_step(Sim *sim, double t, double dt, bool first);

/* The same for n bodies pass by pass; `meet` comes in every pass when the nodes of all bodies have
 * their velocities, before particles take them, `force` in the pass that accelerates. The first
 * fault of the first body that has one; *culprit: its number. */
enum { MAX_BODIES = 2 };
typedef void Meet(void *own, double dt, bool force);
Status sim_step_bodies(Sim *const body[], int n, double t, double dt, bool first, Meet *meet,
                       void *own, int *culprit);

/* Masses and velocities to the grid, nothing else. */
Status sim_project(Sim *sim);

/* The first particle that is not a number, has left the grid or is turned inside out. (SINGULAR, no
 * node has mass, is found by the step itself.) */
Status sim_check(const Sim *sim);

/* The particle core as a Solver; `self` is a Sim. */
extern const Solver particle_solver;

#endif
