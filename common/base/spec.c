/* spec.c: a run's settings, and the command line that makes the run again (its key). */
#include "spec.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "info.h"
#include "saved.h"
#include "table.h"

static Setting *setting_find(RunSpec *spec, const char *name)
{
    for (int k = 0; k < spec->nset; k++)
        if (strcmp(spec->set[k].name, name) == 0) return &spec->set[k];
    return NULL;
}

int spec_set(RunSpec *spec, const char *name_value, Fault *fault)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
    Setting s = {0};
    size_t n = strspn(name_value, letters);
    const char *value = name_value + n + 1;
    if (n == 0 || name_value[n] != '=' || !*value)
        return fault_set(fault, FAULT_USAGE, "--set: got '%s', takes NAME=VALUE", name_value);
    if (n >= sizeof s.name || strlen(value) >= sizeof s.value || strpbrk(value, " \t\n,;\"'"))
        return fault_set(fault, FAULT_USAGE,
                         "--set: got '%.200s', takes NAME=VALUE of at most %d and %d plain "
                         "characters",
                         name_value, (int)sizeof s.name - 1, (int)sizeof s.value - 1);
    memcpy(s.name, name_value, n);
    memcpy(s.value, value, strlen(value));
    Setting *old = setting_find(spec, s.name);
    if (!old && spec->nset == SPEC_SETS)
        return fault_set(fault, FAULT_USAGE, "--set: more than %d settings", SPEC_SETS);
    if (!old) old = &spec->set[spec->nset++];
    *old = s;
    return 0;
}

const char *spec_get(const RunSpec *spec, const char *name)
{
    for (int k = 0; k < spec->nset; k++)
        if (strcmp(spec->set[k].name, name) == 0) return spec->set[k].value;
    return NULL;
}

/* Text that grows in a fixed room; SPEC_TEXT holds the longest possible command. */
typedef struct Writer {
    char *out;
    int n;
} Writer;

__attribute__((format(printf, 2, 3))) static void put(Writer *w, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    w->n += vsnprintf(w->out + w->n, (size_t)(SPEC_TEXT - w->n), format, args);
    va_end(args);
}

static void put_text(Writer *w, const char *option, const char *text)
{
    if (text[0]) put(w, " --%s %s", option, text);
}

static void put_number(Writer *w, const char *option, double x)
{
    char text[64];
    info_number_print(x, text);
    if (x > 0) put(w, " --%s %s", option, text);
}

/* The setting whose name comes next after that of `last` (NULL: the first), or NULL. */
static const Setting *setting_after(const RunSpec *spec, const Setting *last)
{
    const Setting *next = NULL;
    for (const Setting *s = spec->set; s < spec->set + spec->nset; s++)
        if ((!last || strcmp(s->name, last->name) > 0) &&
            (!next || strcmp(s->name, next->name) < 0))
            next = s;
    return next;
}

void spec_command(const RunSpec *spec, char out[SPEC_TEXT])
{
    Writer w = {out, 0};
    put(&w, "run %s", spec->problem);
    put_text(&w, "method", spec->method);
    put_text(&w, "integrator", spec->integrator);
    put_number(&w, "cells", spec->cells);
    put_number(&w, "ppc", spec->ppc);
    put_number(&w, "cfl", spec->cfl);
    put_number(&w, "t-end", spec->t_end);
    if (spec->threads > 1) put(&w, " --threads %d", spec->threads);
    for (const Setting *s = NULL; (s = setting_after(spec, s));)
        put(&w, " --set %s=%s", s->name, s->value);
}

int spec_files_check(const RunSpec *s, Fault *fault)
{
    const char *const files[] = {s->history, s->particles, s->nodes,     s->samples,
                                 s->errors,  s->patches,   s->checkpoint};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++)
        if (files[k] && file_check(files[k], fault)) return FAULT_MACHINE;
    return s->checkpoint ? saved_check_before(s->checkpoint, fault) : 0;
}
