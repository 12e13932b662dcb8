/* engine.c: this dimension's Engine, the one symbol that stays visible after linking. */
#include <math.h>
#include <string.h>
#include "settings.h"
#include "common/core/step.h"

static int resolve(RunSpec *spec, Fault *fault)
{
    Plan plan;
    return plan_make(spec, &plan, fault);
}

static void say_param(const Param *p, FILE *out)
{
    char value[64];
    info_param_print(p, p->value, value);
    fprintf(out, "%s\t%s\t%s\t%s%s%s%s\t%s\n", p->name, value, *p->unit ? p->unit : "-", p->meaning,
            p->choices ? " (" : "", p->choices ? p->choices : "", p->choices ? ")" : "", p->source);
}

static void say_params(const Param *p, FILE *out)
{
    for (; p && p->name; p++) say_param(p, out);
}

static void say_info(const Info *info, const char *kind, FILE *out)
{
    fprintf(out, "%s\t%s\t%dD\t%s\nsource\t%s\n", kind, info->name, DIM, info->about,
            info->source ? info->source : "own");
    if (info->formula) fprintf(out, "formula\t%s\n", info->formula);
}

static void say_header(FILE *out)
{
    fprintf(out, "parameter\tdefault\tunit\tmeaning\tsource\n");
}

/* What errors are divided by, as a formula and as the number that it is by default. */
static void say_scale(const Info *info, const Scene *scene, FILE *out)
{
    if (!info->scale)
        fprintf(out, "errors over\tnothing: no exact solution\n");
    else if (scene->problem->projection || isnan(scene->error_scale))
        fprintf(out, "errors over\t%s\n", info->scale);
    else
        fprintf(out, "errors over\t%s\t%.9g m\n", info->scale, scene->error_scale);
}

/* The law (W11 eqs 31, 32) and its constants with the scene's default parameters. */
static void say_material(const Material *m, FILE *out)
{
    static const char *const state[] = {"", "uniaxial strain, nu = 0", "plane strain", "3D"};
    fprintf(out, "material\t%s\t%s\n",
            m->law == LINEAR ? "linear: P = lambda tr(e) I + 2 mu e, e = (F + F^T)/2 - I"
                             : "neo-Hookean: J sigma = lambda ln J I + mu (F F^T - I)",
            state[DIM]);
    fprintf(out, "material\t%.9g\tPa\tYoung's modulus E\n", m->E);
    fprintf(out, "material\t%.9g\t-\tPoisson's ratio nu\n", m->nu);
    fprintf(out, "material\t%.9g\tkg/m^3\tdensity rho at rest\n", m->rho);
}

static void say_problem(const Problem *p, FILE *out)
{
    RunSpec spec = {0};
    Plan plan;
    strcpy(spec.problem, p->info.name);
    if (plan_make(&spec, &plan, NULL)) return;
    const Material *m = &plan.scene.mat;
    say_info(&p->info, "problem", out);
    say_scale(&p->info, &plan.scene, out);
    say_header(out);
    fprintf(out, "cells\t%g\t1/m\tcells per unit length\t\n", p->cells);
    fprintf(out, "ppc\t%g\t-\tparticles per cell\t\n", p->ppc);
    if (!p->projection) {
        fprintf(out, "cfl\t%g\t-\ttime step over h/c\t\n", p->cfl);
        if (p->steps)
            fprintf(out, "t_end\t%g\tsteps\tend of the run\t\n", (double)p->steps);
        else
            fprintf(out, "t_end\t%.9g\ts\tend of the run\t\n", plan.scene.t_end);
    }
    say_params(p->info.params, out);
    for (int k = 0; k < RUN_PARAMS; k++)
        if (settings_act_on_problem(k, p)) say_param(&settings_common[k], out);
    if (p->projection) return;
    say_material(m, out);
    fprintf(out, "wave speed\t%.9g\tm/s\tc in dt0 = CFL h/c\t\n", plan.scene.c);
    fprintf(out, "wave speed\t%.9g\tm/s\tbar, sqrt(E/rho)\t\n", material_wave_speed_bar(m));
    fprintf(out, "wave speed\t%.9g\tm/s\tP wave, sqrt((lambda + 2 mu)/rho)\t\n",
            material_wave_speed_p(m));
    fprintf(out, "wave speed\t%.9g\tm/s\tupper bound, sqrt((lambda + 3 mu)/rho)\tW11 eq 33\n",
            material_wave_speed_bound(m));
}

static void say_integrators(unsigned set, const char *more, FILE *out)
{
    if (!set) return;
    fprintf(out, "integrators\t");
    for (int i = 0, n = 0; i < INTEGRATORS; i++)
        if (set >> i & 1) fprintf(out, "%s%s", n++ ? " " : "", step_integrators[i].name);
    fprintf(out, "\t%s\n", more);
}

