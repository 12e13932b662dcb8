/* select.c: rows of a table chosen by "column=value", for the checks of studies. */
#include <math.h>
#include <string.h>
#include "common/base/info.h"
#include "studies/study.h"

static bool same_value(const char *a, const char *b)
{
    double x, y;
    if (info_number_parse(a, &x) == 0 && info_number_parse(b, &y) == 0) return x == y;
    return strcmp(a, b) == 0;
}

/* A wanted column that the table lacks matches nothing. */
static bool matches(const Table *t, int row, const char *condition)
{
    char column[64];
    size_t n = strcspn(condition, "=");
    if (n >= sizeof column || condition[n] != '=') return false;
    memcpy(column, condition, n);
    column[n] = '\0';
    return table_column(t, column) >= 0 &&
           same_value(table_text(t, row, column), condition + n + 1);
}

bool row_matches(const Table *t, int row, int n, const char *const where[])
{
    for (int k = 0; k < n; k++)
        if (!matches(t, row, where[k])) return false;
    return true;
}

int select_rows(const Table *t, int n, const char *const where[], const char *want, int max,
                double out[])
{
    int found = 0;
    for (int row = 0; row < t->nrow && found < max; row++)
        if (row_matches(t, row, n, where)) out[found++] = table_number(t, row, want);
    return found;
}
