/* points.c: see points.h. */
#include "points.h"

#include <stdlib.h>
#include "studies/runs/must.h"
#include "studies/select.h"

/* Returns how many columns there are. */
static int read_row(const Table *t, int row, const char *columns, double out[])
{
    char name[64];
    int n = 0, length;
    for (; sscanf(columns, " %63s%n", name, &length) == 1; columns += length)
        out[n++] = select_number(t, row, name);
    return n;
}

void points_row(const Table *t, int row, const char *columns, double out[])
{
    read_row(t, row, columns, out);
}

double *points_all(const Table *t, const char *columns)
{
    enum { MOST_COLUMNS = 16 };
    double *all = must(malloc(sizeof *all * (MOST_COLUMNS * ((size_t)t->nrow + 1))));
    double *end = all;
    for (int row = 0; row < t->nrow; row++) end += read_row(t, row, columns, end);
    return all;
}

double points_stress_along(const Table *t, int row, const double e[3])
{
    static const char *const name[3][3] = {
        {"sxx", "sxy", "sxz"}, {"sxy", "syy", "syz"}, {"sxz", "syz", "szz"}};
    double sum = 0, square = 0;
    for (int a = 0; a < 3; a++) {
        square += e[a] * e[a];
        for (int b = 0; b < 3; b++) sum += e[a] * e[b] * select_number(t, row, name[a][b]);
    }
    return sum / square;
}
