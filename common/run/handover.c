/* handover.c: the hand-over of plan.h. The second method is planned as a run of its own, on the
 * same scene, mesh and layout. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "settings.h"

static const char prefix[] = "then_";
enum { PREFIX = sizeof prefix - 1 };

bool handover_is_setting(const char *name)
{
    return !strcmp(name, "then") || !strcmp(name, "at") || !strncmp(name, prefix, PREFIX);
}

/* Run settings that the second method may have of its own. */
static const int own[] = {P_DOMAIN, P_STRAIN, P_SUBCYCLES, P_REFRESH, P_ALLOW};
enum { OWN = sizeof own / sizeof *own };

static int check_name(const char *name, const Info *method, Fault *fault)
{
    const char *names[MAX_PARAMS + OWN];
    int n = 0;
    for (int k = 0; k < OWN; k++) names[n++] = settings_common[own[k]].name;
    for (const Param *p = method->params; p && p->name; p++) names[n++] = p->name;
    for (int k = 0; k < n; k++)
        if (strcmp(names[k], name) == 0) return 0;
    fault_set(fault, FAULT_USAGE,
              "--then-set %s: got '%s', takes a parameter of %s, domain, strain_update, "
              "subcycles, refresh or allow_unstable",
              name, name, method->name);
    return fault_did_you_mean(fault, "", name, names, n);
}

static const Method *plugin_of(const char *method)
{
    for (const Method *const *m = methods; *m; m++)
        if (strcmp((*m)->info.name, method) == 0) return *m;
    return NULL;
}

static int unknown_method(const char *got, Fault *fault)
{
    const char *names[64];
    int n = 0;
    for (const Method *const *m = methods; *m; m++) names[n++] = (*m)->info.name;
    fault_set(fault, FAULT_USAGE, "--then: got '%s', takes a method of particles", got);
    return fault_did_you_mean(fault, "", got, names, n);
}

/* The scene's and the run's settings are those of the first method; boxes only where there are
 * any. */
static bool is_inherited(const char *name, const Plan *first, const Method *method)
{
    if (strcmp(name, settings_common[P_DOMAIN].name) == 0)
        return settings_act_on_method(P_DOMAIN, method);
    return strcmp(name, settings_common[P_LAYOUT].name) != 0 &&
           (info_param_find(first->scene.problem->info.params, name) ||
            info_param_find(settings_common, name));
}

/* The run as if the second method had it from its start. */
static int second_spec(const RunSpec *spec, const Plan *first, const char *then, RunSpec *out,
                       Fault *fault)
{
    const Method *method = plugin_of(then);
    char pair[sizeof(Setting) + 1];
    if (!method) return unknown_method(then, fault);
    *out = *spec;
    out->nset = 0;
    strcpy(out->method, then);
    snprintf(pair, sizeof pair, "layout=%s", first->setup.fitted ? "radial" : "cartesian");
    if (spec_set(out, pair, fault)) return FAULT_USAGE;
    for (int own_ones = 0; own_ones < 2; own_ones++)
        for (const Setting *s = spec->set; s < spec->set + spec->nset; s++) {
            const bool is_own = strncmp(s->name, prefix, PREFIX) == 0;
            const char *name = s->name + (is_own ? PREFIX : 0);
            if (is_own != own_ones || (!is_own && !is_inherited(name, first, method))) continue;
            if (is_own && check_name(name, &method->info, fault)) return FAULT_USAGE;
            snprintf(pair, sizeof pair, "%.31s=%.*s", name, SETTING_TEXT - 1, s->value);
            if (spec_set(out, pair, fault)) return FAULT_USAGE;
        }
    return 0;
}

