/* cli.h: what a command of the program is: data for its help, and one function. */
#ifndef MPMLAB_CLI_H
#define MPMLAB_CLI_H

#include "studies/runs/options.h"
#include "studies/engine/run_study.h"

enum { EXIT_CLAIM_FAILED = 3 };

typedef struct Command {
    const char *name, *usage, *about;
    const Option *options;
    /* Exit status; anything but 0 and 3 comes with *fault filled. argv[0] is the command. */
    int (*run)(int argc, char **argv, Fault *fault);
} Command;

extern const Command list_command, describe_command, run_command, study_command, sweep_command,
    claims_command, new_method_command;

/* Takes --out, --jobs, --list or --collect. 0 or a fault; STUDY_OTHER_OPTION: it is none of them.
 */
enum { STUDY_OTHER_OPTION = -1 };
int study_take_option(StudyOptions *o, const char *name, const char *got, Fault *fault);

/* The name of the study that a user means by its figure (W07-5) or by how its name begins; NULL. */
const char *study_meant(const char *text);

/* The study of that name, or NULL and a fault with the nearest one. */
const Study *study_named(const char *name, Fault *fault);

#endif
