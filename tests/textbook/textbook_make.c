/* textbook_make.c: the twin's particles, grid and walls from a Setup; and its time. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "common/contract/layout.h"
#include "textbook_sight.h"

enum { GHOSTS = 8 }; /* nodes beyond the domain */

/* A smooth weight's force fades with its mass, a tent's does not (common/core/sim.c has the
 * reason). */
#define TENT_LEAST IN_THIS_DIM(1e-12, 1e-24, 1e-36)
static const TwinMethod known[] = {
    {.name = "mpm", .shape = TWIN_TENT, .least = TENT_LEAST},
    {.name = "gimp", .shape = TWIN_BOX, .least = 1e-24},
    {.name = "ge_mpm", .shape = TWIN_TENT, .gradient = true, .least = TENT_LEAST},
    {.name = "ge_gimp", .shape = TWIN_BOX, .gradient = true, .least = 1e-24},
    {.name = "bspline", .shape = TWIN_SPLINE, .least = 1e-24},
    {.name = "apic", .gradient = true, .pic = 1, .moments = true, .least = 1e-24},
    {.name = "tpic", .gradient = true, .pic = 1, .least = 1e-24},
    {.name = "xpic", .pic = 1, .filter = TWIN_PARTICLES, .least = 1e-24},
    {.name = "fmpm", .pic = 1, .filter = TWIN_NODES, .least = 1e-24},
    {.name = "bspline3", .shape = TWIN_CUBIC, .least = 1e-24},
    {.name = "tlmpm", .least = TENT_LEAST},
    {.name = "mls_mpm",
     .shape = TWIN_SPLINE,
     .gradient = true,
     .pic = 1,
     .fitted = true,
     .least = 1e-24},
    {.name = "polypic", .shape = TWIN_SPLINE, .pic = 1, .modes = true, .least = 1e-24},
    {.name = "cpdi", .shape = TWIN_CPDI, .least = 1e-24},
    {.name = "cpdi2", .shape = TWIN_CPDI2, .least = 1e-24},
    {.name = "impm", .shape = TWIN_SPLINE, .cells = true, .least = 1e-24},
    {.name = "flip_pic", .shape = TWIN_BOX, .least = 1e-24}};

static void make_grid(Twin *w)
{
    const Scene *scene = w->setup->scene;
    const int cells = w->setup->cells;
    w->nodes = 1;
    for (int d = 0; d < DIM; d++) {
        w->origin[d] = (int)lround(scene->lo[d] * cells) - GHOSTS;
        w->size[d] = (int)lround(scene->hi[d] * cells) + GHOSTS + 1 - w->origin[d];
        w->nodes *= w->size[d];
    }
}

/* Splines fold at walls that the body cannot leave. */
static void find_walls(Twin *w)
{
    const Scene *scene = w->setup->scene;
    for (int d = 0; d < DIM; d++) w->wall_lo[d] = -INFINITY, w->wall_hi[d] = INFINITY;
    for (int k = 0; k < scene->nwall; k++) {
        const Wall *wall = &scene->wall[k];
        if (wall->mirror || !(wall->hold >> wall->axis & 1)) continue;
        (wall->side < 0 ? w->wall_lo : w->wall_hi)[wall->axis] = round(wall->at * w->setup->cells);
    }
}

/* A wall holds the nodes on it and all beyond. */
static void hold_walls(Twin *w)
{
    const Scene *scene = w->setup->scene;
    for (long i = 0; i < w->nodes; i++)
        for (int k = 0; k < scene->nwall; k++) {
            const Wall *wall = &scene->wall[k];
            long rest = i;
            for (int d = 0; d < wall->axis; d++) rest /= w->size[d];
            const double index = (double)(rest % w->size[wall->axis] + w->origin[wall->axis]);
            const double beyond = wall->side * (index - wall->at * w->setup->cells);
            if (!wall->mirror && beyond > -1e-6) w->node[i].held |= wall->hold;
        }
}

static void place_one(Twin *w, const Layout *layout, int k)
{
    const Scene *scene = w->setup->scene;
    TwinParticle *p = &w->p[w->n];
    const double *X[DIM];
    double u[DIM] = {0}, *at[DIM], *v[DIM], *F[NMAT], *L[NMAT];
    if (!(layout->volume[k] > 0)) return; /* surface particles */
    *p = (TwinParticle){.id = w->n, .V0 = layout->volume[k]};
    if (w->more) p->more = &w->more[w->n];
    w->n++;
    p->m = p->V0 * scene->mat.rho;
    for (int d = 0; d < DIM; d++) {
        p->X[d] = layout->X[d][k];
        p->F[d][d] = 1;
        X[d] = &p->X[d], at[d] = &u[d], v[d] = &p->v[d];
    }
    for (int k2 = 0; k2 < NMAT; k2++)
        F[k2] = &p->F[k2 / DIM][k2 % DIM], L[k2] = &p->L[k2 / DIM][k2 % DIM];
    if (scene->problem->start) scene->problem->start(scene, 1, X, at, v, F, L);
    for (int d = 0; d < DIM; d++) p->x[d] = p->X[d] + u[d];
    if (is_total(w)) twin_refer_gradient(p);
}

