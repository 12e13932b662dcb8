/* history.c: see history.h. */
#include "history.h"

#include <math.h>
#include "studies/select.h"

double history_first_change(const Table *t, const char *column, double share)
{
    for (int row = 0; row < t->nrow; row++)
        if (fabs(select_number(t, row, column) / select_number(t, 0, column) - 1) > share)
            return select_number(t, row, "t");
    return NAN;
}

double history_rate(const Table *t, const char *column, double from)
{
    const double t1 = select_last(t, "t"), x1 = select_last(t, column);
    double t0 = NAN, x0 = NAN;
    for (int row = 0; row < t->nrow && select_number(t, row, "t") <= from * t1; row++) {
        t0 = select_number(t, row, "t");
        x0 = select_number(t, row, column);
    }
    return (x1 - x0) / (t1 - t0);
}
