/* info.c: numbers and parameter values to and from text, exactly.
 * The program never calls setlocale, so strtod and printf use the "C" locale. */
#include "info.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const Param *info_param_find(const Param *list, const char *name)
{
    for (; list && list->name; list++)
        if (strcmp(list->name, name) == 0) return list;
    return NULL;
}

int info_number_parse(const char *text, double *value)
{
    if (!*text || strspn(text, "+-.0123456789eE") != strlen(text))
        return -1; /* no hex, inf, " 1" */
    char *end;
    double x = strtod(text, &end);
    if (*end || !isfinite(x)) return -1;
    *value = x;
    return 0;
}

void info_number_print(double x, char out[64])
{
    /* 15 digits read back unless rounding made them, but for numbers too small to have that many */
    for (int digits = fabs(x) < DBL_MIN ? 1 : 15; digits <= 17; digits++) {
        snprintf(out, 64, "%.*g", digits, x);
        if (strtod(out, NULL) == x) return;
    }
}

void info_number_write(FILE *out, double x)
{
    char text[64] = "";
    if (!isnan(x)) info_number_print(x, text);
    fputs(text, out);
}

/* The k-th word of "a|b|c" and its length; 0 past the end. */
static int choice(const char *choices, int k, const char **word)
{
    const char *c = choices;
    for (; k > 0; k--) {
        c = strchr(c, '|');
        if (!c) return 0;
        c++;
    }
    *word = c;
    return (int)strcspn(c, "|");
}

static int parse_choice(const Param *p, const char *text, double *value, char takes[128])
{
    const char *word;
    int length;
    for (int k = 0; (length = choice(p->choices, k, &word)) > 0; k++) {
        if ((size_t)length != strlen(text) || strncmp(word, text, (size_t)length) != 0) continue;
        *value = k;
        return 0;
    }
    snprintf(takes, 128, "%s", p->choices);
    return -1;
}

bool info_param_is_path(const Param *p)
{
    return p->choices && strcmp(p->choices, PARAM_PATH) == 0;
}

/* A path must not hold the characters that separate a row's parameters: there they would end it. */
static int parse_path(const char *text, double *value, char takes[128])
{
    *value = 0;
    if (!strpbrk(text, ",;=\n")) return 0;
    snprintf(takes, 128, "the name of a file without , ; = or a new line");
    return -1;
}

int info_param_parse(const Param *p, const char *text, double *value, char takes[128])
{
    if (info_param_is_path(p)) return parse_path(text, value, takes);
    if (p->choices) return parse_choice(p, text, value, takes);
    double x;
    if (info_number_parse(text, &x) == 0 && x >= p->min && x <= p->max) {
        *value = x;
        return 0;
    }
    char low[64], high[64];
    info_number_print(p->min, low);
    info_number_print(p->max, high);
    snprintf(takes, 128, "a number in [%.30s, %.30s]", low, high);
    return -1;
}

void info_param_print(const Param *p, double value, char out[64])
{
    const char *word;
    int length = p->choices ? choice(p->choices, (int)value, &word) : 0;
    if (info_param_is_path(p))
        strcpy(out, "-");
    else if (length > 0)
        snprintf(out, 64, "%.*s", length, word);
    else
        info_number_print(value, out);
}
