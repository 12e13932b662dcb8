/* stability.c: see stability.h. */
#include "stability.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "ladder.h"
#include "studies/runs/engines.h"
#include "studies/select.h"

/* Bits of pairs[]: of the plane cd and uvf, with and without a fresh gradient; T-5 has the others.
 */
enum { ALL = 127, CD_UVF = 1 | 8 | 64 };

const Map stability_maps[MAPS] = {
    {&engine_1d, "sine_bar", {20, 40}, ALL, 0.02, {1, 2, 2.5, 4}, {1e-4, 0.01, 0.05}, 1, 1},
    {&engine_2d, "axis_mms", {8, 8}, CD_UVF, 0.02, {4, 9}, {0.01, 0.05}, 0, 0},
};
const double stability_rungs[MAP_RUNGS] = {0.1, 0.2, 0.4, 0.6, 0.8, 1, 1.2, 1.4, 1.6, 2};

bool stability_is_usual(const Map *map, const char *method, Pair pair)
{
    char usual[16];
    pair_default_integrator(map->engine, map->problem, method, usual);
    return !pair.refresh && strcmp(usual, pair.integrator) == 0;
}

bool stability_has_pair(const Map *map, const char *method, int k)
{
    if (!(map->pairs >> k & 1) && !stability_is_usual(map, method, pairs[k])) return false;
    return pair_is_run(map->engine, map->problem, method, pairs[k]);
}

/* Leading columns of all tables here: the method and integrator that a ladder belongs to. */
static const char place_header[] = "dim,method,integrator,refresh,default,pair,line";

const Map *stability_of_row(const Table *rows, int row)
{
    const Map *map = stability_maps;
    while (!select_is(rows, row, "problem", map->problem)) map++;
    return map;
}

static const char *place_of(const Table *rows, int row)
{
    const Map *map = stability_of_row(rows, row);
    const char *method = select_text(rows, row, "method");
    const int k = pair_of_row(rows, row);
    return phrase("%d,%s,%s,%d,%d,%d,%d", map->engine->dim, method, pairs[k].integrator,
                  pairs[k].refresh, stability_is_usual(map, method, pairs[k]), k,
                  engine_line(map->engine, method));
}

/* Index of x in a list that ends after n numbers or at the first 0; -1: x is not in it. */
static int index_of(int n, const double *list, double x)
{
    for (int k = 0; k < n && list[k] > 0; k++)
        if (fabs(list[k] - x) <= 1e-9 * x) return k;
    return -1;
}

/* Index of the rung of the map; -1: a CFL number that a bisection added. */
static int column_of(double cfl)
{
    return index_of(MAP_RUNGS, stability_rungs, cfl);
}

/* Writes one line per run. In the figure, rows are grouped by amplitude, one row per PPC, with a
 * gap of one row between groups; FEM has no PPC and fills all rows of a group. */
static void write_map(FILE *f, const Table *rows, const Ladder *l)
{
    const Map *map = stability_of_row(rows, l->row[0]);
    const double A = select_number(rows, l->row[0], "A"),
                 ppc = select_number(rows, l->row[0], "ppc_asked");
    const char *place = place_of(rows, l->row[0]);
    int height = 1;
    while (map->ppc[height - 1] > 0) height++;
    for (int k = 0; k < l->n; k++)
        for (int p = 0; map->ppc[p] > 0 && column_of(l->cfl[k]) >= 0; p++) {
            if (isfinite(ppc) && p != index_of(MAP_MOST, map->ppc, ppc)) continue;
            results_print(f, "%s,%.10g,%g,%g,%d,%d,%d,%s\n", place, ppc, A, l->cfl[k],
                          column_of(l->cfl[k]), index_of(MAP_MOST, map->A, A) * height + p,
                          l->grade[k], select_text(rows, l->row[k], "status"));
        }
}

