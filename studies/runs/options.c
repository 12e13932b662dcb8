/* options.c: getopt_long behind a table, with our own one-line messages. */
#include "options.h"

#include <getopt.h>
#include <limits.h>
#include <string.h>
#include "common/base/info.h"

enum { MOST_OPTIONS = 32, FIRST = 1000 }; /* getopt's values count from FIRST: no letter, no ':' */

int option_refuse(Fault *fault, const char *what, const char *got, const char *takes,
                  const char *const *names, int n)
{
    fault_set(fault, FAULT_USAGE, "%s: got '%.80s', takes %s", what, got, takes);
    return fault_did_you_mean(fault, "", got, names, n);
}

int option_whole(const char *option, const char *text, int high, int *value, Fault *fault)
{
    double x;
    if (info_number_parse(text, &x) == 0 && x >= 1 && x <= high && x == (int)x) {
        *value = (int)x;
        return 0;
    }
    char takes[64];
    snprintf(takes, sizeof takes, "a whole number from 1 to %d", high);
    return option_refuse(fault, option, text, takes, NULL, 0);
}

static int count(const Option *options)
{
    int n = 0;
    while (options[n].name) n++;
    return n;
}

static int refuse_option(const Option *options, const char *text, Fault *fault)
{
    const char *names[MOST_OPTIONS + 1];
    char name[64];
    int n = count(options);
    for (int k = 0; k < n; k++) names[k] = options[k].name;
    names[n] = "help";
    snprintf(name, sizeof name, "%.*s", (int)strcspn(text, "="), text);
    fault_set(fault, FAULT_USAGE, "unknown option '%s'", name);
    return fault_did_you_mean(fault, "--", name + strspn(name, "-"), names, n + 1);
}

int options_read(int argc, char **argv, const Option *options, TakeOption take, void *into,
                 Fault *fault)
{
    struct option table[MOST_OPTIONS + 1] = {0};
    for (int k = 0, n = count(options); k < n; k++)
        table[k] = (struct option){options[k].name, options[k].takes ? required_argument : 0, NULL,
                                   FIRST + k};
    optind = 0; /* start anew */
    opterr = 0;
    for (int at = 1, got; (got = getopt_long(argc, argv, "-:", table, NULL)) != -1; at = optind) {
        const Option *o = options + (got >= FIRST ? got - FIRST : optopt - FIRST);
        if (got >= FIRST || got == 1) {
            int code = take(into, got == 1 ? NULL : o->name, optarg ? optarg : "", fault);
            if (code) return code;
        } else if (optopt < FIRST) {
            return refuse_option(options, argv[at], fault);
        } else if (got == ':') {
            return fault_set(fault, FAULT_USAGE, "--%s: got nothing, takes %s", o->name, o->takes);
        } else {
            return fault_set(fault, FAULT_USAGE, "--%s: got '%s', takes no value", o->name,
                             strchr(argv[at], '=') + 1);
        }
    }
    for (int k = optind; k < argc; k++) { /* after "--" */
        int code = take(into, NULL, argv[k], fault);
        if (code) return code;
    }
    return 0;
}

const Option options_none[] = {{NULL, NULL, NULL}};

int option_take_word(void *into, const char *name, const char *value, Fault *fault)
{
    const char **word = into;
    (void)name;
    if (*word) return option_refuse(fault, "argument", value, "one name only", NULL, 0);
    *word = value;
    return 0;
}

void options_help(const Option *options, FILE *out)
{
    for (; options->name; options++) {
        char left[48];
        snprintf(left, sizeof left, "--%s %s", options->name, options->takes ? options->takes : "");
        fprintf(out, "  %-26s %s\n", left, options->help);
    }
}
