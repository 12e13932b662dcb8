/* pages.c: see pages.h. */
#include "pages.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_CONDITIONS = 8, WHERE_TEXT = 512 };

/* Splits text in place at spaces. */
static int split(char *text, const char *conditions[MOST_CONDITIONS])
{
    char *rest = text;
    int n = 0;
    for (char *word; n < MOST_CONDITIONS && (word = strtok_r(rest, " ", &rest));)
        conditions[n++] = word;
    return n;
}

void curve_pick(Curve *c, const Table *rows, const char *x, const char *y, const char *where, ...)
{
    const char *conditions[MOST_CONDITIONS];
    char text[WHERE_TEXT];
    va_list args;
    va_start(args, where);
    vsnprintf(text, sizeof text, where, args);
    va_end(args);
    int n = split(text, conditions);
    rows_pick(rows, n, conditions, x, CURVE_MAX, c->x);
    c->n = rows_pick(rows, n, conditions, y, CURVE_MAX, c->y);
}

double value_pick(const Table *rows, const char *want, const char *where, ...)
{
    const char *conditions[MOST_CONDITIONS];
    char text[WHERE_TEXT];
    double value;
    va_list args;
    va_start(args, where);
    vsnprintf(text, sizeof text, where, args);
    va_end(args);
    return rows_pick(rows, split(text, conditions), conditions, want, 1, &value) ? value : NAN;
}

double row_setting(const Table *rows, int row, const char *setting)
{
    const size_t n = strlen(setting);
    double value = NAN;
    for (const char *at = table_text(rows, row, "params"); *at;) {
        if (strncmp(at, setting, n) == 0 && at[n] == '=') {
            char *end;
            value = strtod(at + n + 1, &end);
            return *end == ';' || !*end ? value : NAN;
        }
        at += strcspn(at, ";");
        at += *at == ';';
    }
    return value;
}

double curve_at(const Curve *c, double x)
{
    for (int k = 0; k < c->n; k++)
        if (fabs(c->x[k] - x) <= 1e-12 * fabs(x)) return c->y[k];
    return NAN;
}

double curve_max(const Curve *c)
{
    double most = c->n > 0 ? c->y[0] : NAN;
    for (int k = 1; k < c->n; k++) most = isnan(most) || c->y[k] <= most ? most : c->y[k];
    return most;
}

double curve_settles(const Curve *c, double level)
{
    double from = NAN;
    for (int k = c->n - 1; k >= 0 && c->y[k] <= level; k--) from = c->x[k];
    return from;
}

double curve_deviation(const Curve *c, int n, const double printed[][3])
{
    double worst = 0;
    for (int k = 0; k < n; k++) {
        double off = fabs(curve_at(c, printed[k][0]) / printed[k][1] - 1) * printed[k][2];
        if (!(off <= worst)) worst = off; /* NAN comes through and stays */
        if (isnan(worst)) break;
    }
    return worst;
}

bool method_known(const char *name)
{
    for (const Info *const *m = engine_2d.methods; *m; m++)
        if (strcmp((*m)->name, name) == 0) return true;
    return false;
}

double median(int n, double y[])
{
    if (n < 1) return NAN;
    gsl_sort(y, 1, (size_t)n);
    return gsl_stats_median_from_sorted_data(y, 1, (size_t)n);
}

bool is_lost(const Table *rows, int row)
{
    const char *status = table_text(rows, row, "status");
    return strcmp(status, "ok") != 0 && strcmp(status, "energy_growth") != 0;
}

void part_path(char path[PATH_TEXT], const char *dir, const char *name, const char *part)
{
    snprintf(path, PATH_TEXT, "%s/%s%s%s.csv", dir, name, part ? "." : "", part ? part : "");
}

Table *part_read(const char *dir, const char *name, const char *part, Fault *fault)
{
    char path[PATH_TEXT];
    part_path(path, dir, name, part);
    return table_read(path, fault);
}

void squeeze_add(Cases *list, const char *method, const char *field, int cells, int step,
                 bool quick)
{
    for (int n = cells / 2; n <= 10 * cells; n += quick ? 25 * step : step)
        case_add(list, "run squeeze --method %s --cells %d --set field=%s --set particles=%d",
                 method, cells, field, n);
}

void plateau_add(Cases *list, const char *const names[], bool quick)
{
    for (; *names; names++) squeeze_add(list, *names, "quadratic", PLATEAU_CELLS, 1, quick);
}

double plateau_error(void)
{
    const double h = 1 / (double)PLATEAU_CELLS;
    return h * h / 6 / pow(1 + h, 2);
}