/* Writes one line per ladder: both limits, and what ends them. */
static void write_limits(FILE *f, const Table *rows, const Ladder *l)
{
    results_print(f, "%s,%s,%g", place_of(rows, l->row[0]),
                  select_text(rows, l->row[0], "ppc_asked"), select_number(rows, l->row[0], "A"));
    for (Mark worst = MARK_OK; worst < MARK_LOST; worst++) {
        int first;
        results_print(f, ",%.6g,", ladder_limit(l, worst, &first));
        if (first < 0)
            results_print(f, ",,");
        else
            results_print(f, "%.6g,%s,%s", l->cfl[first],
                          select_text(rows, l->row[first], "status"),
                          select_text(rows, l->row[first], "reason"));
    }
    putc('\n', f);
}

/* The row of least `what` in the group of rows that agree with row `first` in the columns; -1
 * unless `first` is the first row of its group, so that each group is written once. */
static int least_of_group(const Table *t, int first, const char *what, int n,
                          const char *const columns[])
{
    int best = -1;
    for (int row = 0; row < t->nrow; row++) {
        bool same = true;
        for (int k = 0; k < n && same; k++)
            same = strcmp(select_text(t, row, columns[k]), select_text(t, first, columns[k])) == 0;
        if (!same) continue;
        if (row < first) return -1;
        if (best < 0 || select_number(t, row, what) < select_number(t, best, what)) best = row;
    }
    return best;
}

/* The least limits over PPC, one line per amplitude. */
static void write_worst(FILE *f, const Table *limits)
{
    static const char *const group[] = {"method", "pair", "amplitude", "dim"};
    for (int row = 0; row < limits->nrow; row++) {
        const int s = least_of_group(limits, row, "stable", 4, group);
        const int k = least_of_group(limits, row, "kept", 4, group);
        if (s < 0) continue;
        for (int c = 0; c < 7; c++) results_print(f, "%s,", limits->cell[row * limits->ncol + c]);
        const Map *map = &stability_maps[select_number(limits, row, "dim") > 1];
        const double A = select_number(limits, row, "amplitude");
        results_print(f, "%g,%d,%s,%s\n", A, index_of(MAP_MOST, map->A, A),
                      select_text(limits, s, "stable"), select_text(limits, k, "kept"));
    }
}

/* The least limits over PPC and amplitude, with the method's default integrator. */
static void write_safe(FILE *f, const Table *limits)
{
    static const char *const group[] = {"method", "pair", "dim"};
    for (int row = 0; row < limits->nrow; row++) {
        if (!(select_number(limits, row, "default") > 0)) continue;
        const int s = least_of_group(limits, row, "stable", 3, group);
        if (s < 0) continue;
        results_print(f, "%s,%s,%s,%s,", select_text(limits, s, "method"),
                      select_text(limits, s, "integrator"), select_text(limits, s, "dim"),
                      select_text(limits, s, "stable"));
        if (*select_text(limits, s, "failure"))
            results_print(f, "%s at CFL %s (PPC %s A %s)", select_text(limits, s, "failure"),
                          select_text(limits, s, "fails_at"), select_text(limits, s, "ppc"),
                          select_text(limits, s, "amplitude"));
        putc('\n', f);
    }
}

static FILE *begin(const Results *r, const char *part, const char *columns)
{
    return results_write(r, part, phrase("%s,%s", place_header, columns));
}

void stability_tables(const Results *r)
{
    Ladder *ladders;
    const int n = ladder_read_all(r->rows, &ladders);
    FILE *map = begin(r, "map", "ppc,amplitude,cfl,column,row,grade,status");
    FILE *limits = begin(r, "limits",
                         "ppc,amplitude,stable,fails_at,failure,reason,kept,lost_at,loss,"
                         "loss_reason");
    for (int k = 0; k < n; k++) {
        write_map(map, r->rows, &ladders[k]);
        write_limits(limits, r->rows, &ladders[k]);
    }
    free(ladders);
    const Table *t = results_part(r, "limits");
    write_worst(begin(r, "worst", "amplitude,place,stable,kept"), t);
    write_safe(results_write(r, "safe", "method,integrator,dim,safe_cfl,first_failure"), t);
}
