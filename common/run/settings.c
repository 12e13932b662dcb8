/* settings.c: see settings.h. */
#include "settings.h"
#include <math.h>
#include <string.h>
#include "common/core/step.h"

static const Param run_params[] = {
    [P_STEPS] = {"steps", 0, 0, 1e9, "", "stop after so many steps; 0: at t_end", "", NULL},
    [P_ALLOW] = {"allow_unstable", 0, 0, 1, "", "1: run a refused method x integrator pair", "",
                 "0|1"},
    [P_REFRESH] = {"refresh", 0, 0, 1, "",
                   "1: L from the accelerated grid velocity before a "
                   "re-projection",
                   "", "0|1"},
    [P_LAYOUT] = {"layout", 0, 0, 1, "",
                  "particles on a lattice, or fitted to the body (default of the WLS methods)",
                  "W11 5.1", "cartesian|radial"},
    [P_PARTICLES] = {"particles", 0, 1, 1e8, "", "number of particles (1D), instead of ppc", "",
                     NULL},
    [P_DIM] = {"dim", DIM, 1, 3, "", "dimension of a scene that has several", "", NULL},
    [P_STOP] = {"stop_growth", 0, 0, 1, "", "1: energy growth ends the run", "", "0|1"},
    [P_REPEAT] = {"repeat", 1, 1, 1e6, "",
                  "number of a repetition: changes nothing but the row's key, so that a run can be "
                  "timed again",
                  "", NULL},
    [P_DOMAIN] =
        {"domain", DOMAIN_FXX, 0, 2, "",
         "half widths of particle boxes: l0 |F_dd|, l0 U_dd with U = sqrt(F^T F), which no "
         "rotation changes, or l0",
         "Wallstedt & Guilkey 2008", "fxx|stretch|undeformed"},
    [P_STRAIN] = {"strain_update", STRAIN_LINEAR, 0, 2, "",
                  "F += dt L F, which fits x += dt v; exp(dt L) F, exact for an imposed L; or (I + "
                  "dt L/k)^k F",
                  "W11 eq 30", "linear|exponential|subcycled"},
    [P_SUBCYCLES] = {"subcycles", 4, 1, 1000, "", "k of strain_update=subcycled", "", NULL},
    [P_FRAME] = {"frame", FRAME_CURRENT, 0, 1, "",
                 "weights at the particles; or at their reference positions, for the whole run, "
                 "with stress P and gradients in X (tlmpm's default)",
                 "de Vaucorbeil et al. 2020", "current|total"},
    [P_DT] =
        {"dt", 0, 0, 1, "",
         "one step CFL h/c for the whole run, or CFL h/(v_max + max |v_p|) anew for every step, "
         "v_max of eq 33",
         "W11 eqs 33, 34", "constant|adaptive"},
    [RUN_PARAMS] = {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

const Param *const settings_common = run_params;

/* A method by name: a plug-in, or a mesh solver. */
typedef struct Named {
    const Method *method;
    const Solver *solver;
    const Info *info;
} Named;

static int find_method(const char *name, Named *out, Fault *fault)
{
    const char *names[64];
    int n = 0;
    for (const Method *const *m = methods; *m; m++) {
        names[n++] = (*m)->info.name;
        if (strcmp((*m)->info.name, name) == 0) *out = (Named){*m, &particle_solver, &(*m)->info};
    }
    for (const Solver *const *s = solvers; *s; s++) {
        names[n++] = (*s)->info.name;
        if (strcmp((*s)->info.name, name) == 0) *out = (Named){NULL, *s, &(*s)->info};
    }
    if (out->info) return 0;
    fault_set(fault, FAULT_USAGE, "--method: got '%s', takes a method of %dD", name, DIM);
    return fault_did_you_mean(fault, "", name, names, n);
}

/* One method, or A+B in a scene with two bodies. */
int settings_method(RunSpec *spec, Plan *plan, Fault *fault)
{
    if (!spec->method[0]) strcpy(spec->method, "gimp");
    const char *plus = strchr(spec->method, '+');
    char first[sizeof spec->method];
    Named a = {0}, b = {0};
    snprintf(first, sizeof first, "%.*s", plus ? (int)(plus - spec->method) : 31, spec->method);
    if (find_method(first, &a, fault) || (plus && find_method(plus + 1, &b, fault)))
        return FAULT_USAGE;
    const bool two = plan->scene.problem->part, mesh = !a.method || (plus && !b.method);
    if (plus && !two)
        return fault_set(fault, FAULT_USAGE,
                         "--method: got '%s', takes one method in %s, which has one body",
                         spec->method, spec->problem);
    if (two && mesh)
        return fault_set(fault, FAULT_USAGE,
                         "--method: got '%s', takes a method with a grid in %s, whose two bodies "
                         "meet at grid nodes",
                         spec->method, spec->problem);
    if (a.info == b.info) strcpy(spec->method, first);
    plan->solver = a.solver;
    plan->method = a.info;
    plan->setup.method = a.method;
    if (!plus || a.info == b.info) return 0;
    plan->second = b.info;
    plan->setup.method_b = b.method;
    return 0;
}

static int unknown_integrator(const char *got, Fault *fault)
{
    const char *names[INTEGRATORS];
    for (int i = 0; i < INTEGRATORS; i++) names[i] = step_integrators[i].name;
    fault_set(fault, FAULT_USAGE, "--integrator: got '%s', takes cd, uvf, musl, usl or usf", got);
    return fault_did_you_mean(fault, "", got, names, INTEGRATORS);
}

int settings_integrator(RunSpec *spec, Plan *plan, const double run[], Fault *fault)
{
    Setup *s = &plan->setup;
    const Method *m = s->method;
    const bool coulomb = plan->scene.problem->part && plan->scene.contact == CONTACT_BARDENHAGEN;
    const unsigned contact = coulomb ? 1u << CD | 1u << USL : ~0u; /* contact.c says why */
    const Method *b = s->method_b; /* of the second body, if it is another */
    if (!spec->integrator[0]) {
        int usual = m ? m->integrator[DIM] : CD;
        if (b && !(b->valid >> usual & 1)) usual = b->integrator[DIM];
        if (!(contact >> usual & 1)) usual = CD;
        strcpy(spec->integrator, step_integrators[usual].name);
    }
    while (s->integrator < INTEGRATORS &&
           strcmp(spec->integrator, step_integrators[s->integrator].name))
        s->integrator++;
    if (s->integrator == INTEGRATORS) return unknown_integrator(spec->integrator, fault);
    s->refresh = run[P_REFRESH] > 0;
    if (!m) {
        if (s->integrator == CD) return 0;
        return fault_set(fault, FAULT_USAGE, "--integrator: got '%s', %s takes cd only",
                         spec->integrator, spec->method);
    }
    if (!(contact >> s->integrator & 1) && !(run[P_ALLOW] > 0))
        return fault_set(fault, FAULT_USAGE,
                         "--integrator: got '%s', which gains energy where two bodies touch: %s "
                         "takes cd or usl; contact=none or allow_unstable=1 runs it",
                         spec->integrator, spec->problem);
    const unsigned other = b ? b->valid | (s->refresh ? b->valid_fresh : 0) : ~0u;
    const unsigned valid = (m->valid | (s->refresh ? m->valid_fresh : 0)) & other;
    if (valid >> s->integrator & 1 || run[P_ALLOW] > 0) return 0;
    return fault_set(
        fault, FAULT_USAGE,
        "--integrator: got '%s', which is unstable with %s%s; allow_unstable=1 runs it",
        spec->integrator, spec->method,
        (b ? m->valid_fresh | b->valid_fresh : m->valid_fresh) >> s->integrator & 1
            ? " (stable with --set refresh=1)"
            : "");
}

/* Do the method's stencils widen with the particles, with these parameters? */
static bool has_boxes(const Method *m, const double par[])
{
    const Method own = method_adapted(m, par);
    return !own.list && own.width(1) > own.width(0.5);
}

void settings_default_parameters(const Method *m, double par[])
{
    for (int k = 0; k < MAX_PARAMS; k++) par[k] = 0;
    for (const Param *p = m->info.params; p && p->name; p++) par[p - m->info.params] = p->value;
}

bool settings_act_on_problem(int k, const Problem *p)
{
    const bool still = k == P_LAYOUT || k == P_DIM || k == P_REPEAT || k == P_PARTICLES;
    return (still || !p->projection) && (DIM == 1 || k != P_PARTICLES);
}

bool settings_act_on_method(int k, const Method *m)
{
    const unsigned all = (1u << INTEGRATORS) - 1;
    double par[MAX_PARAMS];
    if (k == P_STEPS || k == P_STOP || k == P_REPEAT || k == P_DIM || k == P_DT) return true;
    if (!m) return false; /* a mesh */
    settings_default_parameters(m, par);
    if (k == P_PARTICLES) return DIM == 1;
    if (k == P_ALLOW) return m->valid != all;
    if (k == P_REFRESH) return m->keeps_L;
    if (k == P_FRAME) return !m->assemble && !m->integrate;
    return k == P_DOMAIN ? has_boxes(m, par) : true;
}

/* Particle boxes and the update of F, which are the run's choice like the integrator. */
int settings_strain(const RunSpec *spec, Plan *plan, const double run[], Fault *fault)
{
    Setup *s = &plan->setup;
    s->domain = (Domain)run[P_DOMAIN];
    s->strain = (StrainUpdate)run[P_STRAIN];
    s->subcycles = (int)run[P_SUBCYCLES];
    const bool boxes = (s->method && has_boxes(s->method, plan->method_par)) ||
                       (s->method_b && has_boxes(s->method_b, plan->second_par));
    if (s->domain != DOMAIN_FXX && !boxes)
        return fault_set(fault, FAULT_USAGE,
                         "--set domain: got '%s', takes fxx with %s, which sees no particle's size",
                         spec_get(spec, "domain"), spec->method);
    if (s->strain != STRAIN_LINEAR && !s->method)
        return fault_set(fault, FAULT_USAGE,
                         "--set strain_update: got '%s', takes linear with %s, whose strain comes "
                         "from positions",
                         spec_get(spec, "strain_update"), spec->method);
    return 0;
}

/* A wall that the body does not touch at the start. In the reference it never would. */
static bool meets_walls_later(const Scene *s)
{
    for (const Wall *w = s->wall; w < s->wall + s->nwall; w++) {
        const double body = w->side < 0 ? s->body_lo[w->axis] : s->body_hi[w->axis];
        if (!w->mirror && w->side * (w->at - body) > 1e-9) return true;
    }
    return false;
}

double settings_usual(const Param *p, const Setup *s)
{
    const Method *const both[] = {s->method, s->method_b};
    double value = p->value;
    for (int k = 0; k < 2; k++) {
        if (!both[k]) continue;
        if (p == &settings_common[P_LAYOUT] && both[k]->surface) value = 1;
        if (p == &settings_common[P_FRAME] && both[k]->frame == FRAME_TOTAL) value = FRAME_TOTAL;
    }
    return value;
}

/* Frame of the stencils: what is asked for, or the method's. */
int settings_frame(const RunSpec *spec, Plan *plan, const double run[], Fault *fault)
{
    Setup *s = &plan->setup;
    const char *given = spec_get(spec, "frame");
    s->frame = given ? (Frame)run[P_FRAME] : (Frame)settings_usual(&settings_common[P_FRAME], s);
    if (s->frame != FRAME_TOTAL) return 0;
    if (!s->method || s->method->assemble || s->method->integrate)
        return fault_set(fault, FAULT_USAGE,
                         "--set frame: got 'total', takes current with %s, which %s", spec->method,
                         s->method ? "integrates over cells as the body fills them now"
                                   : "has no particles");
    if (plan->scene.problem->part)
        return fault_set(fault, FAULT_USAGE,
                         "--set frame: got 'total'%s, takes current with %s, whose two bodies meet "
                         "where they are now",
                         given ? "" : " (the method's default)", spec->problem);
    if (meets_walls_later(&plan->scene))
        return fault_set(
            fault, FAULT_USAGE,
            "--set frame: got 'total'%s, takes current with %s, whose body meets walls "
            "that it does not touch at the start",
            given ? "" : " (the method's default)", spec->problem);
    if (s->domain == DOMAIN_STRETCH || s->strain != STRAIN_LINEAR)
        return fault_set(fault, FAULT_USAGE,
                         "--set %s: got '%s', takes %s with frame=total, where nothing but F "
                         "follows the motion",
                         s->domain == DOMAIN_STRETCH ? "domain" : "strain_update",
                         spec_get(spec, s->domain == DOMAIN_STRETCH ? "domain" : "strain_update"),
                         s->domain == DOMAIN_STRETCH ? "undeformed" : "linear");
    return 0;
}
