/* run_args.h: the arguments of `mpmlab run`, for the command and for the cases of studies. */
#ifndef MPMLAB_RUN_ARGS_H
#define MPMLAB_RUN_ARGS_H

#include <stdbool.h>
#include "common/run/engine.h"
#include "options.h"

typedef struct RunArgs {
    RunSpec spec;
    const char *csv; /* also append the row to this file, or NULL */
    bool quiet;
} RunArgs;

extern const Option run_args_options[];

/* Reads argv[1..]: PROBLEM and options. Texts in args->spec point into argv. 0 or a fault. */
int run_args_read(int argc, char **argv, RunArgs *args, Fault *fault);

/* Reads a text "run bar --ppc 2" (no quotes in it) and resolves it; refuses options with files,
 * whose names would not outlive the text. */
int run_args_resolve(const char *text, RunSpec *spec, const Engine **engine, Fault *fault);

#endif
