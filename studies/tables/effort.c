/* effort.c: the points of effort.h: best of repeats, Pareto fronts. */
#include "effort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "studies/runs/must.h"
#include "studies/runs/engines.h"
#include "studies/runs/run_args.h"
#include "studies/select.h"

/* Instructions of one particle-step, as `make bench` counted them: in 2D, with default integrators;
 * NAN where it has not. */
static double instructions(const Table *bench, const Effort *e)
{
    char text[256];
    const Engine *engine;
    RunSpec spec;
    if (!bench || !engine_has_problem(&engine_2d, e->problem)) return NAN;
    snprintf(text, sizeof text, "run %s --method %s", e->problem, e->method);
    if (run_args_resolve(text, &spec, &engine, NULL) || strcmp(spec.integrator, e->integrator) != 0)
        return NAN;
    return select_value(bench, "instructions_avx2", "case=%s", e->method).value;
}

/* The number of the points that the run moved, times its steps. */
static double work(const Table *t, int row)
{
    const double elements = select_number(t, row, "elements"),
                 steps = select_number(t, row, "steps");
    const double points = isfinite(elements) ? elements : select_number(t, row, "particles");
    return points * (steps > 0 ? steps : 1);
}

/* Is it the same run once more, and did it, too, reach its end? */
static bool is_repeat(const Table *t, int row, int other)
{
    static const char *const same[] = {"problem",    "method", "integrator", "layout",
                                       "error_linf", "cells",  "ppc"};
    for (size_t k = 0; k < sizeof same / sizeof *same; k++)
        if (!select_is(t, row, same[k], select_text(t, other, same[k]))) return false;
    return !select_is_lost(t, other);
}

static Effort point(const Table *t, int row, int repeats, const Table *bench)
{
    Effort e = {.problem = select_text(t, row, "problem"),
                .method = select_text(t, row, "method"),
                .integrator = select_text(t, row, "integrator"),
                .layout = select_text(t, row, "layout"),
                .status = select_text(t, row, "status"),
                .ppc = select_number(t, row, "ppc"),
                .cells = select_number(t, row, "cells"),
                .error = select_number(t, row, "error_linf"),
                .work = work(t, row)};
    double cpu[16];
    const int apart = t->nrow / repeats, n = repeats < 16 ? repeats : 16;
    bool whole = t->nrow % repeats == 0;
    for (int k = 0; k < n; k++) {
        cpu[k] = select_number(t, row + k * apart, "cpu_s");
        whole = whole && cpu[k] > 0 && is_repeat(t, row, row + k * apart);
    }
    e.median = measure_median(n, cpu); /* sorts */
    e.cpu = cpu[0];
    e.instructions = e.work * instructions(bench, &e);
    e.usable = whole && e.error > 0;
    return e;
}

typedef enum Price { BY_TIME, BY_WORK } Price;

static double price(const Effort *e, Price by)
{
    return by == BY_TIME ? e->cpu : e->work;
}

/* Is there a usable point of the same problem (and method) that costs no more and errs no more? Of
 * equals the last one stays. */
static bool is_beaten(const Efforts *all, const Effort *e, Price by, bool by_method)
{
    for (const Effort *o = all->list; o < all->list + all->n; o++) {
        if (!o->usable || !(price(o, by) <= price(e, by) && o->error <= e->error)) continue;
        const bool same = price(o, by) >= price(e, by) && o->error >= e->error;
        if ((same && o <= e) || strcmp(o->problem, e->problem) != 0) continue;
        if (!by_method || strcmp(o->method, e->method) == 0) return true;
    }
    return false;
}

static void mark_fronts(Efforts *all)
{
    for (Effort *e = all->list; e < all->list + all->n; e++) {
        if (!e->usable) continue;
        e->front = !is_beaten(all, e, BY_TIME, false);
        e->front_work = !is_beaten(all, e, BY_WORK, false);
        e->front_own = !is_beaten(all, e, BY_TIME, true);
        e->front_own_work = !is_beaten(all, e, BY_WORK, true);
    }
}

static void write_points(FILE *f, const Efforts *all)
{
    for (const Effort *e = all->list; e < all->list + all->n; e++) {
        results_print(f, "%s,%s,%s,%s,%s,%.10g,%.10g,%.10g,", e->problem, e->method, e->integrator,
                      e->layout, e->status, e->ppc, e->cells, e->error);
        results_print(f, "%.10g,%.10g,%.10g,%.10g,%d,%d,%d,%d\n", e->cpu, e->median, e->work,
                      e->instructions, e->front, e->front_work, e->front_own, e->front_own_work);
    }
}

void effort_tables(const Results *r, int repeats)
{
    const Table *rows = r->rows;
    Efforts all = {0};
    Table *bench = table_read_part(r->dir, "t_03_speed", NULL, NULL);
    for (int row = 0; row < rows->nrow / repeats; row++) {
        all.list = must_grow(all.list, all.n, sizeof *all.list);
        all.list[all.n++] = point(rows, row, repeats, bench);
    }
    mark_fronts(&all);
    write_points(results_write(r, "points",
                               "problem,method,integrator,layout,status,ppc,cells,error,cpu_s,"
                               "cpu_median,work,instructions,front,front_work,front_own,"
                               "front_own_work"),
                 &all);
    effort_reach_write(results_write(r, "reach",
                                     "problem,target,method,how,seconds,work,instructions,cells,"
                                     "integrator,layout,ppc"),
                       &all);
    table_free(bench);
    free(all.list);
}
