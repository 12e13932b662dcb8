/* plan.c: see plan.h. Defaults, and what is refused. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "settings.h"
#include "common/core/step.h"

static int param_count(const Param *p)
{
    int n = 0;
    while (p && p[n].name) n++;
    return n;
}

static int whole(const char *name, double value, Fault *fault)
{
    if (value == floor(value)) return 0;
    return fault_set(fault, FAULT_USAGE, "--set %s: got '%g', takes a whole number", name, value);
}

/* Reads the settings that belong to `params` into value[], defaults for the others. */
static int read_params(const RunSpec *spec, const Param *params, double value[], Fault *fault)
{
    char takes[128];
    for (int k = 0; k < param_count(params); k++) {
        const char *text = spec_get(spec, params[k].name);
        value[k] = params[k].value;
        if (text && info_param_parse(&params[k], text, &value[k], takes))
            return fault_set(fault, FAULT_USAGE, "--set %s: got '%s', takes %s", params[k].name,
                             text, takes);
    }
    return 0;
}

static int unknown_setting(const Plan *plan, const char *name, Fault *fault)
{
    const Param *lists[] = {plan->scene.problem->info.params, plan->method->params, settings_common,
                            plan->second ? plan->second->params : NULL};
    const char *names[4 * MAX_PARAMS];
    int n = 0;
    if (handover_is_setting(name)) return 0;
    for (int l = 0; l < 4; l++) {
        if (info_param_find(lists[l], name)) return 0;
        for (int k = 0; k < param_count(lists[l]); k++) names[n++] = lists[l][k].name;
    }
    fault_set(fault, FAULT_USAGE, "--set %s: got '%s', takes a parameter of %s, %s or of every run",
              name, name, plan->scene.problem->info.name, plan->method->name);
    return fault_did_you_mean(fault, "", name, names, n);
}

static const Problem *find_problem(const char *name)
{
    for (const Problem *const *p = problems; *p; p++)
        if (strcmp((*p)->info.name, name) == 0) return *p;
    return NULL;
}

/* Length of the bodies along the first axis [m], without what lies between two. */
static double body_length(const Scene *scene)
{
    double length = scene->body_hi[0] - scene->body_lo[0];
    for (int b = 0; b < 2 && scene->problem->part; b++) {
        Scene own = *scene;
        scene->problem->part(&own, b);
        length = (b ? length : 0) + own.body_hi[0] - own.body_lo[0];
    }
    return length;
}

/* 1D: a whole number of particles; 2D lattice: n^2 per cell; 3D: n^3 in any layout. */
static int choose_ppc(RunSpec *spec, Plan *plan, const double run[], Fault *fault)
{
    Setup *s = &plan->setup;
    const double length = body_length(&plan->scene);
    const double given = spec_get(spec, "particles") ? run[P_PARTICLES] : 0;
    if (given > 0 && (DIM > 1 || spec->ppc > 0))
        return fault_set(fault, FAULT_USAGE,
                         "--set particles: got '%g', takes 1D scenes without --ppc", given);
    if (!(spec->ppc > 0)) spec->ppc = plan->scene.problem->ppc;
    const double n = round(pow(spec->ppc, 1.0 / DIM));
    if (DIM == 1) {
        const double count = given > 0 ? given : round(spec->ppc * s->cells * length);
        if (!(count >= 1 && count <= 1e9 && 2 * count > s->cells * length / 15))
            return fault_set(fault, FAULT_USAGE,
                             "--%s: got '%g', takes 1 to 1e9 particles in all and "
                             "at least 1/30 per cell",
                             given > 0 ? "set particles" : "ppc", given > 0 ? given : spec->ppc);
        s->count = (int)count;
        spec->ppc = count / (s->cells * length);
    } else if ((DIM > 2 || !s->fitted) && s->method &&
               fabs(pow(n, DIM) - spec->ppc) > 1e-9 * spec->ppc)
        return fault_set(fault, FAULT_USAGE, "--ppc: got '%g', takes n^%d (%g, %g, ...)%s",
                         spec->ppc, DIM, pow(fmax(n, 1), DIM), pow(n + 1, DIM),
                         DIM > 2 ? "" : " on a lattice");
    s->ppc = spec->ppc;
    return 0;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const Setting *)a)->name, ((const Setting *)b)->name);
}

