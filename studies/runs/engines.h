/* engines.h: problems, methods and parameters that the dimensions of this program know, by name. */
#ifndef MPMLAB_ENGINES_H
#define MPMLAB_ENGINES_H

#include <stdbool.h>
#include "common/run/engine.h"

/* The names that any engine knows, each once; at most max. How many. */
int engine_problem_names(const char *names[], int max);
int engine_method_names(const char *names[], int max);

/* Checks the name of a problem or of a method: 0, or a fault that names the nearest one. */
int engine_check_problem(const char *name, Fault *fault);
int engine_check_method(const char *option, const char *name, Fault *fault);

/* The description of that name in a list that a NULL ends, or NULL. */
const Info *engine_info_in(const Info *const *list, const char *name);

/* The description of a problem or a method by the first engine that has it; NULL: none has it. */
const Info *engine_problem(const char *name);
const Info *engine_method(const char *name);

/* "GE-GIMP" for "ge_gimp", from any dimension; or the name itself. */
const char *engine_label(const char *method);

/* Loops over the methods of an engine in the registry's order, each as `const Info *m`: EACH_METHOD
 * over all, EACH_GRID_METHOD over those with a grid. */
#define EACH_METHOD(m, engine)                                                                     \
    for (const Info *const *m##_place = (engine)->methods, *m; (m = *m##_place); m##_place++)
#define EACH_GRID_METHOD(m, engine)                                                                \
    EACH_METHOD(m, engine)                                                                         \
        if (engine_has_grid(engine, m->name))

/* The line of a method in figures of all methods: how many stand before it in the registry, those
 * on request not counted. */
int engine_line(const Engine *engine, const char *method);

/* Does the engine know this problem? */
bool engine_has_problem(const Engine *engine, const char *name);

/* Does this method have a grid (and particles)? FEM has none. */
bool engine_has_grid(const Engine *engine, const char *method);

#endif
