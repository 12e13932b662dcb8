/* row.c: the columns of a run's row as one table of data, and the row as text. */
#include "row.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include "info.h"

typedef struct Column {
    const char *name;
    size_t offset;
    int is_text, is_timing;
} Column;

#define NUMBER(name)                                                                               \
    {                                                                                              \
#name, offsetof(Row, name), 0, 0                                                           \
    }
#define TIMING(name)                                                                               \
    {                                                                                              \
#name, offsetof(Row, name), 0, 1                                                           \
    }
#define TEXT(name)                                                                                 \
    {                                                                                              \
#name, offsetof(Row, name), 1, 0                                                           \
    }

/* The order is part of the contract: more may follow at the end. */
static const Column columns[] = {
    TEXT(problem),
    TEXT(method),
    TEXT(integrator),
    NUMBER(cells),
    NUMBER(h),
    NUMBER(ppc),
    NUMBER(cfl),
    NUMBER(particles),
    NUMBER(nodes),
    NUMBER(steps),
    NUMBER(t_end),
    NUMBER(error_linf),
    NUMBER(error_l2),
    NUMBER(error_l1),
    NUMBER(energy_drift),
    NUMBER(momentum_drift),
    TEXT(status),
    TIMING(cpu_s),
    TIMING(wall_s),
    TIMING(ns_per_particle_step),
    NUMBER(dt),
    TEXT(layout),
    TEXT(params),
    TEXT(reason),
    NUMBER(surface_particles),
    NUMBER(elements),
    NUMBER(fallbacks),
    NUMBER(ppc_asked),
    TIMING(wall_run_s),
    NUMBER(particle_bytes),
    NUMBER(node_bytes),
};

int row_columns(void)
{
    return (int)(sizeof columns / sizeof *columns);
}

const char *row_column_name(int k)
{
    return columns[k].name;
}

int row_column_is_timing(int k)
{
    return columns[k].is_timing;
}

Row row_empty(void)
{
    const double nan = NAN;
    Row row;
    memset(&row, 0, sizeof row);
    for (int k = 0; k < row_columns(); k++)
        if (!columns[k].is_text) memcpy((char *)&row + columns[k].offset, &nan, sizeof nan);
    return row;
}

/* Commas, quotes and control characters go, so that every line splits at its commas. */
static int print_text(const char *text, char *out)
{
    int n = 0;
    for (; text[n]; n++) {
        char c = text[n];
        out[n] = c;
        if (c == ',')
            out[n] = ';';
        else if (c == '"' || (unsigned char)c < ' ')
            out[n] = ' ';
    }
    out[n] = '\0';
    return n;
}

int row_cell(const Row *row, int k, char out[ROW_TEXT])
{
    const void *at = (const char *)row + columns[k].offset;
    if (columns[k].is_text) return print_text(at, out);
    double x = *(const double *)at;
    out[0] = '\0';
    if (!isnan(x)) info_number_print(x, out);
    return (int)strlen(out);
}

/* All columns fit: texts hold under 900 characters, numbers under 30 each. */
int row_print(const Row *row, char out[ROW_TEXT])
{
    int n = 0;
    for (int k = 0; k < row_columns(); k++) {
        if (k) out[n++] = ',';
        n += row_cell(row, k, out + n);
    }
    return n;
}

int row_header(char out[ROW_TEXT])
{
    int n = 0;
    for (int k = 0; k < row_columns(); k++)
        n += snprintf(out + n, (size_t)(ROW_TEXT - n), "%s%s", k ? "," : "", columns[k].name);
    return n;
}
