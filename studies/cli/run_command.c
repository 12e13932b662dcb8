/* run_command.c: `run`: one problem by one method, one row out. */
#include <stdlib.h>
#include <string.h>
#include "cli.h"
#include "csv_append.h"
#include "common/base/saved.h"
#include "studies/engine/cases.h"
#include "studies/runs/run_args.h"
#include "studies/engine/run_study.h"
#include "studies/engine/signals.h"

static void print_row(const Row *row)
{
    char text[ROW_TEXT];
    row_header(text);
    puts(text);
    row_print(row, text);
    puts(text);
}

/* A run may have fewer steps than --set steps=N asks for: it ends at t_end in any case. */
static void note_steps(const RunSpec *spec, const Row *row)
{
    const char *steps = spec_get(spec, "steps");
    const bool whole =
        !(row->steps * row->dt < row->t_end * (1 - 1e-9)); /* dt is NAN without time */
    if (steps && row->steps < strtod(steps, NULL) && whole)
        fprintf(stderr,
                "mpmlab: --set steps: got '%s', but t_end = %g was reached after %g steps\n", steps,
                row->t_end, row->steps);
}

/* Is there a state to resume from? Says which, if it is not the newest. */
static int check_resume(const RunArgs *args, Fault *fault)
{
    char command[SPEC_TEXT], chosen[PATH_MAX];
    RunSpec spec = args->spec;
    spec.threads = 0;
    spec_command(&spec, command);
    FILE *f = saved_open(spec.resume, &(SavedKey){command, spec.program}, chosen, fault);
    if (!f) return FAULT_USAGE;
    fclose(f);
    if (!args->quiet && strcmp(chosen, spec.resume) != 0)
        fprintf(stderr, "mpmlab: %s is no whole checkpoint; resumed from %s\n", spec.resume,
                chosen);
    return 0;
}

static int run(int argc, char **argv, Fault *fault)
{
    RunArgs args;
    Row row = row_empty();
    int code = run_args_read(argc, argv, &args, fault);
    if (code) return code;
    const Engine *engine = engine_for(&args.spec, fault);
    if (!engine) return FAULT_USAGE;
    if ((code = engine->resolve(&args.spec, fault))) return code;
    args.spec.program = cases_program();
    if (args.spec.resume && (code = check_resume(&args, fault))) return code;
    if ((code = spec_files_check(&args.spec, fault))) return code;
    if (args.csv && (code = csv_append_check(args.csv, fault))) return code;
    if (args.spec.vtk && !args.spec.resume && (code = file_make_folder(args.spec.vtk, fault)))
        return code;
    args.spec.stop = signals_note();
    if ((code = engine->run(&args.spec, &row, fault))) return code;
    print_row(&row);
    if (!args.quiet && strcmp(row.status, "ok") != 0)
        fprintf(stderr, "mpmlab: %s: %s\n", row.status, row.reason);
    if (strcmp(row.status, "interrupted") == 0) return FAULT_INTERRUPTED; /* no row of a table */
    if (!args.quiet) note_steps(&args.spec, &row);
    return args.csv ? csv_append(args.csv, &row, args.quiet ? NULL : stderr, fault) : 0;
}

const Command run_command = {
    .name = "run",
    .usage = "PROBLEM [options]",
    .about = "runs one case; prints a header and one row of comma-separated values",
    .options = run_args_options,
    .run = run,
};
