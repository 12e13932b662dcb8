/* sweep_command.c: `sweep`: lists of run options into a study of its own, without a page of C. */
#include <string.h>
#include <unistd.h>
#include "cli.h"
#include "studies/runs/engines.h"
#include "studies/engine/plot.h"
#include "studies/runs/run_args.h"
#include "studies/engine/run_study.h"
#include "sweep.h"

enum { MOST_CASES = 100000, MOST_NAME = 40 };

typedef struct SweepArgs {
    Sweep sweep;
    StudyOptions options;
    char name[64];
} SweepArgs;

/* What was asked of this process: a study's functions take no argument for it. */
static SweepArgs asked;

static const Option sweep_options[] = {
    {"method", "M,M", "one method or several"},
    {"cells", "LIST", "A,B,C or A:B:*R (factors of R) or A:B:+D (steps of D)"},
    {"ppc", "LIST", "particles per cell"},
    {"cfl", "LIST", "time step over h/c"},
    {"integrator", "I,I", "cd, uvf, musl, usl or usf"},
    {"t-end", "LIST", "end of the run [s]"},
    {"threads", "LIST", "threads inside a run"},
    {"set", "NAME=LIST", "a parameter of problem, method or run; may be repeated"},
    {"out", "DIR", "where results go (default build/out)"},
    {"name", "NAME", "table and figure are sweep_NAME (default: the problem's name)"},
    {"jobs", "N", "cases at once, each in a process (default 1)"},
    {"list", NULL, "only print the missing cases, one command per line"},
    {"collect", NULL, "first take in the rows that such commands have left"},
    {NULL, NULL, NULL},
};

static int take_problem(Sweep *s, const char *got, Fault *fault)
{
    if (s->problem[0]) return option_refuse(fault, "PROBLEM", got, "one problem only", NULL, 0);
    if (engine_check_problem(got, fault)) return FAULT_USAGE;
    snprintf(s->problem, sizeof s->problem, "%s", got);
    return 0;
}

/* It becomes part of file names, in which a dot divides a table from its parts. */
static int take_name(SweepArgs *args, const char *got, Fault *fault)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    if (!*got || strlen(got) > MOST_NAME || got[strspn(got, plain)])
        return option_refuse(fault, "--name", got, "1 to 40 letters, digits, _ or -", NULL, 0);
    snprintf(args->name, sizeof args->name, "sweep_%s", got);
    return 0;
}

/* Adds the values of --option, or of --set NAME=. */
static int take_list(Sweep *s, const char *option, const char *name, const char *values,
                     Fault *fault)
{
    char what[160];
    const bool setting = strcmp(option, "set") == 0, whole = strcmp(option, "cells") == 0;
    snprintf(what, sizeof what, setting ? "--set %.60s" : "--%.60s", name);
    for (int k = 0; k < s->n; k++)
        if (strcmp(s->axis[k].name, name) == 0)
            return option_refuse(fault, what, values, "one list: separate values by commas", NULL,
                                 0);
    if (s->n == SWEEP_AXES) return option_refuse(fault, what, values, "at most 24 lists", NULL, 0);
    Axis *axis = &s->axis[s->n++];
    snprintf(axis->option, sizeof axis->option, "%s", option);
    snprintf(axis->name, sizeof axis->name, "%s", name);
    return lists_read(&axis->list, what, values, whole, fault);
}

static int take_setting(Sweep *s, const char *got, Fault *fault)
{
    char name[64];
    const size_t n = strcspn(got, "=");
    if (!got[n] || n == 0 || n >= sizeof name)
        return option_refuse(fault, "--set", got, "NAME=LIST", NULL, 0);
    snprintf(name, sizeof name, "%.*s", (int)n, got);
    return take_list(s, "set", name, got + n + 1, fault);
}

static int take(void *into, const char *name, const char *got, Fault *fault)
{
    SweepArgs *args = into;
    if (!name) return take_problem(&args->sweep, got, fault);
    if (strcmp(name, "set") == 0) return take_setting(&args->sweep, got, fault);
    if (strcmp(name, "name") == 0) return take_name(args, got, fault);
    const int code = study_take_option(&args->options, name, got, fault);
    return code == STUDY_OTHER_OPTION ? take_list(&args->sweep, name, name, got, fault) : code;
}

static void cases(Cases *list, bool quick)
{
    char text[SPEC_TEXT];
    (void)quick;
    for (int k = 0; k < asked.sweep.chosen; k++) {
        sweep_case(&asked.sweep, asked.sweep.choice[k], text, sizeof text);
        case_add(list, "%s", text);
    }
}

static void tables(const Results *results)
{
    sweep_tables(&asked.sweep, results);
}

/* The files that a sweep has more than a study, before its runs. */
static int check_files(const SweepArgs *args, Fault *fault)
{
    static const char *const parts[] = {"curves", "orders"};
    char path[PATH_TEXT];
    int code = file_make_folder(args->options.dir, fault);
    for (int k = 0; k < 2 && code == 0; k++) {
        table_part_path(path, args->options.dir, args->name, parts[k]);
        code = file_check(path, fault);
    }
    return code;
}

/* Shows the orders: they are what the sweep was for. */
static int print_orders(const SweepArgs *args, Fault *fault)
{
    char path[PATH_TEXT], line[1024];
    table_part_path(path, args->options.dir, args->name, "orders");
    FILE *f = fopen(path, "r");
    while (f && fgets(line, sizeof line, f)) fputs(line, stdout);
    const int code = f ? 0 : fault_set(fault, FAULT_MACHINE, "%s: cannot be read", path);
    if (f) fclose(f);
    return code;
}

static int run_sweep(SweepArgs *args, Fault *fault)
{
    static const StudyPage page = {.cases = cases, .tables = tables};
    const Study study = {args->name, "sweep", "a sweep of run options", &page, NULL, "sweep"};
    sweep_arrange(&args->sweep);
    if (sweep_size(&args->sweep) > (double)MOST_CASES)
        return fault_set(fault, FAULT_USAGE, "sweep: got %g cases, takes at most %d",
                         sweep_size(&args->sweep), MOST_CASES);
    int code = sweep_choose(&args->sweep, stderr, fault);
    if (code == 0) code = check_files(args, fault);
    if (code == 0) code = run_study(&study, &args->options, fault);
    if (code == PLOT_NO_GNUPLOT)
        fputs("mpmlab: gnuplot is not installed: no figure drawn\n", stderr);
    else if (code)
        return code;
    else if (args->options.action != STUDY_LIST && isatty(STDERR_FILENO))
        fprintf(stderr, "mpmlab: figure %s/%s.svg\n", args->options.dir, args->name);
    return args->options.action == STUDY_LIST ? 0 : print_orders(args, fault);
}

static int sweep(int argc, char **argv, Fault *fault)
{
    asked = (SweepArgs){.options = {.jobs = 1, .dir = "build/out", .keep = true}};
    int code = options_read(argc, argv, sweep_options, take, &asked, fault);
    if (code == 0 && !asked.sweep.problem[0])
        code = fault_set(fault, FAULT_USAGE,
                         "PROBLEM: got nothing, takes one of those that 'list problems' prints");
    if (!asked.name[0]) snprintf(asked.name, sizeof asked.name, "sweep_%s", asked.sweep.problem);
    if (code == 0) code = run_sweep(&asked, fault);
    sweep_free(&asked.sweep);
    return code;
}

const Command sweep_command = {
    .name = "sweep",
    .usage = "PROBLEM [options with lists]",
    .about = "runs every combination of lists of options: table, orders and figure",
    .options = sweep_options,
    .run = sweep,
};
