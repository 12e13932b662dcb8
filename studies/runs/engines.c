/* engines.c: the dimensions of this program, and which of them a run is for. */
#include <stdio.h>
#include <string.h>
#include "run_args.h"

const Engine *const engines[] = {&engine_1d, &engine_2d, &engine_3d, NULL};

static int knows(const Engine *e, const char *problem)
{
    for (const Info *const *p = e->problems; *p; p++)
        if (strcmp((*p)->name, problem) == 0) return 1;
    return 0;
}

/* Without dim=, a scene of several dimensions runs in the highest below 3, as it did before 3D
 * existed: commands and journals of that time keep their meaning. */
const Engine *engine_for(const RunSpec *spec, Fault *fault)
{
    const char *dim = spec_get(spec, "dim");
    const Engine *found = NULL;
    char dims[32] = "", word[8];
    for (const Engine *const *e = engines; *e; e++) {
        if (!knows(*e, spec->problem)) continue;
        snprintf(word, sizeof word, "%d", (*e)->dim);
        if (dim && strcmp(dim, word) == 0) return *e;
        if (dims[0]) strcat(dims, " or ");
        strcat(dims, word);
        if (!found || (*e)->dim < 3) found = *e;
    }
    if (found && !dim) return found;
    const char *names[64];
    if (found)
        option_refuse(fault, "--set dim", dim, dims, NULL, 0);
    else
        option_refuse(fault, "PROBLEM", spec->problem, "a problem", names,
                      engine_problem_names(names, 64));
    return NULL;
}
