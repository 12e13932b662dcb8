/* needs_part.c: which method by need: the best of all runs that a study made of it, with the number
 * and the figure that show it. */
#include <math.h>
#include <string.h>
#include "studies/runs/engines.h"
#include "studies/select.h"
#include "parts.h"

/* Rows of `study`.`part` that meet `where`; the least |column - right| wins. */
static const struct Need {
    const char *need, *study, *part, *where, *column;
    double right;
    const char *shows; /* what the number is; printf format of it */
} needs[] = {
    {"a free surface in smooth motion", "w11_06_ring", NULL, "cells=32 cfl=0.3 status=ok",
     "error_linf", 0, "largest error %.3g m on the ring, N = 32"},
    {"no free surface, smooth motion", "t_02_work_precision", "points",
     "problem=axis_mms cells=32 status=ok", "error", 0,
     "largest error %.3g of the amplitude, axis_mms, N = 32"},
    {"large rotation", "h_08_spin", "turns", "scene=free variant=usual status=ok", "loss", 0,
     "angular momentum changes by %.2g of itself per turn"},
    {"large shear", "h_15_large_deformation", "errors", "cells=24 status=ok", "error", 0,
     "largest error %.3g m, vortex, G = .5, N = 24"},
    {"a nearly incompressible material: displacements (pressures oscillate with every method)",
     "h_04_locking", "locking", "problem=cantilever nu=0.499 status=ok", "ratio", 1,
     "bends %.3g times as far as the reference at nu = .499"},
};

/* The best row with particles, or of FEM if `mesh`; -1: none. */
static int best_row(const Table *t, const struct Need *n, bool mesh)
{
    int best = -1;
    double least = INFINITY;
    EACH_ROW(row, t, "%s", n->where) {
        const double off = fabs(select_number(t, row, n->column) - n->right);
        if (select_is(t, row, "method", "fem") != mesh || !(off < least)) continue;
        least = off;
        best = row;
    }
    return best;
}

static void answer(FILE *f, const Table *t, const struct Need *n, int row)
{
    char text[160];
    if (row < 0) {
        fputs("<td class=\"soft\">none</td>", f);
        return;
    }
    page_element(f, "<td><b>", engine_label(select_text(t, row, "method")), "</b><br>");
    snprintf(text, sizeof text, n->shows, fabs(select_number(t, row, n->column)));
    page_element(f, "<span class=\"soft\">", text, "");
    if (table_column(t, "layout") >= 0 && !select_is(t, row, "method", "fem"))
        fprintf(f, ", particles %s, %s",
                select_is(t, row, "layout", "radial") ? "fitted to the body" : "on the lattice",
                select_text(t, row, "integrator"));
    fputs("</span></td>", f);
}

void page_needs(const Page *page)
{
    int rows = 0;
    for (const struct Need *n = needs; n < needs + sizeof needs / sizeof *needs; n++) {
        Table *t = table_read_part(page->dir, n->study, n->part, NULL);
        select_begin(n->study);
        if (!t || best_row(t, n, false) < 0) {
            table_free(t);
            continue;
        }
        if (rows++ == 0)
            fputs("<table class=\"stack\" id=\"needs\"><thead><tr><th>need</th><th>best particle "
                  "method</th><th>FEM</th><th>evidence</th></tr></thead><tbody>\n",
                  page->f);
        page_element(page->f, "<tr><th>", n->need, "</th>");
        answer(page->f, t, n, best_row(t, n, false));
        answer(page->f, t, n, best_row(t, n, true));
        fprintf(page->f, "<td><a href=\"#%s\">figure</a></td></tr>\n", n->study);
        table_free(t);
    }
    if (rows) fputs("</tbody></table>\n", page->f);
}