/* Of two bodies' methods: does each have a default of its own for this parameter, which was not
 * given? Then its name cannot say both. */
static bool has_two_defaults(const RunSpec *spec, const Plan *plan, const char *name)
{
    const Param *a = info_param_find(plan->method->params, name);
    const Param *b = plan->second ? info_param_find(plan->second->params, name) : NULL;
    return a && b && fabs(a->value - b->value) > 0 && !spec_get(spec, name);
}

/* Adds every parameter of problem and method to the spec, which then selects this run alone. */
static int spell_out(RunSpec *spec, Plan *plan, Fault *fault)
{
    const Param *lists[] = {plan->scene.problem->info.params, plan->method->params,
                            plan->second ? plan->second->params : NULL};
    const double *values[] = {plan->problem_par, plan->method_par, plan->second_par};
    char text[64], pair[128];
    for (int l = 0; l < 3; l++)
        for (int k = 0; k < param_count(lists[l]); k++) {
            if (has_two_defaults(spec, plan, lists[l][k].name)) continue;
            if (info_param_is_path(&lists[l][k])) continue; /* as typed, or absent */
            info_param_print(&lists[l][k], values[l][k], text);
            snprintf(pair, sizeof pair, "%s=%s", lists[l][k].name, text);
            if (spec_set(spec, pair, fault)) return FAULT_USAGE;
        }
    int n = 0; /* drops run settings that equal their default or are stored in another field; keeps
                * `dim`, because without it the command would select another run */
    for (int k = 0; k < spec->nset; k++) {
        const Param *p = info_param_find(settings_common, spec->set[k].name);
        double value = 0;
        char takes[128];
        const bool read = p && !info_param_parse(p, spec->set[k].value, &value, takes);
        const double known = p ? settings_usual(p, &plan->setup) : 0;
        const bool differs = p == &settings_common[P_DIM] || fabs(value - known) > 0;
        const bool keep = !p || (p != &settings_common[P_PARTICLES] && read && differs);
        if (!keep) continue;
        if (p) { /* as it would be printed: 3, not 03 */
            info_param_print(p, value, text);
            strcpy(spec->set[k].value, text);
        }
        spec->set[n++] = spec->set[k];
    }
    spec->nset = n;
    qsort(spec->set, (size_t)n, sizeof *spec->set, by_name);
    size_t at = 0;
    for (int k = 0; k < n && at < sizeof plan->params; k++)
        if (strcmp(spec->set[k].name, "layout"))
            at += (size_t)snprintf(plan->params + at, sizeof plan->params - at, "%s%s=%s",
                                   at ? ";" : "", spec->set[k].name, spec->set[k].value);
    return 0;
}

static int make_scene(const RunSpec *spec, Plan *plan, Fault *fault)
{
    Scene *scene = &plan->scene;
    char why[128] = "";
    scene->par = plan->problem_par;
    scene->cell = 1.0 / spec->cells;
    if (read_params(spec, scene->problem->info.params, plan->problem_par, fault))
        return FAULT_USAGE;
    for (const Param *p = scene->problem->info.params; p && p->name; p++)
        if (info_param_is_path(p) && spec_get(spec, p->name))
            scene->text = strcpy(plan->text, spec_get(spec, p->name));
    if (scene->problem->init(scene, why))
        return fault_set(fault, FAULT_USAGE, "--set: %s: %s", spec->problem, why);
    if (scene->problem->complete) scene->problem->complete(scene, plan->problem_par);
    return 0;
}

