/* run_row.c: see run_row.h. */
#include "run_row.h"

#include <math.h>
#include <string.h>
#include "run_args.h"
#include "studies/phrase.h"
#include "studies/select.h"

/* Is every setting of the run in the row's params, as they are spelled there? */
static bool has_settings(const char *params, const RunSpec *spec)
{
    for (int k = 0; k < spec->nset; k++) {
        char text[80];
        const int n = snprintf(text, sizeof text, "%s=%s", spec->set[k].name, spec->set[k].value);
        if (strcmp(spec->set[k].name, "layout") == 0) continue;
        if (strncmp(params, text, (size_t)n) != 0 || (params[n] && params[n] != ';')) return false;
        params += n + (params[n] == ';');
    }
    return !*params;
}

static bool is_near(double a, double b)
{
    return fabs(a - b) <= 1e-9 * fabs(b);
}

/* Body-fitted particles are not quite as many as asked for. */
bool run_row_is(const Table *rows, int row, const RunSpec *spec, const Engine *engine)
{
    const double t_end = select_number(rows, row, "t_end");
    return select_is(rows, row, "problem", spec->problem) &&
           select_is(rows, row, "method", spec->method) &&
           is_near(select_number(rows, row, "cells"), spec->cells) &&
           (engine->dim > 1 || is_near(select_number(rows, row, "ppc"), spec->ppc)) &&
           (t_end <= 0 || is_near(t_end, spec->t_end)) &&
           has_settings(select_text(rows, row, "params"), spec);
}

static int find(const Table *rows, const char *text)
{
    RunSpec spec;
    const Engine *engine;
    if (run_args_resolve(text, &spec, &engine, NULL)) return -1;
    for (int row = 0; row < rows->nrow; row++) {
        const double cfl = select_number(rows, row, "cfl");
        if (run_row_is(rows, row, &spec, engine) && (isnan(cfl) || is_near(cfl, spec.cfl)) &&
            select_is(rows, row, "integrator", spec.integrator))
            return row;
    }
    return -1;
}

Measure run_row_value(const Table *rows, const char *column, const char *format, ...)
{
    char text[SPEC_TEXT];
    PHRASE_INTO(text, format);
    const int row = find(rows, text);
    const double value = row < 0 ? NAN : select_kept(rows, row, column);
    return measure(value, !isnan(value), 1);
}
