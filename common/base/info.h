/* info.h: the description of a problem or a method as data: name, purpose, source, parameters. */
#ifndef MPMLAB_INFO_H
#define MPMLAB_INFO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* One parameter. Numbers lie in [min, max]; if `choices` is set ("a|b|c") the value is the index of
 * the chosen word, unless it is PARAM_PATH: then it is the name of a file, of which a problem has
 * at most one (Scene.text), and the value is 0. The list of a problem or method ends with a Param
 * whose name is NULL. */
#define PARAM_PATH "PATH"

typedef struct Param {
    const char *name;
    double value; /* default */
    double min, max;
    const char *unit, *meaning, *source, *choices;
} Param;

typedef struct Info {
    const char *name;    /* as typed on the command line */
    const char *label;   /* as printed in figures */
    const char *about;   /* one line */
    const char *source;  /* where it is published, or NULL */
    const char *formula; /* problem: the exact motion; method: the transfers; NULL: none */
    const char *scale;   /* what errors of a problem are divided by, or NULL */
    const Param *params;
    bool on_request; /* studies of all methods leave it out, unless --method names it */
} Info;

/* The parameter of a list (or NULL) by that name, or NULL. */
const Param *info_param_find(const Param *list, const char *name);

bool info_param_is_path(const Param *p);

/* Reads text as a value of p: a number within its range, or one of its words. Returns 0, or -1 with
 * a description of what it takes in takes[128]. */
int info_param_parse(const Param *p, const char *text, double *value, char takes[128]);

/* Writes the value as it is typed: a word, or the shortest %g that reads back the same. */
void info_param_print(const Param *p, double value, char out[64]);

/* The whole text as one finite decimal number: 0, or -1 and *value untouched. */
int info_number_parse(const char *text, double *value);

/* Shortest decimal that reads back to exactly x (at most %.17g); written to a file,
 * where NAN is nothing. */
void info_number_print(double x, char out[64]);
void info_number_write(FILE *out, double x);

#endif