static int choose_times(RunSpec *spec, Plan *plan, Fault *fault)
{
    const Problem *problem = plan->scene.problem;
    if (problem->projection) {
        if (plan->adaptive)
            return fault_set(
                fault, FAULT_USAGE,
                "--set dt: got 'adaptive', takes a scene in motion, and %s has no time "
                "steps",
                spec->problem);
        if (spec->cfl > 0 || spec->t_end > 0)
            return fault_set(fault, FAULT_USAGE,
                             "--%s: got '%g', takes a scene in motion, and %s has no time steps",
                             spec->cfl > 0 ? "cfl" : "t-end",
                             spec->cfl > 0 ? spec->cfl : spec->t_end, spec->problem);
        plan->cfl = plan->t_end = 0;
        spec->cfl = spec->t_end = 0;
        return 0;
    }
    if (!(spec->cfl > 0)) spec->cfl = problem->cfl;
    const double counted = problem->steps ? fmax(problem->steps, (double)plan->steps) : 0;
    if (!(spec->t_end > 0) && counted > 0) /* more steps than the scene's own move its end */
        spec->t_end = counted * spec->cfl * plan->scene.cell / plan->scene.c;
    if (!(spec->t_end > 0)) spec->t_end = plan->scene.t_end;
    plan->cfl = spec->cfl;
    plan->t_end = spec->t_end;
    const double steps = spec->t_end * plan->scene.c * spec->cells / spec->cfl;
    if (steps < 2e9) return 0;
    return fault_set(fault, FAULT_USAGE, "--cfl: %g to t = %g takes %.3g steps, more than 2e9",
                     spec->cfl, spec->t_end, steps);
}

int plan_make(RunSpec *spec, Plan *plan, Fault *fault)
{
    double run[RUN_PARAMS];
    Setup *s = &plan->setup;
    *plan = (Plan){0};
    plan->scene.problem = find_problem(spec->problem);
    if (!plan->scene.problem)
        return fault_set(fault, FAULT_USAGE, "problem: got '%s', not one of %dD", spec->problem,
                         DIM);
    if (settings_method(spec, plan, fault)) return FAULT_USAGE;
    for (int k = 0; k < spec->nset; k++)
        if (unknown_setting(plan, spec->set[k].name, fault)) return FAULT_USAGE;
    if (!(spec->cells > 0)) spec->cells = plan->scene.problem->cells;
    if (read_params(spec, settings_common, run, fault) || whole("steps", run[P_STEPS], fault) ||
        whole("particles", run[P_PARTICLES], fault) || whole("repeat", run[P_REPEAT], fault) ||
        whole("subcycles", run[P_SUBCYCLES], fault) ||
        read_params(spec, plan->method->params, plan->method_par, fault) ||
        read_params(spec, plan->second ? plan->second->params : NULL, plan->second_par, fault) ||
        make_scene(spec, plan, fault) || settings_integrator(spec, plan, run, fault) ||
        settings_strain(spec, plan, run, fault) || settings_frame(spec, plan, run, fault) ||
        plan_check_outputs(spec, plan, fault))
        return FAULT_USAGE;
    s->scene = &plan->scene;
    s->method_par = plan->method_par;
    s->method_b_par = plan->second_par;
    s->cells = (int)spec->cells;
    s->fitted = spec_get(spec, "layout") ? run[P_LAYOUT] > 0
                                         : settings_usual(&settings_common[P_LAYOUT], s) > 0;
    s->threads = spec->threads > 0 ? spec->threads : 1;
    s->reactions = spec->history != NULL;
    s->snapshot_nodes = plan->scene.problem->projection || spec->nodes || spec->vtk;
    plan->steps = (long)run[P_STEPS];
    plan->adaptive = run[P_DT] > 0;
    plan->stop_growth = run[P_STOP] > 0;
    Handover handover;
    if (choose_ppc(spec, plan, run, fault) || choose_times(spec, plan, fault) ||
        handover_plan(spec, plan, &handover, fault) || spell_out(spec, plan, fault))
        return FAULT_USAGE;
    return 0;
}