/* A time, "inverted", "rupture" or "J=x"; printed as it is read. */
static int read_at(RunSpec *spec, const Plan *first, Handover *out, Fault *fault)
{
    const char *text = spec_get(spec, "at");
    const bool J = strncmp(text, "J=", 2) == 0, inverted = strcmp(text, "inverted") == 0;
    const double most = J ? 1 : first->t_end;
    const bool rupture = strcmp(text, "rupture") == 0;
    const bool read =
        !inverted && !rupture && info_number_parse(text + (J ? 2 : 0), &out->value) == 0;
    char number[64], pair[128];
    out->at = inverted ? AT_INVERTED : rupture ? AT_RUPTURE : J ? AT_J : AT_TIME;
    if (rupture && !first->scene.problem->strength)
        return fault_set(fault, FAULT_USAGE,
                         "--at: got 'rupture', takes a scene whose matter breaks (burst_ring), not "
                         "%s",
                         spec->problem);
    if (inverted || rupture) return 0;
    if (!read || !(out->value > 0) || !(J ? out->value <= most : out->value < most))
        return fault_set(
            fault, FAULT_USAGE,
            "--at: got '%s', takes a time above 0 and below t_end = %.6g, inverted, rupture, or "
            "J=x with x above 0, at most 1",
            text, first->t_end);
    info_number_print(out->value, number);
    snprintf(pair, sizeof pair, "at=%s%s", J ? "J=" : "", number);
    return spec_set(spec, pair, fault);
}

static int needs(const char *option, const char *other, Fault *fault)
{
    return fault_set(fault, FAULT_USAGE, "%s: needs %s", option, other);
}

/* The faults of the second run's plan name what was typed for it. */
static int by_option(Fault *fault)
{
    static const char *const names[][2] = {{"--set ", "--then-set "}, {"--method:", "--then:"}};
    char text[sizeof fault->text];
    for (size_t k = 0; fault && k < sizeof names / sizeof *names; k++) {
        const size_t n = strlen(names[k][0]);
        if (strncmp(fault->text, names[k][0], n) != 0) continue;
        strcpy(text, fault->text + n);
        return fault_set(fault, fault->code, "%s%s", names[k][1], text);
    }
    return FAULT_USAGE;
}

int handover_plan(RunSpec *spec, const Plan *first, Handover *out, Fault *fault)
{
    const char *then = spec_get(spec, "then"), *at = spec_get(spec, "at");
    bool sets = false;
    RunSpec second;
    for (int k = 0; k < spec->nset; k++) sets |= strncmp(spec->set[k].name, prefix, PREFIX) == 0;
    out->at = AT_NEVER;
    if (!then && at) return needs("--at", "--then METHOD", fault);
    if (!then) return sets ? needs("--then-set", "--then METHOD", fault) : 0;
    if (!at) return needs("--then", "--at TIME, --at inverted, --at rupture or --at J=x", fault);
    if (first->scene.problem->projection)
        return fault_set(fault, FAULT_USAGE,
                         "--then: got '%s', takes a scene in motion, and %s has no time steps",
                         then, spec->problem);
    if (first->scene.problem->part)
        return fault_set(fault, FAULT_USAGE,
                         "--then: got '%s', takes a scene with one body, and %s has two", then,
                         spec->problem);
    if (!first->solver->take_over)
        return fault_set(fault, FAULT_USAGE,
                         "--then: got '%s', takes a run with particles, and %s is a mesh", then,
                         spec->method);
    if (read_at(spec, first, out, fault)) return FAULT_USAGE;
    if (second_spec(spec, first, spec_get(spec, "then"), &second, fault)) return FAULT_USAGE;
    if (plan_make(&second, &out->plan, fault)) return by_option(fault);
    if (first->scene.traction && !first->setup.method->assemble && out->plan.setup.method->assemble)
        return fault_set(fault, FAULT_USAGE,
                         "--then: got '%s' after %s, takes a method of particles under traction: "
                         "what integrates over cells needs surface points with strain",
                         then, spec->method);
    if (first->setup.frame == FRAME_TOTAL || out->plan.setup.frame == FRAME_TOTAL)
        return fault_set(
            fault, FAULT_USAGE,
            "--then: got '%s' after %s, takes two methods on the current grid, and one "
            "of these stays on the reference grid",
            then, spec->method);
    return 0;
}