static void start_corners(const Twin *w, TwinParticle *p)
{
    double F[DIM][DIM] = {{0}}, x[DIM];
    for (int a = 0; a < DIM; a++) {
        x[a] = place(w, p, a);
        for (int b = 0; b < DIM; b++) F[a][b] = is_total(w) ? a == b : p->F[a][b];
    }
    place_corners(x, (const double(*)[DIM])F, w->half * w->h, p->more->corner);
}

/* Value of a method's parameter; `other` if it has none such. */
static double value_of(const Setup *setup, const char *name, double other)
{
    const Param *own = setup->method->info.params;
    for (int k = 0; own && own[k].name; k++)
        if (strcmp(own[k].name, name) == 0) return setup->method_par[k];
    return other;
}

/* The method by name, in the variant that is set; false if the twin does not know it. */
static bool choose(Twin *w, const Setup *setup)
{
    const char *name = setup->method->info.name;
    size_t k = 0;
    while (k < sizeof known / sizeof *known && strcmp(known[k].name, name)) k++;
    if (k == sizeof known / sizeof *known) return false;
    *w = (Twin){.setup = setup, .method = known[k], .h = 1.0 / setup->cells};
    static const TwinShape shapes[] = {TWIN_SPLINE, TWIN_BOX, TWIN_CUBIC};
    const int shape = (int)value_of(setup, "shape", -1);
    if (shape >= 0) w->method.shape = shapes[w->method.fitted ? 2 * shape : shape];
    w->method.pic = 1 - value_of(setup, "alpha", 1 - w->method.pic);
    w->order = 1 + (int)value_of(setup, "order", 0);
    return true;
}

/* Moments of the initial gradient: B = L D. */
static void gather_start_moments(Twin *w)
{
    for (int k = 0; k < w->n && w->method.moments; k++) {
        TwinParticle *p = &w->p[k];
        Sight s[3];
        look_around(w, p, s);
        for (int b = 0; b < DIM; b++) {
            const double D = spread(w, p, s, b);
            for (int a = 0; a < DIM; a++) p->L[a][b] *= D;
        }
    }
}

Twin *twin_new(const Setup *setup)
{
    const double n = pow(setup->ppc, 1.0 / DIM);
    Layout layout = {0};
    Twin *w = calloc(1, sizeof *w);
    if (!w || !choose(w, setup)) {
        free(w);
        return NULL;
    }
    w->half = 0.5 / n;
    make_grid(w);
    find_walls(w);
    const int bad = layout_make(&layout, setup->scene, 1.0 / setup->cells / n, setup->count,
                                setup->fitted, NULL);
    w->p = calloc((size_t)layout.n + 1, sizeof *w->p);
    w->node = calloc((size_t)w->nodes, sizeof *w->node);
    const bool keeps = w->method.modes || w->method.shape == TWIN_CPDI2;
    if (keeps) w->more = calloc((size_t)layout.n + 1, sizeof *w->more);
    const bool good =
        !bad && w->p && w->node && (!keeps || w->more) && (!w->method.cells || twin_make_fits(w));
    for (int k = 0; k < layout.n && good; k++) place_one(w, &layout, k);
    for (int k = 0; k < w->n && good && keeps; k++) start_corners(w, &w->p[k]);
    layout_free(&layout);
    if (good) {
        hold_walls(w);
        gather_start_moments(w);
        return w;
    }
    twin_free(w);
    return NULL;
}

void twin_free(Twin *w)
{
    if (!w) return;
    free(w->p);
    free(w->more);
    free(w->node);
    free(w->fit);
    free(w);
}

double twin_ns(const Setup *setup, double dt, int steps)
{
    Twin *w = twin_new(setup);
    if (!w) return NAN;
    const clock_t start = clock();
    for (int k = 0; k < steps; k++) twin_step(w, k * dt, dt, k == 0);
    const double ns = 1e9 * (double)(clock() - start) / CLOCKS_PER_SEC / steps / w->n;
    twin_free(w);
    return ns;
}
