/* main.c: mpmlab's front door: finds the command, prints its one line of failure. */
#include <errno.h>
#include <string.h>
#include "cli.h"
#include "manual.h"
#include "studies/engine/signals.h"

static const Command *const commands[] = {&list_command,      &describe_command, &run_command,
                                          &study_command,     &sweep_command,    &claims_command,
                                          &new_method_command};
enum { COMMANDS = sizeof commands / sizeof *commands };

/* What the program says of itself; 0 if text is none of these options. */
static int says(const char *text)
{
    if (strcmp(text, "--help") == 0)
        manual_help(commands, COMMANDS);
    else if (strcmp(text, "--man") == 0)
        manual_page(commands, COMMANDS);
    else if (strcmp(text, "--completion") == 0)
        manual_completion(commands, COMMANDS);
    else if (strcmp(text, "--version") == 0)
        manual_version();
    else
        return 0;
    return 1;
}

static int wants_help(int argc, char **argv)
{
    for (int k = 1; k < argc && strcmp(argv[k], "--") != 0; k++)
        if (strcmp(argv[k], "--help") == 0) return 1;
    return 0;
}

static int dispatch(int argc, char **argv, Fault *fault)
{
    const char *names[COMMANDS + 2] = {"--help", "--version"};
    if (argc < 2)
        return fault_set(fault, FAULT_USAGE, "COMMAND: got nothing, takes one of those in --help");
    if (says(argv[1])) return 0;
    for (int k = 0; k < COMMANDS; k++) {
        names[k + 2] = commands[k]->name;
        if (strcmp(argv[1], commands[k]->name) != 0) continue;
        if (!wants_help(argc - 1, argv + 1)) return commands[k]->run(argc - 1, argv + 1, fault);
        manual_command(commands[k]);
        return 0;
    }
    return option_refuse(fault, "COMMAND", argv[1], "one of those in --help", names, COMMANDS + 2);
}

int main(int argc, char **argv)
{
    Fault fault = {0};
    signals_start();
    int status = dispatch(argc, argv, &fault);
    errno = 0;
    if ((fflush(stdout) != 0 || ferror(stdout)) && status != FAULT_USAGE)
        status =
            fault_set(&fault, FAULT_MACHINE, "standard output: %s", strerror(errno ? errno : EIO));
    if (fault.code) fprintf(stderr, "mpmlab: %s\n", fault.text);
    return status;
}
