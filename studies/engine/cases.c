/* cases.c: case texts into resolved runs with keys; which of them have no row yet. */
#include "cases.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>
#include "facts.h"
#include "studies/runs/engines.h"
#include "studies/runs/must.h"
#include "studies/runs/run_args.h"
#include "studies/select.h"

static unsigned long add_checksum(unsigned long sum, const char *text)
{
    return crc32(sum, (const unsigned char *)text, (unsigned)strlen(text) + 1);
}

/* Rows of other sources, another compiler or other flags are not this program's. */
unsigned long cases_program(void)
{
    unsigned long sum = add_checksum(0, FACT_SOURCES);
    return add_checksum(add_checksum(sum, FACT_COMPILER), FACT_FLAGS);
}

/* Is name one of the words of "a,b,c"? */
static bool in_list(const char *words, const char *name)
{
    size_t n = strlen(name);
    for (const char *w = words; w; w = strchr(w, ',') ? strchr(w, ',') + 1 : NULL)
        if (strncmp(w, name, n) == 0 && (w[n] == ',' || !w[n])) return true;
    return false;
}

/* Is this a method that studies run on request alone, and is it not asked for, or refused here? */
static bool is_left_out(const Cases *cases, const char *method, bool refused)
{
    const Info *info = engine_method(method);
    const bool asked = cases->methods || in_list(cases->also, method);
    return info && info->on_request && (refused || !asked);
}

static void add(Cases *cases, const char *kind, const char *part, const char *text)
{
    char command[SPEC_TEXT];
    Case c = {.kind = kind};
    Fault fault;
    if (cases->fault.code) return;
    const bool refused = run_args_resolve(text, &c.spec, &c.engine, &fault);
    if (is_left_out(cases, c.spec.method, refused)) return;
    if (refused) {
        fault_set(&cases->fault, FAULT_USAGE, "case '%.200s': %.250s", text, fault.text);
        return;
    }
    if (cases->methods && !in_list(cases->methods, c.spec.method)) return;
    spec_command(&c.spec, command);
    c.command = must_text("%s", command);
    c.key = must_text("%s %s", command, cases->program);
    c.file = part ? must_text("%s/%s.%s.csv", cases->dir, cases->name, part) : NULL;
    cases->list = must_grow(cases->list, cases->n, sizeof c);
    cases->list[cases->n++] = c;
}

void case_add(Cases *cases, const char *format, ...)
{
    char text[SPEC_TEXT];
    PHRASE_INTO(text, format);
    add(cases, NULL, NULL, text);
}

void case_add_with(Cases *cases, const char *kind, const char *part, const char *format, ...)
{
    char text[SPEC_TEXT];
    PHRASE_INTO(text, format);
    add(cases, kind, part, text);
}

void case_add_each(Cases *cases, const char *kind, const char *part, const char *methods,
                   const char *format, ...)
{
    char text[SPEC_TEXT];
    PHRASE_INTO(text, format);
    EACH_WORD(m, methods)
        add(cases, kind, phrase("%s.%s", part, m), phrase("%s --method %s", text, m));
}

/* Points the run's output option at the case's file; the list no longer moves. */
static void set_outputs(Cases *cases)
{
    static const struct {
        const char *kind;
        size_t at;
    } outputs[] = {
        {"history", offsetof(RunSpec, history)}, {"particles", offsetof(RunSpec, particles)},
        {"nodes", offsetof(RunSpec, nodes)},     {"samples", offsetof(RunSpec, samples)},
        {"errors", offsetof(RunSpec, errors)},   {"patches", offsetof(RunSpec, patches)}};
    enum { OUTPUTS = sizeof outputs / sizeof *outputs };
    for (Case *c = cases->list; c < cases->list + cases->n; c++) {
        int k = 0;
        if (!c->file) continue;
        while (k < OUTPUTS && strcmp(c->kind, outputs[k].kind) != 0) k++;
        if (k < OUTPUTS)
            *(const char **)((char *)&c->spec + outputs[k].at) = c->file;
        else
            fault_set(&cases->fault, FAULT_USAGE, "case file of unknown kind '%s'", c->kind);
    }
}

static int finish(Cases *cases, const Study *study, Fault *fault)
{
    set_outputs(cases);
    if (cases->fault.code == 0) return 0;
    return fault_set(fault, cases->fault.code, "study %s: %.450s", study->name, cases->fault.text);
}

int cases_build(Cases *cases, const Study *study, bool quick, const char *methods, const char *dir,
                Fault *fault)
{
    *cases =
        (Cases){.dir = dir, .name = study->name, .methods = methods, .also = study->page->also};
    snprintf(cases->program, sizeof cases->program, "%08lx", cases_program());
    if (study->page->cases) study->page->cases(cases, quick);
    cases->listed = cases->n;
    return finish(cases, study, fault);
}

int cases_refine(Cases *cases, const Study *study, const Table *rows, bool quick, Fault *fault)
{
    study->page->refine(cases, rows, quick);
    return finish(cases, study, fault);
}

void cases_free(Cases *cases)
{
    for (Case *c = cases->list; c < cases->list + cases->n; c++) {
        free(c->command);
        free(c->key);
        free(c->file);
    }
    free(cases->list);
}

static int by_key_then_file(const void *a, const void *b)
{
    const Case *x = *(const Case *const *)a, *y = *(const Case *const *)b;
    int order = strcmp(x->key, y->key);
    if (order == 0) order = (x->file == NULL) - (y->file == NULL);
    if (order == 0 && x->file) order = strcmp(x->file, y->file);
    return order ? order : (x > y) - (x < y);
}

static bool is_missing(const Case *c, const Journal *journal)
{
    return !journal_row(journal, c->key) || (c->file && access(c->file, R_OK) != 0);
}

/* Would running `before` make c's row and file, too? */
static bool is_done_by(const Case *c, const Case *before)
{
    if (!before || strcmp(c->key, before->key) != 0) return false;
    return !c->file || (before->file && strcmp(c->file, before->file) == 0);
}

static int ascending(const void *a, const void *b)
{
    const int *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

int *cases_missing(const Cases *cases, const Journal *journal, int *n)
{
    size_t total = (size_t)cases->n;
    const Case **sorted = must(calloc(total + 1, sizeof *sorted)), *last = NULL;
    int *missing = must(calloc(total + 1, sizeof *missing));
    for (int k = 0; k < cases->n; k++) sorted[k] = &cases->list[k];
    qsort(sorted, total, sizeof(const Case *), by_key_then_file);
    *n = 0;
    for (int k = 0; k < cases->n; k++) {
        const Case *c = sorted[k];
        if (!is_missing(c, journal) || is_done_by(c, last)) continue;
        missing[(*n)++] = (int)(c - cases->list);
        last = c;
    }
    free(sorted);
    qsort(missing, (size_t)*n, sizeof *missing, ascending);
    return missing;
}

unsigned long cases_checksum(const Cases *cases)
{
    unsigned long sum = cases_program();
    for (int k = 0; k < cases->listed; k++) sum = add_checksum(sum, cases->list[k].key);
    return sum;
}
