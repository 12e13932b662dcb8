/* fuzz_sweep.c: whatever is typed behind `sweep`: lists are refused in one line or are short, plain
 * and without doubles, and the combinations of several are all different runs or refusals. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "studies/runs/engines.h"
#include "studies/runs/run_args.h"
#include "studies/cli/sweep.h"
#include "fuzz.h"

enum { MOST_CASES = 64 }; /* of one input that are looked at */

/* Does the list come back from its own values? */
static const char *same_list(const List *list, bool whole)
{
    List again;
    Fault fault = {0};
    size_t size = 1;
    const char *wrong = NULL;
    for (int k = 0; k < list->n; k++) size += strlen(list->value[k]) + 1;
    char *text = malloc(size), *at = text;
    if (!text) abort();
    for (int k = 0; k < list->n; k++) at += sprintf(at, k ? ",%s" : "%s", list->value[k]);
    if (lists_read(&again, "again", text, whole, &fault)) wrong = "a list's values are refused";
    if (!wrong && again.n != list->n) wrong = "a list's values are another list";
    for (int k = 0; !wrong && k < list->n; k++)
        if (strcmp(again.value[k], list->value[k])) wrong = "a value changed";
    lists_free(&again);
    free(text);
    return wrong;
}

static const char *check_list(const List *list, bool whole)
{
    if (list->n < 1 || list->n > LIST_MAX) return "a list of no length";
    for (int k = 0; k < list->n; k++)
        if (!list->value[k][0] || strpbrk(list->value[k], ", \t\r\n'\"")) return "a value in parts";
    return same_list(list, whole);
}

/* "name=values", an option of `run` or a setting. NULL, or what is wrong; n grows if it is taken.
 */
static const char *take_line(Sweep *s, char *line)
{
    static const char *const options[] = {"method", "cells", "ppc", "cfl", "integrator", "t-end"};
    char *values = strchr(line, '=');
    Fault fault = {0};
    Axis *axis = &s->axis[s->n];
    if (!values || values == line || values - line >= (int)sizeof axis->name) return NULL;
    *values++ = '\0';
    snprintf(axis->name, sizeof axis->name, "%s", line);
    strcpy(axis->option, "set");
    for (size_t k = 0; k < sizeof options / sizeof *options; k++)
        if (strcmp(options[k], line) == 0) strcpy(axis->option, options[k]);
    for (int k = 0; k < s->n; k++)
        if (strcmp(s->axis[k].name, axis->name) == 0) return NULL;
    const bool whole = strcmp(line, "cells") == 0;
    const int code = lists_read(&axis->list, axis->name, values, whole, &fault);
    const char *wrong = code ? fuzz_refusal(code, &fault) : check_list(&axis->list, whole);
    if (code)
        lists_free(&axis->list);
    else
        s->n++;
    return wrong;
}

/* The cases differ, and each resolves or is refused as a run is. */
static const char *check_cases(Sweep *s)
{
    static char text[MOST_CASES][SPEC_TEXT];
    const int n = sweep_size(s) < (double)MOST_CASES ? (int)sweep_size(s) : MOST_CASES;
    for (int k = 0; k < n; k++) {
        RunSpec spec;
        const Engine *engine;
        Fault fault = {0};
        sweep_case(s, k, text[k], SPEC_TEXT);
        for (int j = 0; j < k; j++)
            if (strcmp(text[j], text[k]) == 0 && strlen(text[k]) + 1 < SPEC_TEXT)
                return "two cases are the same";
        const int code = run_args_resolve(text[k], &spec, &engine, &fault);
        if (code && fuzz_refusal(code, &fault)) return fuzz_refusal(code, &fault);
    }
    return NULL;
}

/* The first byte chooses a problem, lines behind it are lists. */
const char *fuzz_sweep(const unsigned char *data, size_t n)
{
    const char *problems[64], *wrong = NULL;
    char *text = fuzz_text(data, n), *lines[SWEEP_AXES];
    Sweep s = {0};
    const int known = engine_problem_names(problems, 64), byte = (unsigned char)text[0];
    snprintf(s.problem, sizeof s.problem, "%s", problems[byte % known]);
    const int count = n ? fuzz_split(text + 1, '\n', lines, SWEEP_AXES) : 0;
    for (int k = 0; k < count && !wrong; k++) wrong = take_line(&s, lines[k]);
    sweep_arrange(&s);
    if (s.across >= 0 && s.across != s.n - 1) wrong = "the long list is not the last";
    if (!wrong && s.n > 0) wrong = check_cases(&s);
    for (int k = 0; k < s.n; k++) lists_free(&s.axis[k].list);
    free(text);
    return wrong;
}
