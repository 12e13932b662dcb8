/* run_args.c: one table says which option fills which field of a RunSpec and what it takes. */
#include "run_args.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "engines.h"
#include "run_files.h"

const Option run_args_options[] = {
    {"method", "M", "how particles and grid exchange information (default gimp)"},
    {"cells", "N", "cells per unit length"},
    {"ppc", "P", "particles per cell"},
    {"cfl", "C", "time step over h/c"},
    {"integrator", "I", "cd, uvf, musl, usl or usf"},
    {"t-end", "T", "end of the run [s]"},
    {"threads", "N", "threads inside the run (default 1)"},
    {"set", "NAME=VALUE", "a parameter of problem, method or run; may be repeated"},
    {"then", "M", "go on with another method on the same particles, from --at on"},
    {"at", "WHEN",
     "a time [s], inverted (instead of that step), rupture (after the first one) or J=x (least "
     "det F below x)"},
    {"then-set", "NAME=VALUE", "a parameter of the second method; may be repeated"},
    {"csv", "FILE", "append the row to FILE, too"},
    {"history", "FILE", "write energies and errors of every step"},
    {"probe", "X[,Y[,Z]]", "follow the nearest point in the history; may be repeated"},
    {"particles", "FILE", "write the particles at the end"},
    {"nodes", "FILE", "write the grid nodes at the end"},
    {"samples", "FILE", "write what carries strain at the end: elements of fem, else particles"},
    {"errors", "FILE", "write every point's error at the end"},
    {"patches", "FILE", "write the polygons of cells or elements at the end (2D, 3D)"},
    {"vtk", "DIR", "write snapshots into DIR"},
    {"every", "K", "steps between snapshots, or seconds: .001s (default: first and last only)"},
    {"checkpoint", "FILE", "write the run's state into FILE as it goes; FILE.1 is the one before"},
    {"every-s", "N", "seconds between two checkpoints (default 60)"},
    {"resume", "FILE", "go on from a checkpoint of the same run; if it is torn, from FILE.1"},
    {"quiet", NULL, "no messages"},
    {NULL, NULL, NULL},
};

enum { WHOLE = 1 };

static const struct Number {
    const char *option;
    size_t at;
    double high;
    int whole;
    const char *takes;
} numbers[] = {
    {"cells", offsetof(RunSpec, cells), 1e7, WHOLE, "a whole number from 1 to 10000000"},
    {"ppc", offsetof(RunSpec, ppc), 1e6, 0, "a number above 0, at most 1000000"},
    {"cfl", offsetof(RunSpec, cfl), 1e3, 0, "a number above 0, at most 1000"},
    {"t-end", offsetof(RunSpec, t_end), 1e12, 0, "a number above 0, at most 1e12"},
    {"every-s", offsetof(RunSpec, save_s), 1e6, 0, "seconds above 0, at most 1000000"},
};

static int take_problem(RunSpec *spec, const char *got, Fault *fault)
{
    if (spec->problem[0]) return option_refuse(fault, "PROBLEM", got, "one problem only", NULL, 0);
    if (engine_check_problem(got, fault)) return FAULT_USAGE;
    snprintf(spec->problem, sizeof spec->problem, "%s", got);
    return 0;
}

/* Which integrators there are, and for which method, only the engine knows. */
static int take_integrator(RunArgs *args, const char *got, Fault *fault)
{
    if (!*got || strlen(got) >= sizeof args->spec.integrator)
        return option_refuse(fault, "--integrator", got, "an integrator's name", NULL, 0);
    strcpy(args->spec.integrator, got);
    return 0;
}

static int take_method(RunArgs *args, const char *got, Fault *fault)
{
    const char *plus = strchr(got, '+');
    char first[sizeof args->spec.method];
    snprintf(first, sizeof first, "%.*s", plus ? (int)(plus - got) : (int)strlen(got), got);
    if (engine_check_method("--method", plus ? first : got, fault) ||
        (plus && engine_check_method("--method", plus + 1, fault)))
        return FAULT_USAGE;
    if (strlen(got) >= sizeof args->spec.method)
        return option_refuse(fault, "--method", got, "at most 31 characters", NULL, 0);
    snprintf(args->spec.method, sizeof args->spec.method, "%s", got);
    return 0;
}

static int take_number(RunSpec *spec, const struct Number *n, const char *got, Fault *fault)
{
    char option[32];
    double x;
    snprintf(option, sizeof option, "--%s", n->option);
    if (info_number_parse(got, &x) || x <= 0 || x > n->high || (n->whole && x != (double)(long)x))
        return option_refuse(fault, option, got, n->takes, NULL, 0);
    memcpy((char *)spec + n->at, &x, sizeof x);
    return 0;
}

static int take_set(RunArgs *args, const char *got, Fault *fault)
{
    return spec_set(&args->spec, got, fault);
}

