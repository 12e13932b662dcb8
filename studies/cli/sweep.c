/* sweep.c: see sweep.h. Case k has the digits of k as its values, the last axis running fastest. */
#include "sweep.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "common/base/info.h"
#include "studies/runs/must.h"
#include "studies/runs/run_args.h"

void sweep_arrange(Sweep *s)
{
    s->across = -1;
    for (int k = 0; k < s->n; k++)
        if (s->axis[k].list.n > 1 && lists_are_numeric(&s->axis[k].list) &&
            (s->across < 0 || s->axis[k].list.n > s->axis[s->across].list.n))
            s->across = k;
    if (s->across < 0) return;
    const Axis last = s->axis[s->n - 1];
    s->axis[s->n - 1] = s->axis[s->across];
    s->axis[s->across] = last;
    s->across = s->n - 1;
}

double sweep_size(const Sweep *s)
{
    double size = 1;
    for (int k = 0; k < s->n; k++) size *= s->axis[k].list.n;
    return size;
}

/* The number of axis a's value in case k. */
static int place_of(const Sweep *s, int a, int k)
{
    for (int b = s->n - 1; b > a; b--) k /= s->axis[b].list.n;
    return k % s->axis[a].list.n;
}

const char *sweep_value(const Sweep *s, int a, int k)
{
    return s->axis[a].list.value[place_of(s, a, k)];
}

static size_t add_option(const Axis *x, const char *value, char text[], size_t size)
{
    const bool setting = strcmp(x->option, "set") == 0;
    return (size_t)snprintf(text, size, " --%s %s%s%s", x->option, setting ? x->name : "",
                            setting ? "=" : "", value);
}

void sweep_case(const Sweep *s, int k, char text[], size_t size)
{
    size_t at = (size_t)snprintf(text, size, "run %s", s->problem);
    for (int a = 0; a < s->n && at < size; a++)
        at += add_option(&s->axis[a], sweep_value(s, a, k), text + at, size - at);
}

void sweep_title(const Sweep *s, int k, char text[256])
{
    size_t at = 0;
    text[0] = '\0';
    for (int a = 0; a < s->n && at < 256; a++) {
        const Axis *x = &s->axis[a];
        const char *name = lists_are_numeric(&x->list) ? x->name : "";
        if (a == s->across || x->list.n < 2) continue;
        at += (size_t)snprintf(text + at, 256 - at, "%s%s%s%s", at ? "; " : "", name,
                               *name ? " " : "", sweep_value(s, a, k));
    }
    if (!text[0]) snprintf(text, 256, "%s", s->problem);
}

double sweep_asked_ppc(const Sweep *s, int k)
{
    double ppc = NAN;
    for (int a = 0; a < s->across; a++)
        if (strcmp(s->axis[a].name, "ppc") == 0 && s->axis[a].list.n > 1)
            info_number_parse(sweep_value(s, a, k), &ppc);
    return ppc;
}

/* ---- Which combinations can be run */

/* Why combinations were refused: each reason once, with how many it stopped. */
typedef struct Reasons {
    int n;
    struct Reason {
        char text[512];
        int count;
    } * list;
} Reasons;

static void add_reason(Reasons *r, const char *text)
{
    int k = 0;
    while (k < r->n && strcmp(r->list[k].text, text) != 0) k++;
    if (k == r->n) {
        r->list = must_grow(r->list, r->n, sizeof *r->list);
        r->list[r->n++].count = 0;
        snprintf(r->list[k].text, sizeof r->list[k].text, "%s", text);
    }
    r->list[k].count++;
}

static int try_case(const char *text, Fault *fault)
{
    RunSpec spec;
    const Engine *engine;
    return run_args_resolve(text, &spec, &engine, fault);
}

/* Is a word that no combination can be run with refused alone, too? Then it is misspelt, not half
 * of a pair. A range of numbers may hold some that a scene does not take (ppc 2 on a lattice).
 * `used` counts combinations for each value of each axis, one after the other. */
static int check_values(const Sweep *s, const int *used, Fault *fault)
{
    char text[SPEC_TEXT];
    for (int a = 0; a < s->n; used += s->axis[a++].list.n)
        for (int v = 0; v < s->axis[a].list.n; v++) {
            if (used[v] || lists_are_numeric(&s->axis[a].list)) continue;
            const size_t at = (size_t)snprintf(text, sizeof text, "run %s", s->problem);
            add_option(&s->axis[a], s->axis[a].list.value[v], text + at, sizeof text - at);
            if (try_case(text, fault)) return FAULT_USAGE;
        }
    return 0;
}

static void count_values(const Sweep *s, int k, int *used)
{
    for (int a = 0; a < s->n; used += s->axis[a++].list.n) used[place_of(s, a, k)]++;
}

int sweep_choose(Sweep *s, FILE *notes, Fault *fault)
{
    const int size = (int)sweep_size(s);
    char text[SPEC_TEXT];
    Reasons reasons = {0};
    size_t values = 1;
    for (int a = 0; a < s->n; a++) values += (size_t)s->axis[a].list.n;
    int *used = must(calloc(values, sizeof *used)), code = 0;
    s->choice = must(calloc((size_t)size + 1, sizeof *s->choice));
    s->chosen = 0;
    for (int k = 0; k < size; k++) {
        Fault why = {0};
        sweep_case(s, k, text, sizeof text);
        if (try_case(text, &why)) {
            add_reason(&reasons, why.text);
            continue;
        }
        count_values(s, k, used);
        s->choice[s->chosen++] = k;
    }
    if (reasons.n) code = check_values(s, used, fault);
    if (code == 0 && s->chosen == 0)
        code = fault_set(fault, FAULT_USAGE, "%s", reasons.list[0].text);
    for (int r = 0; r < reasons.n && code == 0; r++)
        fprintf(notes, "mpmlab: left out %d of %d runs: %s\n", reasons.list[r].count, size,
                reasons.list[r].text);
    free(reasons.list);
    free(used);
    return code;
}

void sweep_free(Sweep *s)
{
    for (int k = 0; k < s->n; k++) lists_free(&s->axis[k].list);
    free(s->choice);
    *s = (Sweep){0};
}
