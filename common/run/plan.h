/* plan.h: from what was typed to what a run is built from. */
#ifndef MPMLAB_PLAN_H
#define MPMLAB_PLAN_H

#include "common/contract/solver.h"
#include "engine.h"

enum { MAX_PARAMS = 32 };

/* A resolved run: everything filled and checked. The scene's parameters live in here. */
typedef struct Plan {
    Scene scene;
    Setup setup;
    const Solver *solver;
    const Info *method; /* info of the method or solver */
    const Info *second; /* of the second body's method, or NULL: the same */
    double problem_par[MAX_PARAMS], method_par[MAX_PARAMS], second_par[MAX_PARAMS];
    char text[SETTING_TEXT]; /* the problem's parameter that is the name of a file */
    double cfl, t_end;
    long steps;       /* stop after so many; 0: no limit */
    bool adaptive;    /* the step is chosen anew every time, W11 eq 34 */
    bool stop_growth; /* energy growth ends the run */
    char params[512]; /* "name=value;..." sorted */
} Plan;

/* A run that goes on with another method on the same particles: --then METHOD --at WHEN, --then-set
 * NAME=VALUE. In a spec these are settings: then, at, then_NAME, so that a row's parameters make
 * the run again. */
typedef enum { AT_NEVER, AT_TIME, AT_INVERTED, AT_J, AT_RUPTURE } HandoverAt;

typedef struct Handover {
    HandoverAt at;
    double value; /* [s], or J */
    Plan plan;    /* of the second method */
} Handover;

/* Is a setting of this name part of a hand-over? */
bool handover_is_setting(const char *name);

/* The hand-over of a run whose first plan is resolved; spells out its settings in *spec. at is
 * AT_NEVER without --then. 0, or a fault if the settings make no sense together. */
int handover_plan(RunSpec *spec, const Plan *first, Handover *out, Fault *fault);

/* Fills *plan, and every default in *spec. 0 or a fault. */
int plan_make(RunSpec *spec, Plan *plan, Fault *fault);

/* Refuses outputs and settings that this run cannot have; 0 or a fault. plan_check.c. */
int plan_check_outputs(const RunSpec *spec, const Plan *plan, Fault *fault);

/* The refusal of --errors where no exact motion is known. */
int plan_no_exact_motion(const RunSpec *spec, Fault *fault);

/* Runs a spec to one row (run.c); the engine's run. */
int run_spec(const RunSpec *spec, Row *row, Fault *fault);

/* The parameters that every run takes, ended by a NULL name. */
extern const Param *const settings_common;

/* The registries of this dimension, NULL-terminated; registry.c. Solvers that are chosen by name
 * like a method (FEM) stand with the methods in method_infos. */
extern const Solver *const solvers[];
extern const Info *const problem_infos[], *const method_infos[];

#endif
