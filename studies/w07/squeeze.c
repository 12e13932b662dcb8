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

Measure squeeze_at_ten(const Curve *c)
{
    const double at_10 = 1 + 0.5 / 100;
    return measure_times(curve_at(c, 10), 1 / (squeeze_plateau() * at_10));
}

Measure squeeze_exponent(const Curve *c, double width, double least)
{
    double at[CURVE_MAX] = {0}, worst[CURVE_MAX] = {0};
    const int intervals = (int)lround(8 / width);
    for (int k = 0; k < c->n; k++) {
        const int i = (int)floor((c->x[k] - 2) / width);
        const double y = c->y[k] - least;
        if (c->x[k] < 2 || i >= intervals || y <= worst[i]) continue;
        if (!isnan(worst[i])) at[i] = c->x[k];
        worst[i] = measure_worse(worst[i], y);
    }
    return measure_with(curve_max(c, SQUEEZE_POINTS), curve_slope(intervals, at, worst));
}