/* With the usual integrator and parameters and no body force; of a mesh solver (NULL) not said. */
static void say_memory(const Method *m, FILE *out)
{
    double par[MAX_PARAMS];
    if (!m) return;
    settings_default_parameters(m, par);
    const Setup setup = {.method = m, .integrator = (Integrator)m->integrator[DIM]};
    const Sim sim = {.setup = &setup, .method = method_adapted(m, par)};
    fprintf(out, "memory\t%g\tbytes\tper particle in %dD\n", sim_particle_bytes(&sim), DIM);
    fprintf(out, "memory\t%g\tbytes\tper live node in %dD\n", sim_node_bytes(&sim), DIM);
}

/* m: NULL for a mesh solver. */
static void say_method(const Info *info, const Method *m, FILE *out)
{
    char usual[64];
    snprintf(usual, sizeof usual, "default %s", step_integrators[m ? m->integrator[DIM] : CD].name);
    say_info(info, "method", out);
    say_integrators(m ? m->valid : 1u << CD, usual, out);
    say_memory(m, out);
    if (m) say_integrators(m->valid_fresh & ~m->valid, "with --set refresh=1", out);
    say_header(out);
    say_params(info->params, out);
    for (int k = 0; k < RUN_PARAMS; k++) {
        Param p = settings_common[k];
        p.value = settings_usual(&settings_common[k], &(Setup){.method = m});
        if (settings_act_on_method(k, m)) say_param(&p, out);
    }
}

/* The methods that an integrator is stable with. */
static void say_integrator(int i, FILE *out)
{
    say_info(&step_integrators[i], "integrator", out);
    for (int fresh = 0; fresh < 2; fresh++) {
        int n = 0;
        for (const Method *const *m = methods; *m; m++)
            if ((fresh ? (*m)->valid_fresh & ~(*m)->valid : (*m)->valid) >> i & 1)
                fprintf(out, "%s%s", n++ ? " " : "methods\t", (*m)->info.name);
        if (n) fprintf(out, "\t%s\n", fresh ? "with --set refresh=1" : "");
    }
}

static const Method *plugin_named(const char *name)
{
    for (const Method *const *m = methods; *m; m++)
        if (strcmp((*m)->info.name, name) == 0) return *m;
    return NULL;
}

static int describe(const char *name, FILE *out)
{
    for (const Problem *const *p = problems; *p; p++)
        if (strcmp((*p)->info.name, name) == 0) {
            say_problem(*p, out);
            return 0;
        }
    for (const Info *const *m = method_infos; *m; m++)
        if (strcmp((*m)->name, name) == 0) {
            say_method(*m, plugin_named(name), out);
            return 0;
        }
    for (int i = 0; i < INTEGRATORS; i++)
        if (strcmp(step_integrators[i].name, name) == 0) {
            say_integrator(i, out);
            return 0;
        }
    return -1;
}

/* Is the displacement at the end a number (scan knows it for one of its loads only)? Asked at a
 * point on no axis of symmetry. */
static int has_exact(const char *name)
{
    RunSpec spec = {0};
    Plan plan;
    snprintf(spec.problem, sizeof spec.problem, "%s", name);
    if (plan_make(&spec, &plan, NULL) || !plan.scene.problem->exact) return 0;
    const Scene *s = &plan.scene;
    double X[DIM], u[DIM] = {0};
    const double *at[DIM];
    double *to[DIM];
    for (int d = 0; d < DIM; d++) {
        X[d] = s->body_lo[d] + (0.6 + 0.1 * d) * (s->body_hi[d] - s->body_lo[d]);
        at[d] = &X[d];
        to[d] = &u[d];
    }
    s->problem->exact(s, 1, at, s->t_end, to);
    return !isnan(u[0]);
}

/* A chunk of one position; the other 63 see the same. */
static int weight(const char *name, double x, double l, double *S, double *G)
{
    const Axis open_axis = {
        .wall_lo = -INFINITY, .wall_hi = INFINITY, .open_lo = true, .open_hi = true};
    Field at, half;
    Stencil s;
    for (int p = 0; p < CHUNK; p++) at[p] = x + (double)MAX_WIDTH, half[p] = l;
    for (const Method *const *m = methods; *m; m++) {
        if (strcmp((*m)->info.name, name) != 0) continue;
        if ((*m)->list) return 1;
        const int width = (*m)->width(l);
        (*m)->shape(&open_axis, width, at, half, &s);
        const long long node = (long long)MAX_WIDTH - s.base[0];
        const bool seen = node >= 0 && node < width;
        *S = seen ? s.table[T_S][seen ? node : 0][0] : 0;
        *G = seen ? s.table[T_G][seen ? node : 0][0] : 0;
        return 0;
    }
    return -1;
}

static const Info *const integrator_infos[] = {&step_integrators[CD],   &step_integrators[UVF],
                                               &step_integrators[MUSL], &step_integrators[USL],
                                               &step_integrators[USF],  NULL};

const Engine ENGINE_NAME = {
    .dim = DIM,
    .problems = problem_infos,
    .methods = method_infos,
    .integrators = integrator_infos,
    .settings = &settings_common,
    .resolve = resolve,
    .run = run_spec,
    .describe = describe,
    .has_exact = has_exact,
    .weight = weight,
};
