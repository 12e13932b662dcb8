/* options.h: command lines read from tables of options: --name VALUE, --name=VALUE, and plain
 * words. */
#ifndef MPMLAB_OPTIONS_H
#define MPMLAB_OPTIONS_H

#include <stdio.h>
#include "common/base/fault.h"

/* One option; a list of them ends with a NULL name. */
typedef struct Option {
    const char *name;  /* without the dashes */
    const char *takes; /* what its value is ("N"), or NULL: a flag */
    const char *help;
} Option;

/* Receives option `name` with its value ("" for a flag), or a plain word with name NULL. 0 or a
 * fault. Texts live as long as argv. */
typedef int (*TakeOption)(void *into, const char *name, const char *value, Fault *fault);

/* Reads argv[1..argc-1], calling take for each in turn, in order. 0 or a fault. */
int options_read(int argc, char **argv, const Option *options, TakeOption take, void *into,
                 Fault *fault);

/* Of commands without options, which take one word: take for options_read, into a const char *. */
extern const Option options_none[];
int option_take_word(void *into, const char *name, const char *value, Fault *fault);

void options_help(const Option *options, FILE *out);

/* "what: got 'got', takes takes", and the nearest of the n names (NULL-safe, n may be 0). */
int option_refuse(Fault *fault, const char *what, const char *got, const char *takes,
                  const char *const *names, int n);

/* A whole number in [1, high] as text; 0, or option_refuse()s in the name of --option. */
int option_whole(const char *option, const char *text, int high, int *value, Fault *fault);

#endif
