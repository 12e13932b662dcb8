/* graded.c: see graded.h. */
#include "graded.h"

#include <math.h>
#include "spline.h"

const char *const graded_names[GRADED_METHODS] = {"mpm", "gimp", "ge_mpm", "ge_gimp", "wls"};

void graded_make(Graded *g, int n, double cells, double sizes)
{
    static const int steps[] = {0, 1, 2, 3, 2, 1};
    g->n = n;
    g->x[0] = 0;
    for (int k = 0; k < n; k++) g->x[k + 1] = g->x[k] + pow(cells, steps[k % 6]);
    const double length = g->x[n];
    for (int k = 0; k <= n; k++) g->x[k] /= length;
    for (int k = 0; k < n; k++) {
        const double h = g->x[k + 1] - g->x[k], first = h / (1 + (k % 2 ? 1 : sizes));
        g->half[2 * k] = 0.5 * first;
        g->half[2 * k + 1] = 0.5 * (h - first);
        g->at[2 * k] = g->x[k] + 0.5 * first;
        g->at[2 * k + 1] = g->x[k] + 0.5 * (h + first);
    }
}

/* Integral of node i's tent from its left neighbour to x. */
static double tent_integral(const Graded *g, int i, double x)
{
    const double a = g->x[i - 1], b = g->x[i], c = g->x[i + 1];
    const double left = fmin(fmax(x, a), b) - a, right = c - fmin(fmax(x, b), c);
    return 0.5 * left * left / (b - a) + 0.5 * (c - b) - 0.5 * right * right / (c - b);
}

static double tent(const Graded *g, int i, double x)
{
    const double side = x < g->x[i] ? g->x[i] - g->x[i - 1] : g->x[i + 1] - g->x[i];
    return fmax(1 - fabs(x - g->x[i]) / side, 0);
}

double graded_weight(const Graded *g, GradedMethod method, int i, int p)
{
    const double x = g->at[p], l = g->half[p];
    if (method == GRADED_FIT)
        return spline_quadratic((x - g->x[i]) / (0.5 * (g->x[i + 1] - g->x[i - 1])));
    if (method == GRADED_TENT || method == GRADED_GE_TENT) return tent(g, i, x);
    return (tent_integral(g, i, x + l) - tent_integral(g, i, x - l)) / (2 * l);
}

static double velocity(bool quadratic, double x)
{
    return 1 + (quadratic ? x * x : x);
}

double graded_error(const Graded *g, GradedMethod method, bool quadratic)
{
    double most = 0;
    for (int i = 2; i <= g->n - 2; i++) {
        double sum[3] = {0}, load[2] = {0};
        for (int p = 0; p < 2 * g->n; p++) {
            const double m = method == GRADED_FIT ? 1 : g->half[p],
                         w = m * graded_weight(g, method, i, p);
            if (w == 0) continue;
            const double r = g->at[p] - g->x[i], slope = quadratic ? 2 * g->at[p] : 1;
            const bool enhanced = method == GRADED_GE_TENT || method == GRADED_GE_GIMP;
            const double v = velocity(quadratic, g->at[p]) - (enhanced ? slope * r : 0);
            for (int k = 0; k < 3; k++) sum[k] += w * pow(r, k);
            for (int k = 0; k < 2; k++) load[k] += w * v * pow(r, k);
        }
        const double det = sum[0] * sum[2] - sum[1] * sum[1];
        const double value =
            method == GRADED_FIT ? (load[0] * sum[2] - load[1] * sum[1]) / det : load[0] / sum[0];
        most = fmax(most, fabs(value - velocity(quadratic, g->x[i])));
    }
    return most;
}
