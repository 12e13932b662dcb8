/* pairs.c: see pairs.h. */
#include "pairs.h"

#include <stdio.h>
#include "studies/select.h"

const Pair pairs[PAIRS] = {{"cd", false},  {"usl", false}, {"musl", false}, {"uvf", false},
                           {"usf", false}, {"musl", true}, {"uvf", true}};

/* Resolves such a run, with allow_unstable if wanted; integrator NULL: the default. */
static bool resolves(const Engine *engine, RunSpec *spec, const char *problem, const char *method,
                     const Pair *pair, bool allow)
{
    *spec = (RunSpec){0};
    snprintf(spec->problem, sizeof spec->problem, "%s", problem);
    snprintf(spec->method, sizeof spec->method, "%s", method);
    if (pair) snprintf(spec->integrator, sizeof spec->integrator, "%s", pair->integrator);
    if (allow && spec_set(spec, "allow_unstable=1", NULL)) return false;
    if (pair && pair->refresh && spec_set(spec, "refresh=1", NULL)) return false;
    return engine->resolve(spec, NULL) == 0;
}

bool pair_is_allowed(const Engine *engine, const char *problem, const char *method, Pair pair)
{
    RunSpec spec;
    return resolves(engine, &spec, problem, method, &pair, false);
}

bool pair_is_run(const Engine *engine, const char *problem, const char *method, Pair pair)
{
    RunSpec spec;
    if (!pair.refresh) return resolves(engine, &spec, problem, method, &pair, true);
    return !pair_is_allowed(engine, problem, method, (Pair){pair.integrator, false}) &&
           pair_is_allowed(engine, problem, method, pair);
}

int pair_of_row(const Table *rows, int row)
{
    const bool refresh = select_number(rows, row, "refresh") > 0;
    for (int k = 0; k < PAIRS; k++)
        if (pairs[k].refresh == refresh && select_is(rows, row, "integrator", pairs[k].integrator))
            return k;
    return -1;
}

void pair_default_integrator(const Engine *engine, const char *problem, const char *method,
                             char out[16])
{
    RunSpec spec;
    snprintf(out, 16, "%s",
             resolves(engine, &spec, problem, method, NULL, false) ? spec.integrator : "");
}
