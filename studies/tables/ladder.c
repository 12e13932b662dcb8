/* ladder.c: see ladder.h. */
#include "ladder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "studies/runs/must.h"
#include "studies/select.h"

static Mark grade_of(const Table *rows, int row)
{
    if (select_is_lost(rows, row)) return MARK_LOST;
    return select_is(rows, row, "status", "ok") ? MARK_OK : MARK_WEAK;
}

/* What rows of one ladder have in common; those first that tell most of them apart. */
static const char *const inputs[] = {"params", "method", "integrator", "ppc",
                                     "cells",  "layout", "t_end",      "problem"};
enum { INPUTS = sizeof inputs / sizeof *inputs };

static bool is_same(const Table *rows, const int column[INPUTS], int a, int b)
{
    for (int k = 0; k < INPUTS; k++)
        if (strcmp(rows->cell[a * rows->ncol + column[k]],
                   rows->cell[b * rows->ncol + column[k]]) != 0)
            return false;
    return true;
}

/* Index of the ladder that this row belongs to, or n if it begins a new one. The previous row's
 * ladder is tried first. */
static int find(const Ladder *list, int n, int last, const Table *rows, const int column[INPUTS],
                int row)
{
    if (n > 0 && is_same(rows, column, list[last].row[0], row)) return last;
    int k = 0;
    while (k < n && !is_same(rows, column, list[k].row[0], row)) k++;
    return k;
}

/* Inserts the rung in order of CFL; a CFL that is already present is ignored. */
static void add_rung(Ladder *l, const Table *rows, int row, Mark grade)
{
    const double cfl = select_number(rows, row, "cfl");
    int at = l->n;
    while (at > 0 && l->cfl[at - 1] > cfl) at--;
    if (l->n == MOST_RUNGS || (at > 0 && !(l->cfl[at - 1] < cfl))) return;
    for (int k = l->n++; k > at; k--) {
        l->row[k] = l->row[k - 1];
        l->cfl[k] = l->cfl[k - 1];
        l->grade[k] = l->grade[k - 1];
    }
    l->row[at] = row;
    l->cfl[at] = cfl;
    l->grade[at] = grade;
}

int ladder_read_all(const Table *rows, Ladder **out)
{
    int n = 0, at = 0, column[INPUTS];
    *out = NULL;
    for (int k = 0; k < INPUTS; k++)
        if ((column[k] = table_column(rows, inputs[k])) < 0) return 0;
    for (int row = 0; row < rows->nrow; row++) {
        at = find(*out, n, at, rows, column, row);
        if (at == n) {
            *out = must_grow(*out, n, sizeof **out);
            (*out)[n++] = (Ladder){0};
        }
        add_rung(&(*out)[at], rows, row, grade_of(rows, row));
    }
    return n;
}

double ladder_limit(const Ladder *l, Mark worst, int *first)
{
    int k = 0;
    while (k < l->n && l->grade[k] <= worst) k++;
    *first = k < l->n ? k : -1;
    return k > 0 ? l->cfl[k - 1] : 0;
}

bool ladder_window(const Ladder *l, int *low, int *high)
{
    *high = l->n - 1;
    while (*high >= 0 && l->grade[*high] != MARK_OK) *high -= 1;
    *low = *high;
    while (*low > 0 && l->grade[*low - 1] == MARK_OK) *low -= 1;
    return *high >= 0;
}

/* The run of a row at another CFL number. */
static void add_case(Cases *list, const Table *rows, int row, double cfl)
{
    static const char *const options[] = {"method", "integrator", "cells", "ppc_asked", "t_end"};
    static const char *const names[] = {"method", "integrator", "cells", "ppc", "t-end"};
    char params[512], *rest = params;
    const char *text =
        phrase("run %s --cfl %.17g --set layout=%s", select_text(rows, row, "problem"), cfl,
               select_text(rows, row, "layout"));
    for (int k = 0; k < 5; k++) {
        const char *value = select_text(rows, row, options[k]);
        if (*value) text = phrase("%s --%s %s", text, names[k], value);
    }
    snprintf(params, sizeof params, "%s", select_text(rows, row, "params"));
    for (char *set; (set = strtok_r(rest, ";", &rest));) text = phrase("%s --set %s", text, set);
    case_add(list, "%s", text);
}

void ladder_split(Cases *list, const Table *rows, const Ladder *l, int k, double relative,
                  double least)
{
    const double high = l->cfl[k + 1], low = k < 0 ? 0 : l->cfl[k], cfl = (low + high) / 2;
    if (k < 0 ? cfl < least * (1 - 1e-9) : high - low <= relative * high) return;
    add_case(list, rows, l->row[0], cfl);
}

void ladder_refine_windows(Cases *list, const Table *rows, double above, double below)
{
    Ladder *ladders;
    const int n = ladder_read_all(rows, &ladders);
    for (const Ladder *l = ladders; l < ladders + n; l++) {
        int low, high;
        if (!ladder_window(l, &low, &high)) continue;
        if (high < l->n - 1) ladder_split(list, rows, l, high, above, 0);
        if (low > 0) ladder_split(list, rows, l, low - 1, below, 0);
    }
    free(ladders);
}
