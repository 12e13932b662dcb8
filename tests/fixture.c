/* fixture.c: see fixture.h. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "fixture.h"

static void set_all(RunSpec *spec, const char *list)
{
    char pair[128];
    while (list && *list) {
        const size_t n = strcspn(list, ";");
        CU_ASSERT_FATAL(n < sizeof pair);
        memcpy(pair, list, n);
        pair[n] = 0;
        CU_ASSERT(spec_set(spec, pair, NULL) == 0);
        list += n + (list[n] == ';');
    }
}

RunSpec fixture_spec(const Case *c, const char *method, const char *integrator, const char *more)
{
    RunSpec spec = {.cells = c->cells, .ppc = c->ppc, .cfl = c->cfl};
    strcpy(spec.problem, c->problem);
    if (method) strcpy(spec.method, method);
    if (integrator) strcpy(spec.integrator, integrator);
    check_context_of(DIM, &spec);
    set_all(&spec, c->set);
    set_all(&spec, more);
    check_context_of(DIM, &spec);
    return spec;
}

bool fixture_plan(Fixture *r, const Case *c, const char *method, Integrator integrator,
                  const char *more)
{
    r->fault = (Fault){0};
    r->spec = fixture_spec(c, method, step_integrators[integrator].name, more);
    if (plan_make(&r->spec, &r->plan, &r->fault)) return false;
    r->dt = r->plan.cfl * r->plan.scene.cell / r->plan.scene.c;
    return true;
}

void fixture_scene(Fixture *r, const Problem *problem, const Method *method, Integrator integrator,
                   int cells, double ppc)
{
    char why[128];
    check_context(DIM, problem->info.name, method->info.name, step_integrators[integrator].name,
                  NULL);
    *r = (Fixture){.plan = {.scene = {.problem = problem, .cell = 1.0 / cells}}};
    Plan *plan = &r->plan;
    plan->scene.par = plan->problem_par;
    CU_ASSERT_FATAL(problem->init(&plan->scene, why) == 0);
    const Param *own = method->info.params;
    for (int k = 0; own && own[k].name; k++) plan->method_par[k] = own[k].value;
    plan->setup = (Setup){.scene = &plan->scene,
                          .method = method,
                          .method_par = plan->method_par,
                          .integrator = integrator,
                          .frame = method->frame,
                          .cells = cells,
                          .ppc = ppc,
                          .snapshot_nodes = true,
                          .threads = 1};
    plan->solver = &particle_solver;
    for (const Param *p = method->info.params; p && p->name; p++)
        plan->method_par[p - method->info.params] = p->value;
    r->dt = problem->cfl * plan->scene.cell / plan->scene.c;
}

Scene fixture_bare_scene(const Problem *problem, const double par[], double cell)
{
    Scene s = {.problem = problem, .par = par, .cell = cell};
    char why[128];
    check_context(DIM, problem->info.name, "none", "none", NULL);
    CU_ASSERT_FATAL(problem->init(&s, why) == 0);
    return s;
}

Sim *fixture_sim(Fixture *r)
{
    Sim *sim = sim_new(&r->plan.setup, &r->fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(sim);
    return sim;
}

bool fixture_steps(const Fixture *r, Sim *sim, int from, int to)
{
    for (int k = from; k < to; k++)
        if (sim_step(sim, k * r->dt, r->dt, k == 0).code != OK) return false;
    return true;
}

double *fixture_state(const Sim *sim)
{
    const Particles *p = &sim->p;
    const size_t count = (size_t)p->count;
    double *state = calloc(FIELDS * count + 1, sizeof *state);
    CU_ASSERT_PTR_NOT_NULL_FATAL(state);
    for (int f = 0; f < FIELDS; f++)
        for (int s = 0; s < p->n && p->field[f]; s++)
            if (p->id[s] >= 0) state[(size_t)f * count + (size_t)p->id[s]] = p->field[f][s];
    return state;
}

double fixture_gap(const double *a, const double *b, int count, int field, int components)
{
    double most = 0;
    for (int k = field * count; k < (field + components) * count; k++)
        most = fabs(a[k] - b[k]) <= most ? most : fabs(a[k] - b[k]);
    return most;
}

double fixture_size(const double *a, int count, int field, int components)
{
    double most = 0;
    for (int k = field * count; k < (field + components) * count; k++)
        most = fabs(a[k]) <= most ? most : fabs(a[k]);
    return most;
}

double fixture_distance(const double *a, const double *b, int count, bool L)
{
    const int group[][2] = {{AT_X, DIM}, {AT_V, DIM}, {AT_F, NMAT}, {AT_L, NMAT}};
    double most = 0;
    for (int g = 0; g < (L ? 4 : 3); g++) {
        const double gap = fixture_gap(a, b, count, group[g][0], group[g][1]);
        const double size = fixture_size(a, count, group[g][0], group[g][1]);
        if (gap > 0 || isnan(gap)) most = gap / size <= most ? most : gap / size;
    }
    return most;
}

static const Param *param_of(const Method *m, const char *name)
{
    for (const Param *p = m->info.params; p && p->name; p++)
        if (strcmp(p->name, name) == 0) return p;
    return NULL;
}

/* Share of v that a method replaces with parameter k (-1: none) in the middle of its range. */
static double pic_of(const Method *m, int k)
{
    double par[MAX_PARAMS] = {0};
    const Param *p = m->info.params;
    for (int n = 0; p && p[n].name; n++) par[n] = n == k ? 0.5 * (p[n].min + p[n].max) : p[n].value;
    return method_adapted(m, par).pic;
}

double fixture_pic(const Method *m)
{
    return pic_of(m, -1);
}

/* The number among a method's parameters that changes this share, or NULL. */
static const Param *share_of(const Method *m)
{
    for (const Param *p = m->info.params; p && p->name; p++)
        if (!p->choices && fabs(pic_of(m, (int)(p - m->info.params)) - fixture_pic(m)) > 0)
            return p;
    return NULL;
}

/* The parameter of variant k > 0 and its value there; NULL: there is none. */
static const Param *variant_of(const Method *m, int k, double *value)
{
    const Param *shape = param_of(m, "shape"), *p = k == 2 ? param_of(m, "order") : share_of(m);
    const double values[VARIANTS] = {0, shape && !(shape->value > 0), 3 - 1, 0, 2};
    if (k == 1 || k == 4) p = shape && values[k] <= shape->max ? shape : NULL;
    if (p) *value = k == 3 ? 0.5 * (p->min + p->max) : values[k];
    return p;
}

bool fixture_variant(const Method *m, int k, const char *more, char set[VARIANT_TEXT])
{
    double value = 0;
    const Param *p = k ? variant_of(m, k, &value) : NULL;
    char text[64];
    if (p) info_param_print(p, value, text);
    if (p) snprintf(set, VARIANT_TEXT, "%s=%s;%s", p->name, text, more);
    if (!k) snprintf(set, VARIANT_TEXT, "%s", more);
    return !k || p;
}

bool fixture_vary(Fixture *r, int k)
{
    const Method *m = r->plan.setup.method;
    double value = 0;
    const Param *p = k ? variant_of(m, k, &value) : NULL;
    if (p) r->plan.method_par[p - m->info.params] = value;
    return !k || p;
}

bool fixture_valid(const Method *m, Integrator i, bool refresh)
{
    return (m->valid | (refresh ? m->valid_fresh : 0)) >> i & 1;
}

/* Knuth's 64-bit linear congruence, upper bits. */
double fixture_random(double lo, double hi)
{
    static unsigned long long state = 20070401;
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return lo + (hi - lo) * (double)(state >> 11) / 9007199254740992.0;
}
