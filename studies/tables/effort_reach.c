/* effort_reach.c: what it costs to reach a given error: NAME.reach.csv of effort.h. */
#include <math.h>
#include <string.h>
#include "studies/select.h"
#include "effort.h"

enum { TARGETS = 4 };
static const double targets[TARGETS] = {1e-2, 1e-3, 3e-4, 1e-4};
static const double least_order = 0.5, least_kept = 0.75, most_finer = 2; /* of an extrapolation */

typedef enum How { REACHED, BELOW, EXTRAPOLATED, NEVER } How;
static const char *const how_names[] = {"reached", "below", "extrapolated", "never"};

typedef struct Cost {
    How how;
    double cells, seconds, work, instructions;
    const Effort *options; /* whose options these are */
} Cost;

/* Do meshes continue from a to b? */
static bool same_series(const Effort *a, const Effort *b)
{
    return strcmp(a->problem, b->problem) == 0 && strcmp(a->method, b->method) == 0 &&
           strcmp(a->integrator, b->integrator) == 0 && strcmp(a->layout, b->layout) == 0 &&
           b->cells > a->cells;
}

/* y where x = x0 ... x1 takes the value at, on a straight line in log-log. */
static double on_line(double x0, double x1, double y0, double y1, double at)
{
    return y0 * pow(y1 / y0, log(at / x0) / log(x1 / x0));
}

static Cost between(const Effort *a, const Effort *b, double target, How how)
{
    const double n = on_line(a->error, b->error, a->cells, b->cells, target);
    return (Cost){how,
                  n,
                  on_line(a->cells, b->cells, a->cpu, b->cpu, n),
                  on_line(a->cells, b->cells, a->work, b->work, n),
                  on_line(a->cells, b->cells, a->instructions, b->instructions, n),
                  b};
}

static double order(const Effort *a, const Effort *b)
{
    return -log(b->error / a->error) / log(b->cells / a->cells);
}

/* What lies beyond the finest meshes (last two, or three, of e), if they converge, do not flatten
 * out, and it is not too far. */
static Cost beyond(const Effort *const e[3], double target)
{
    const double p = e[1] ? order(e[1], e[2]) : 0, before = e[0] ? order(e[0], e[1]) : p;
    if (p >= least_order && p >= least_kept * before &&
        pow(e[2]->error / target, 1 / p) <= most_finer)
        return between(e[1], e[2], target, EXTRAPOLATED);
    return (Cost){.how = NEVER, .options = e[2]};
}

/* One series, from coarse to fine; lost runs are passed over. */
static Cost series_cost(const Effort *first, int n, double target)
{
    const Effort *last[3] = {NULL, NULL, NULL};
    for (const Effort *e = first; e < first + n; e++) {
        if (!e->usable) continue;
        if (e->error <= target && last[2]) return between(last[2], e, target, REACHED);
        if (e->error <= target) return (Cost){BELOW, e->cells, e->cpu, e->work, e->instructions, e};
        last[0] = last[1];
        last[1] = last[2];
        last[2] = e;
    }
    return last[2] ? beyond(last, target) : (Cost){.how = NEVER, .options = first};
}

/* Reached or below beats extrapolated, which beats never; then the time decides. */
static bool is_better(const Cost *a, const Cost *b)
{
    const How how_a = a->how == BELOW ? REACHED : a->how,
              how_b = b->how == BELOW ? REACHED : b->how;
    if (!b->options || how_a != how_b) return !b->options || how_a < how_b;
    return a->seconds < b->seconds;
}

/* The best of all series of e's problem and method. */
static Cost best_cost(const Efforts *all, const Effort *e, double target)
{
    Cost best = {0};
    for (int from = 0, to; from < all->n; from = to) {
        const Effort *first = &all->list[from];
        for (to = from + 1; to < all->n && same_series(&all->list[to - 1], &all->list[to]);) to++;
        if (strcmp(first->problem, e->problem) != 0 || strcmp(first->method, e->method) != 0)
            continue;
        const Cost c = series_cost(first, to - from, target);
        if (is_better(&c, &best)) best = c;
    }
    return best;
}

/* NAN for a cost of 0, which was not measured: its cell stays empty. */
static double some(double x)
{
    return x > 0 ? x : NAN;
}

static void write_cost(FILE *f, const Cost *c, double target)
{
    const Effort *o = c->options;
    results_print(f, "%s,%g,%s,%s,%.6g,%.6g,%.6g,%.6g,", o->problem, target, o->method,
                  how_names[c->how], some(c->seconds), some(c->work), some(c->instructions),
                  some(c->cells));
    if (c->how == NEVER)
        fputs(",,\n", f);
    else
        results_print(f, "%s,%s,%.6g\n", o->integrator, o->layout, some(o->ppc));
}

void effort_reach_write(FILE *f, const Efforts *all)
{
    for (int k = 0; k < all->n; k++) {
        const Effort *e = &all->list[k], *before = k ? e - 1 : NULL;
        if (before && strcmp(before->problem, e->problem) == 0 &&
            strcmp(before->method, e->method) == 0)
            continue;
        for (int t = 0; t < TARGETS; t++) {
            const Cost c = best_cost(all, e, targets[t]);
            write_cost(f, &c, targets[t]);
        }
    }
}

Measure effort_ratio(const Results *r, const char *target, const char *column, const char *method,
                     const char *beside)
{
    static const char where[] = "%s method=%s how=reached";
    const Table *t = results_part(r, "reach");
    return measure_ratio(select_value(t, column, where, target, method),
                         select_value(t, column, where, target, beside));
}
