/* run_args_text.c: a run as one line of text, as a study's page lists it (run_args.h). */
#include <stdio.h>
#include <string.h>
#include "engines.h"
#include "run_args.h"

static bool names_files(const RunSpec *s)
{
    return s->history || s->particles || s->nodes || s->samples || s->errors || s->patches ||
           s->vtk || s->checkpoint || s->resume;
}

int run_args_resolve(const char *text, RunSpec *spec, const Engine **engine, Fault *fault)
{
    enum { MOST_WORDS = 96 };
    char words[SPEC_TEXT], *argv[MOST_WORDS + 1] = {0}, *rest = NULL;
    int argc = 0;
    RunArgs args;
    if (strlen(text) >= sizeof words)
        return fault_set(fault, FAULT_USAGE, "run text too long: %.60s...", text);
    strcpy(words, text);
    for (char *w = strtok_r(words, " ", &rest); w && argc < MOST_WORDS;
         w = strtok_r(NULL, " ", &rest))
        argv[argc++] = w;
    int code = run_args_read(argc, argv, &args, fault);
    if (code) return code;
    if (args.csv || names_files(&args.spec))
        return fault_set(fault, FAULT_USAGE, "a run of a study: got a file option, takes none");
    *spec = args.spec;
    *engine = engine_for(spec, fault);
    return *engine ? (*engine)->resolve(spec, fault) : FAULT_USAGE;
}
