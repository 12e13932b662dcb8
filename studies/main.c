/* main.c: mpmlab's front door: finds the command, prints its one line of failure. */
#include <errno.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>
#include "cli.h"
#include "facts.h"

static const Command *const commands[] = {&list_command,  &describe_command, &run_command,
                                          &study_command, &claims_command,   &new_method_command};
enum { COMMANDS = sizeof commands / sizeof *commands };

/* Files appear whole, so there is nothing to clean up. */
static void interrupted(int number)
{
    (void)number;
    _exit(EXIT_INTERRUPTED);
}

static int print_help(void)
{
    printf("usage: mpmlab COMMAND ...\n"
           "Compares ways to move information between particles and a grid.\n\n");
    for (int k = 0; k < COMMANDS; k++)
        printf("  %-10s %s\n", commands[k]->name, commands[k]->about);
    printf("\n  --version  version, compiler, flags\n"
           "  --help     this text; after a command: its options\n");
    return 0;
}

static int print_command_help(const Command *c)
{
    printf("usage: mpmlab %s %s\n%s\n", c->name, c->usage, c->about);
    if (c->options->name) printf("\n");
    options_help(c->options, stdout);
    return 0;
}

static int print_version(void)
{
    printf("mpmlab %s\n%s\n%s\n", FACT_VERSION, FACT_COMPILER, FACT_FLAGS);
    return 0;
}

static int wants_help(int argc, char **argv)
{
    for (int k = 1; k < argc; k++)
        if (strcmp(argv[k], "--help") == 0) return 1;
    return 0;
}

static int dispatch(int argc, char **argv, Fault *fault)
{
    const char *names[COMMANDS + 2] = {"--help", "--version"};
    if (argc < 2)
        return fault_set(fault, FAULT_USAGE, "COMMAND: got nothing, takes one of those in --help");
    if (strcmp(argv[1], "--help") == 0) return print_help();
    if (strcmp(argv[1], "--version") == 0) return print_version();
    for (int k = 0; k < COMMANDS; k++) {
        names[k + 2] = commands[k]->name;
        if (strcmp(argv[1], commands[k]->name) != 0) continue;
        if (wants_help(argc - 1, argv + 1)) return print_command_help(commands[k]);
        return commands[k]->run(argc - 1, argv + 1, fault);
    }
    return refuse(fault, "COMMAND", argv[1], "one of those in --help", names, COMMANDS + 2);
}

int main(int argc, char **argv)
{
    Fault fault = {0};
    signal(SIGINT, interrupted);
    signal(SIGTERM, interrupted);
    int status = dispatch(argc, argv, &fault);
    errno = 0;
    if ((fflush(stdout) != 0 || ferror(stdout)) && status != FAULT_USAGE)
        status =
            fault_set(&fault, FAULT_MACHINE, "standard output: %s", strerror(errno ? errno : EIO));
    if (fault.code) fprintf(stderr, "mpmlab: %s\n", fault.text);
    return status;
}
