/* variants.c: see variants.h. */
#include "variants.h"

#include "studies/runs/engines.h"
#include "studies/runs/run_args.h"
#include "studies/select.h"

const char *variant_run(const Variant *variant, const char *run, ...)
{
    char text[SPEC_TEXT];
    const Engine *engine;
    RunSpec spec;
    PHRASE_INTO(text, run);
    if (!variant->setting[0]) return phrase("%s", text);
    const char *changed = phrase("%s --set %s", text, variant->setting);
    const bool taken = run_args_resolve(changed, &spec, &engine, NULL) == 0;
    return taken && engine_has_grid(engine, spec.method) ? changed : NULL;
}

int variant_of_row(const Variant variants[], int n, const Table *rows, int row)
{
    int k = n - 1;
    while (k > 0 && !select_meets(rows, row, "%s", variants[k].setting)) k--;
    return k;
}
