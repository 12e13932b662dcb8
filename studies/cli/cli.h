/* cli.h: what a command of the program is: data for its help, and one function. */
#ifndef MPMLAB_CLI_H
#define MPMLAB_CLI_H

#include "studies/runs/options.h"
#include "studies/study.h"

enum { EXIT_CLAIM_FAILED = 3 };

typedef struct Command {
    const char *name, *usage, *about;
    const Option *options;
    /* Exit status; anything but 0 and 3 comes with *fault filled. argv[0] is the command. */
    int (*run)(int argc, char **argv, Fault *fault);
} Command;

extern const Command list_command, describe_command, run_command, study_command, sweep_command,
    claims_command, new_method_command;

/* The study of that name, or NULL and a fault with the nearest one. */
const Study *study_named(const char *name, Fault *fault);

#endif