/* A hand-over is part of the settings, which make up a row's parameters. */
static int set_text(RunArgs *args, const char *option, const char *before, const char *got,
                    Fault *fault)
{
    char pair[sizeof(Setting) + 1];
    const int n = snprintf(pair, sizeof pair, "%s%s", before, got);
    if (n < (int)sizeof pair && spec_set(&args->spec, pair, NULL) == 0) return 0;
    return option_refuse(fault, option, got,
                         strcmp(before, "then_") == 0 ? "NAME=VALUE" : "one word", NULL, 0);
}

static int take_then(RunArgs *args, const char *got, Fault *fault)
{
    if (engine_check_method("--then", got, fault)) return FAULT_USAGE;
    return set_text(args, "--then", "then=", got, fault);
}

static int take_at(RunArgs *args, const char *got, Fault *fault)
{
    return set_text(args, "--at", "at=", got, fault);
}

static int take_then_set(RunArgs *args, const char *got, Fault *fault)
{
    return set_text(args, "--then-set", "then_", got, fault);
}

static int take_threads(RunArgs *args, const char *got, Fault *fault)
{
    return option_whole("--threads", got, 1024, &args->spec.threads, fault);
}

/* So many steps, or so much time: a number and an s. */
static int take_every(RunArgs *args, const char *got, Fault *fault)
{
    RunSpec *spec = &args->spec;
    char number[64];
    double t = 0;
    const size_t n = strlen(got);
    spec->every = 0;
    spec->every_s = 0;
    const bool timed = n > 0 && n < sizeof number && got[n - 1] == 's';
    snprintf(number, sizeof number, "%.*s", (int)n - 1, got);
    if (timed ? info_number_parse(number, &t) || t <= 0
              : option_whole("--every", got, 1000000000, &spec->every, fault))
        return option_refuse(fault, "--every", got,
                             "steps from 1 to 1000000000, or seconds above 0 as .001s", NULL, 0);
    spec->every_s = t;
    return 0;
}

/* As many numbers as are typed; how many a run takes depends on its dimension. */
static int take_probe(RunArgs *args, const char *got, Fault *fault)
{
    RunSpec *spec = &args->spec;
    Probe p = {.text = got};
    for (const char *at = got; at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL) {
        char number[64];
        snprintf(number, sizeof number, "%.*s", (int)strcspn(at, ","), at);
        if (p.axes == 3 || strcspn(at, ",") >= sizeof number ||
            info_number_parse(number, &p.X[p.axes++]))
            return option_refuse(fault, "--probe", got, "X[,Y[,Z]] in metres", NULL, 0);
    }
    if (spec->nprobe == SPEC_PROBES)
        return fault_set(fault, FAULT_USAGE, "--probe: got '%.80s', takes at most %d points", got,
                         SPEC_PROBES);
    spec->probe[spec->nprobe++] = p;
    return 0;
}

static int take_resume(RunArgs *args, const char *got, Fault *fault)
{
    if (!*got) return fault_set(fault, FAULT_USAGE, "--resume: got '', takes a path");
    args->spec.resume = got;
    return 0;
}

static int take_quiet(RunArgs *args, const char *got, Fault *fault)
{
    (void)got, (void)fault;
    args->quiet = true;
    return 0;
}

static const struct {
    const char *option;
    int (*take)(RunArgs *args, const char *got, Fault *fault);
} others[] = {{"method", take_method},   {"integrator", take_integrator},
              {"set", take_set},         {"then", take_then},
              {"at", take_at},           {"then-set", take_then_set},
              {"threads", take_threads}, {"every", take_every},
              {"probe", take_probe},     {"resume", take_resume},
              {"quiet", take_quiet}};

static int take(void *into, const char *name, const char *got, Fault *fault)
{
    RunArgs *args = into;
    RunSpec *spec = &args->spec;
    if (!name) return take_problem(spec, got, fault);
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
        if (strcmp(numbers[k].option, name) == 0) return take_number(spec, &numbers[k], got, fault);
    const int taken = run_files_take(args, name, got, fault);
    if (taken >= 0) return taken;
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
        if (strcmp(others[k].option, name) == 0) return others[k].take(args, got, fault);
    return fault_set(fault, FAULT_USAGE, "unknown option '--%s'", name);
}

int run_args_read(int argc, char **argv, RunArgs *args, Fault *fault)
{
    *args = (RunArgs){.csv = NULL};
    int code = options_read(argc, argv, run_args_options, take, args, fault);
    if (code) return code;
    if (!args->spec.problem[0])
        return fault_set(fault, FAULT_USAGE,
                         "PROBLEM: got nothing, takes one of those that 'list problems' prints");
    if ((args->spec.every || args->spec.every_s > 0) && !args->spec.vtk)
        return fault_set(fault, FAULT_USAGE, "--every: needs --vtk DIR");
    if (args->spec.nprobe && !args->spec.history)
        return fault_set(fault, FAULT_USAGE, "--probe: got '%.80s', needs --history FILE",
                         args->spec.probe[0].text);
    if (args->spec.save_s > 0 && !args->spec.checkpoint)
        return fault_set(fault, FAULT_USAGE, "--every-s: needs --checkpoint FILE");
    return run_files_check(args, fault);
}
