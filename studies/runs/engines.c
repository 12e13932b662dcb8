/* engines.c: the dimensions of this program, and which of them a run is for. */
#include <stdio.h>
#include <string.h>
#include "engines.h"
#include "options.h"

const Engine *const engines[] = {&engine_1d, &engine_2d, &engine_3d, NULL};

enum { MOST_NAMES = 64 };

const Info *engine_info_in(const Info *const *list, const char *name)
{
    while (*list && strcmp((*list)->name, name) != 0) list++;
    return *list;
}

const Info *engine_problem(const char *name)
{
    const Info *found = NULL;
    for (const Engine *const *e = engines; *e && !found; e++)
        found = engine_info_in((*e)->problems, name);
    return found;
}

const Info *engine_method(const char *name)
{
    const Info *found = NULL;
    for (const Engine *const *e = engines; *e && !found; e++)
        found = engine_info_in((*e)->methods, name);
    return found;
}

const char *engine_label(const char *method)
{
    const Info *info = engine_method(method);
    return info ? info->label : method;
}

int engine_line(const Engine *engine, const char *method)
{
    int line = 0;
    for (const Info *const *m = engine->methods; *m && strcmp((*m)->name, method) != 0; m++)
        line += !(*m)->on_request;
    return line;
}

bool engine_has_problem(const Engine *engine, const char *name)
{
    return engine_info_in(engine->problems, name) != NULL;
}

bool engine_has_grid(const Engine *engine, const char *method)
{
    double S, G;
    return engine->weight(method, 0, 0.25, &S, &G) >= 0;
}

static int gather(const Info *const *list, const char *names[], int n, int max)
{
    for (; *list; list++) {
        int seen = 0;
        for (int k = 0; k < n; k++) seen |= strcmp(names[k], (*list)->name) == 0;
        if (!seen && n < max) names[n++] = (*list)->name;
    }
    return n;
}

int engine_problem_names(const char *names[], int max)
{
    int n = 0;
    for (const Engine *const *e = engines; *e; e++) n = gather((*e)->problems, names, n, max);
    return n;
}

int engine_method_names(const char *names[], int max)
{
    int n = 0;
    for (const Engine *const *e = engines; *e; e++) n = gather((*e)->methods, names, n, max);
    return n;
}

static int name_check(const char *what, const char *takes, const char *got,
                      const char *const *names, int n, Fault *fault)
{
    for (int k = 0; k < n; k++)
        if (strcmp(names[k], got) == 0) return 0;
    return option_refuse(fault, what, got, takes, names, n);
}

int engine_check_problem(const char *name, Fault *fault)
{
    const char *names[MOST_NAMES];
    return name_check("PROBLEM", "a problem", name, names, engine_problem_names(names, MOST_NAMES),
                      fault);
}

int engine_check_method(const char *option, const char *name, Fault *fault)
{
    const char *names[MOST_NAMES];
    return name_check(option, "a method", name, names, engine_method_names(names, MOST_NAMES),
                      fault);
}

/* Without dim=, a scene of several dimensions runs in the highest below 3, as it did before 3D
 * existed: commands and journals of that time keep their meaning. */
const Engine *engine_for(const RunSpec *spec, Fault *fault)
{
    const char *dim = spec_get(spec, "dim");
    const Engine *found = NULL;
    char dims[32] = "", word[8];
    for (const Engine *const *e = engines; *e; e++) {
        if (!engine_has_problem(*e, spec->problem)) continue;
        snprintf(word, sizeof word, "%d", (*e)->dim);
        if (dim && strcmp(dim, word) == 0) return *e;
        if (dims[0]) strcat(dims, " or ");
        strcat(dims, word);
        if (!found || (*e)->dim < 3) found = *e;
    }
    if (found && !dim) return found;
    if (found)
        option_refuse(fault, "--set dim", dim, dims, NULL, 0);
    else
        engine_check_problem(spec->problem, fault);
    return NULL;
}
