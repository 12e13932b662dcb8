/* lists.c: see lists.h. */
#include "lists.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/base/info.h"
#include "studies/runs/must.h"

static int refuse_list(const char *what, const char *text, const char *takes, Fault *fault)
{
    return fault_set(fault, FAULT_USAGE, "%s: got '%.80s', takes %s", what, text, takes);
}

static int add(List *list, const char *what, const char *value, Fault *fault)
{
    if (value[strcspn(value, " \t\r\n'\"")])
        return refuse_list(what, value, "values without spaces and quotes", fault);
    if (!*value) return refuse_list(what, value, "values between commas", fault);
    for (int k = 0; k < list->n; k++)
        if (strcmp(list->value[k], value) == 0) return 0;
    if (list->n == LIST_MAX) return refuse_list(what, value, "at most 1000 values", fault);
    list->value = must_grow(list->value, list->n, sizeof *list->value);
    list->value[list->n++] = must_text("%s", value);
    return 0;
}

typedef struct Range {
    double from, to, by;
    bool times;
} Range;

/* "A:B:*R" or "A:B:+D" in parts. 0, or -1: it is not one, or would never end. */
static int range_parse(char *text, Range *r)
{
    char *rest = text, *from = strsep(&rest, ":"), *to = strsep(&rest, ":"), *by = rest;
    if (!to || !by || (*by != '*' && *by != '+')) return -1;
    if (info_number_parse(from, &r->from) || info_number_parse(to, &r->to) ||
        info_number_parse(by + 1, &r->by))
        return -1;
    r->times = *by == '*';
    const bool grows = r->times ? r->by > 1 && r->from > 0 : r->by > 0;
    return grows && r->from <= r->to ? 0 : -1;
}

/* Prints a value of a range as it would be typed, without the rounding errors of the sum. */
static void value_print(double x, bool whole, char out[64])
{
    if (whole) x = round(x);
    snprintf(out, 64, "%.12g", x);
}

static int add_range(List *list, const char *what, const char *text, bool whole, Fault *fault)
{
    static const char *const takes = "A:B:*R with R > 1, A > 0 or A:B:+D with D > 0; A <= B";
    char *copy = must_text("%s", text), value[64];
    Range r;
    const int wrong = range_parse(copy, &r);
    free(copy);
    if (wrong) return refuse_list(what, text, takes, fault);
    for (int k = 0; k <= LIST_MAX; k++) {
        const double x = r.times ? r.from * pow(r.by, k) : r.from + r.by * k;
        if (x > r.to * (1 + 1e-9) && x > r.to + 1e-9 * r.by) return 0;
        if (list->n == LIST_MAX) break;
        value_print(x, whole, value);
        if (add(list, what, value, fault)) return FAULT_USAGE;
    }
    return refuse_list(what, text, "at most 1000 values", fault);
}

int lists_read(List *list, const char *what, const char *text, bool whole, Fault *fault)
{
    char *copy = must_text("%s", text), *rest = copy;
    int code = 0;
    *list = (List){0};
    while (rest && code == 0) {
        const char *item = strsep(&rest, ",");
        code = strchr(item, ':') ? add_range(list, what, item, whole, fault)
                                 : add(list, what, item, fault);
    }
    free(copy);
    return code;
}

void lists_free(List *list)
{
    for (int k = 0; k < list->n; k++) free(list->value[k]);
    free(list->value);
    *list = (List){0};
}

bool lists_are_numeric(const List *list)
{
    double x;
    for (int k = 0; k < list->n; k++)
        if (info_number_parse(list->value[k], &x)) return false;
    return list->n > 0;
}
