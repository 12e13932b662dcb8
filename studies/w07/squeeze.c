/* squeeze.c: see squeeze.h. */
#include "squeeze.h"

#include <math.h>
#include "studies/select.h"

void squeeze_add(Cases *list, const char *method, const char *field, int cells, int step,
                 bool quick)
{
    for (int n = cells / 2; n <= 10 * cells; n += quick ? 25 * step : step)
        case_add(list, "run squeeze --method %s --cells %d --set field=%s --set particles=%d",
                 method, cells, field, n);
}

void squeeze_add_quadratic(Cases *list, const char *methods, bool quick)
{
    EACH_WORD(m, methods) squeeze_add(list, m, "quadratic", SQUEEZE_CELLS, 1, quick);
}

double squeeze_plateau(void)
{
    const double h = 1 / (double)SQUEEZE_CELLS;
    return h * h / 6 / pow(1 + h, 2);
}
