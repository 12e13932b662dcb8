/* fixture.h: how tests of the particle core set up scenes and read particles in placement order. */
#ifndef MPMLAB_FIXTURE_H
#define MPMLAB_FIXTURE_H

#include "common/run/plan.h"
#include "common/core/sim.h"
#include "common/core/step.h"
#include "check.h"

/* A run of a registered problem; 0 or NULL: the default. Only of dimension `dim`. */
typedef struct Case {
    int dim;
    const char *problem;
    double cells, ppc, cfl;
    const char *set; /* "name=value;name=value" */
} Case;

/* A resolved case. */
typedef struct Fixture {
    RunSpec spec;
    Plan plan;
    Fault fault;
    double dt; /* [s] CFL h/c */
} Fixture;

extern const Engine ENGINE_NAME; /* of this dimension */

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/* Resolves a case; false: refused, r->fault says why. method, more: may be NULL. */
bool fixture_plan(Fixture *r, const Case *c, const char *method, Integrator integrator,
                  const char *more);

/* The spec alone, defaults not filled. */
RunSpec fixture_spec(const Case *c, const char *method, const char *integrator, const char *more);

/* The same for a scene made by hand: fills plan and dt. `problem` need not be registered. */
void fixture_scene(Fixture *r, const Problem *problem, const Method *method, Integrator integrator,
                   int cells, double ppc);

/* A scene by itself, without a method: made with these parameters for this cell size [m]. */
Scene fixture_bare_scene(const Problem *problem, const double par[], double cell);

/* Particles of r; never NULL (the test ends instead). */
Sim *fixture_sim(Fixture *r);

/* Steps [from, to) of r->dt; false after the first failure. */
bool fixture_steps(const Fixture *r, Sim *sim, int from, int to);

/* Every field of every particle: [FIELDS][count], by id; absent fields are 0. To be freed. */
double *fixture_state(const Sim *sim);

/* max |a - b| and max |a| of `components` fields from `field` on; NAN wins. */
double fixture_gap(const double *a, const double *b, int count, int field, int components);
double fixture_size(const double *a, int count, int field, int components);

/* The largest of fixture_gap/fixture_size over x, v, F and (if L) L. */
double fixture_distance(const double *a, const double *b, int count, bool L);

/* All pairs that the tests run: NULL-terminated methods[] times INTEGRATORS. */
#define FOR_METHODS(m)     for (const Method *const *m = methods; *m; m++)
#define FOR_INTEGRATORS(i) for (Integrator i = CD; i < INTEGRATORS; i++)

/* Settings of variant k of a method, then `more`: 0 its defaults, 1 its other shape, 2 an odd order
 * of its filter, 3 half of the share of v that its parameters let it replace, 4 its third shape.
 * False: it has none such. */
enum { VARIANTS = 5, VARIANT_TEXT = 128 };
bool fixture_variant(const Method *m, int k, const char *more, char set[VARIANT_TEXT]);

/* The same for a scene made by hand. */
bool fixture_vary(Fixture *r, int k);

/* Is this pair stable without being told so? With refresh: with refresh=1. */
bool fixture_valid(const Method *m, Integrator i, bool refresh);

/* Share of v that the method replaces with its usual parameters. */
double fixture_pic(const Method *m);

/* A reproducible random number in [lo, hi). */
double fixture_random(double lo, double hi);

#endif
