/* main.c: mpmlab's front door: finds the command, prints its one line of failure. */
#include <errno.h>
#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli.h"
#include "manual.h"
#include "studies/engine/signals.h"

static const Command *const commands[] = {&list_command,      &describe_command, &run_command,
                                          &study_command,     &sweep_command,    &claims_command,
                                          &new_method_command};
enum { COMMANDS = sizeof commands / sizeof *commands };

static int is_help(const char *text)
{
    return strcmp(text, "--help") == 0 || strcmp(text, "-h") == 0;
}

/* Prints help, manual, completion or version; 0 if text is none of these options. */
static int print_self_description(const char *text)
{
    if (is_help(text))
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
        if (is_help(argv[k])) return 1;
    return 0;
}

/* The command of this name; NULL and a fault if there is none. */
static const Command *command_named(const char *name, Fault *fault)
{
    const char *names[COMMANDS + 3] = {"help", "--help", "--version"};
    for (int k = 0; k < COMMANDS; k++) {
        if (strcmp(name, commands[k]->name) == 0) return commands[k];
        names[k + 3] = commands[k]->name;
    }
    option_refuse(fault, "COMMAND", name, "one of those in --help", names, COMMANDS + 3);
    return NULL;
}

/* `help` and `help COMMAND`. */
static int help(int argc, char **argv, Fault *fault)
{
    if (argc > 2) return option_refuse(fault, "COMMAND", argv[2], "one command", NULL, 0);
    const Command *c = argc == 2 ? command_named(argv[1], fault) : NULL;
    if (c)
        manual_command(c);
    else if (argc < 2)
        manual_help(commands, COMMANDS);
    return c || argc < 2 ? 0 : FAULT_USAGE;
}

static int dispatch(int argc, char **argv, Fault *fault)
{
    if (argc < 2)
        return fault_set(fault, FAULT_USAGE, "COMMAND: got nothing, takes one of those in --help");
    static const char *const alone[] = {"--man", "--completion", "--version"};
    for (int k = 0; k < 3 && argc > 2; k++)
        if (strcmp(argv[1], alone[k]) == 0)
            return option_refuse(fault, "argument", argv[2], "nothing behind this option", NULL, 0);
    if (print_self_description(argv[1])) return 0;
    if (strcmp(argv[1], "help") == 0) return help(argc - 1, argv + 1, fault);
    const Command *c = command_named(argv[1], fault);
    if (!c) return FAULT_USAGE;
    if (!wants_help(argc - 1, argv + 1)) return c->run(argc - 1, argv + 1, fault);
    manual_command(c);
    return 0;
}

/* Threads that wait for each other spin for some ten microseconds, then sleep: spinning for good,
 * OpenMP's default, makes two threads on one idle core slower than one by orders of magnitude.
 * OpenMP reads its environment when a program is loaded, so this one starts itself again, once. If
 * it cannot, results are the same. */
static void start_with_sleeping_threads(int argc, char **argv)
{
    char program[PATH_MAX];
    bool asked = false;
    for (int k = 1; k < argc; k++) asked = asked || strncmp(argv[k], "--threads", 9) == 0;
    if (!asked || getenv("OMP_WAIT_POLICY") || getenv("GOMP_SPINCOUNT")) return;
    if (setenv("OMP_WAIT_POLICY", "passive", 1) || setenv("GOMP_SPINCOUNT", "20000", 1)) return;
    const ssize_t n = readlink("/proc/self/exe", program, sizeof program - 1);
    if (n <= 0) return;
    program[n] = '\0';
    execv(program, argv);
}

int main(int argc, char **argv)
{
    Fault fault = {0};
    start_with_sleeping_threads(argc, argv);
    signals_start();
    int status = dispatch(argc, argv, &fault);
    errno = 0;
    if ((fflush(stdout) != 0 || ferror(stdout)) && status != FAULT_USAGE)
        status =
            fault_set(&fault, FAULT_MACHINE, "standard output: %s", strerror(errno ? errno : EIO));
    if (fault.code) fprintf(stderr, "mpmlab: %s\n", fault.text);
    return status;
}
