/* settings.h: what every run takes besides the parameters of its problem and method, and how these
 * settings become a Setup. */
#ifndef MPMLAB_SETTINGS_H
#define MPMLAB_SETTINGS_H

#include "plan.h"

/* Numbers in settings_common. */
enum {
    P_STEPS,
    P_ALLOW,
    P_REFRESH,
    P_LAYOUT,
    P_PARTICLES,
    P_DIM,
    P_STOP,
    P_REPEAT,
    P_DOMAIN,
    P_STRAIN,
    P_SUBCYCLES,
    P_FRAME,
    P_DT,
    RUN_PARAMS
};

/* The method, or two of them (A+B), and what solves with it. 0 or a fault. */
int settings_method(RunSpec *spec, Plan *plan, Fault *fault);

/* Time integrator; particle boxes and the update of F; frame: into plan->setup, from the run's
 * settings run[RUN_PARAMS]. 0, or a fault: a pair that is refused. */
int settings_integrator(RunSpec *spec, Plan *plan, const double run[], Fault *fault);
int settings_strain(const RunSpec *spec, Plan *plan, const double run[], Fault *fault);
int settings_frame(const RunSpec *spec, Plan *plan, const double run[], Fault *fault);

/* The frame that a run has unless it is asked for another: its methods'. */
Frame settings_usual_frame(const Setup *s);

/* Are particles fitted to the body unless asked otherwise? With two methods if one needs it. */
bool settings_usual_fitted(const Setup *s);

/* The value that setting k has with these methods unless it is set. */
double settings_usual_value(int k, const Setup *s);

/* The parameters of a method if none is set; par[MAX_PARAMS]. */
void settings_default_parameters(const Method *m, double par[]);

/* Does setting k change anything on this problem with some method; with this method (NULL: a mesh)
 * at its default parameters on some problem? */
bool settings_act_on_problem(int k, const Problem *p);
bool settings_act_on_method(int k, const Method *m);

#endif
