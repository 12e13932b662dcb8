/* plan_check.c: what a run cannot have is refused before it begins (plan.h). */
#include <math.h>
#include <stdio.h>
#include "plan.h"
#include "probe.h"
#include "common/base/saved.h"

int plan_no_exact_motion(const RunSpec *spec, Fault *fault)
{
    return fault_set(fault, FAULT_USAGE,
                     "--errors: got '%s', takes a scene in motion with an exact solution",
                     spec->errors);
}

static bool needs_distance(const Method *m, const double par[])
{
    return m && method_adapted(m, par).scene_distance;
}

/* A method that, with these parameters, asks the scene for distances which it does not have. */
static int check_distance(const RunSpec *spec, const Plan *plan, Fault *fault)
{
    const Setup *s = &plan->setup;
    if (plan->scene.problem->distance || (!needs_distance(s->method, plan->method_par) &&
                                          !needs_distance(s->method_b, plan->second_par)))
        return 0;
    char known[128] = "none";
    for (size_t k = 0, at = 0; problems[k]; k++)
        if (problems[k]->distance && at < sizeof known)
            at += (size_t)snprintf(known + at, sizeof known - at, "%s%s", at ? ", " : "",
                                   problems[k]->info.name);
    return fault_set(fault, FAULT_USAGE,
                     "--set distance: got 'exact', takes a scene of %dD that knows its distance "
                     "(%s), not %s",
                     DIM, known, spec->problem);
}

/* Elements do not break. */
static int check_rupture(const RunSpec *spec, const Plan *plan, Fault *fault)
{
    if (!plan->scene.problem->strength || plan->setup.method) return 0;
    return fault_set(fault, FAULT_USAGE,
                     "--method: got '%s', takes a method of particles with %s: not fem, whose "
                     "elements do not break",
                     plan->method->name, spec->problem);
}

/* Outputs that this run cannot have are refused before it begins. */
int plan_check_outputs(const RunSpec *spec, const Plan *plan, Fault *fault)
{
    const Solver *solver = plan->solver;
    const bool polygons = solver->elements || (plan->setup.method && plan->setup.method->patches) ||
                          (plan->setup.method_b && plan->setup.method_b->patches);
    const char *name = plan->method->name;
    if (solver->takes && solver->takes(&plan->scene, fault)) return FAULT_USAGE;
    if (check_distance(spec, plan, fault) || check_rupture(spec, plan, fault)) return FAULT_USAGE;
    if (plan->scene.problem->projection && !solver->project)
        return fault_set(fault, FAULT_USAGE,
                         "--method: got '%s', which projects nothing onto a grid", name);
    if (spec->history && plan->scene.problem->projection)
        return fault_set(fault, FAULT_USAGE,
                         "--history: got '%s', takes a scene in motion, and %s has no time steps",
                         spec->history, spec->problem);
    if ((spec->checkpoint || spec->resume) && plan->scene.problem->projection)
        return fault_set(fault, FAULT_USAGE,
                         "--%s: got '%s', takes a scene in motion, and %s has no time steps",
                         spec->checkpoint ? "checkpoint" : "resume",
                         spec->checkpoint ? spec->checkpoint : spec->resume, spec->problem);
    if (spec->checkpoint && (saved_check_path("--checkpoint", spec->checkpoint, fault) ||
                             saved_check_path("--history", spec->history, fault)))
        return FAULT_USAGE;
    if (spec->errors && (!plan->scene.problem->exact || plan->scene.problem->projection))
        return plan_no_exact_motion(spec, fault);
    if (probe_check(spec, &plan->scene, fault)) return FAULT_USAGE;
    if (spec->nodes && !solver->nodes)
        return fault_set(fault, FAULT_USAGE,
                         "--nodes: got '%s', takes a method with a grid, not %s", spec->nodes,
                         name);
    if (spec->patches && !(DIM > 1 && solver->patches && polygons))
        return fault_set(
            fault, FAULT_USAGE,
            "--patches: got '%s', takes two or three dimensions and a method with polygons, "
            "not %s in %dD",
            spec->patches, name, DIM);
    return 0;
}
