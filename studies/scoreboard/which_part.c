/* which_part.c: which method for which error, from the table of costs that study T-2 leaves. */
#include <math.h>
#include <string.h>
#include "studies/runs/must.h"
#include "parts.h"
#include "studies/runs/engines.h"
#include "studies/select.h"

static const char costs[] = "t_02_work_precision";
static const char *const targets[] = {"0.01", "0.001", "0.0003", "0.0001"};
enum { TARGETS = 4 };

static bool is_reached(const Table *t, int row)
{
    return select_is(t, row, "how", "reached") || select_is(t, row, "how", "below");
}

static bool has_particles(const Table *t, int row)
{
    return isfinite(select_number(t, row, "ppc"));
}

/* The row of least time to this error, with particles or without; extrapolated only if none gets
 * there. -1: none. */
static int cheapest(const Table *t, const char *problem, const char *target, bool particles)
{
    int best = -1;
    EACH_ROW(row, t, "problem=%s target=%s", problem, target) {
        if (select_is(t, row, "how", "never") || has_particles(t, row) != particles) continue;
        const bool firm = is_reached(t, row);
        if (best < 0 || firm > is_reached(t, best) ||
            (firm == is_reached(t, best) &&
             select_number(t, row, "seconds") < select_number(t, best, "seconds")))
            best = row;
    }
    return best;
}

static void seconds(FILE *f, const Table *t, int row)
{
    const double s = select_number(t, row, "seconds");
    const char *sign = select_is(t, row, "how", "below")          ? "&le; "
                       : select_is(t, row, "how", "extrapolated") ? "~ "
                                                                  : "";
    if (select_is(t, row, "how", "never") || !isfinite(s))
        fputs("&ndash;", f);
    else if (s < 1e-3)
        fprintf(f, "%s%.3g &micro;s", sign, 1e6 * s);
    else
        fprintf(f, "%s%.3g %s", sign, s < 1 ? 1e3 * s : s, s < 1 ? "ms" : "s");
}

/* "GIMP, fitted, 4 per cell, N = 20" */
static void options(FILE *f, const Table *t, int row)
{
    page_text(f, engine_label(select_text(t, row, "method")));
    fputs("</b> <span class=\"soft\">", f);
    if (has_particles(t, row))
        fprintf(f, "%s, %.2g per cell, %s, ",
                select_is(t, row, "layout", "radial") ? "fitted" : "lattice",
                select_number(t, row, "ppc"), select_text(t, row, "integrator"));
    fprintf(f, "N = %.0f%s</span>", select_number(t, row, "cells"),
            select_is(t, row, "how", "extrapolated") ? ", extrapolated" : "");
}

static void answer(FILE *f, const Table *t, int row)
{
    if (row < 0) return;
    fputs("<div><span class=\"n best\">", f);
    seconds(f, t, row);
    fputs("</span> <b>", f);
    options(f, t, row);
    fputs("</div>", f);
}

static void problem_row(FILE *f, const Table *t, const char *problem)
{
    const Info *info = engine_problem(problem);
    page_element(f, "<tr><th>", problem, "<br><span class=\"soft\">");
    page_element(f, "", info ? info->about : "", "</span></th>");
    for (int k = 0; k < TARGETS; k++) {
        const int particles = cheapest(t, problem, targets[k], true);
        const int mesh = cheapest(t, problem, targets[k], false);
        fprintf(f, "<td data-label=\"error %s:\">", targets[k]);
        if (particles < 0) fputs("<div class=\"soft\">no particle method gets there</div>", f);
        answer(f, t, particles);
        answer(f, t, mesh);
        fputs("</td>", f);
    }
    fputs("</tr>\n", f);
}

void page_which(const Page *page)
{
    Table *t = table_read_part(page->dir, costs, "reach", NULL);
    const char *last = "";
    if (!t) {
        fprintf(page->f, "<p>Not run yet: <code>build/mpmlab study %s</code></p>\n", costs);
        return;
    }
    fprintf(page->f,
            "<p>CPU time of the step loop to reach a largest error (of all points and steps, "
            "scaled as <code>describe</code> says), at the cheapest options tried; the best "
            "particle method, and FEM below it. ~ is extrapolated, &le; is the coarsest mesh "
            "tried. <a href=\"#%s\">All methods and the figure</a>.</p>\n<table class=\"stack\" "
            "id=\"prices\"><thead><tr><th>problem</th><th>error "
            "1e-2</th><th>1e-3</th><th>3e-4</th><th>1e-4</th>"
            "</tr></thead><tbody>\n",
            costs);
    for (int row = t->nrow - 1; row >= 0; row--) { /* the ring first */
        const char *problem = select_text(t, row, "problem");
        if (strcmp(problem, last) != 0) problem_row(page->f, t, problem);
        last = problem;
    }
    fputs("</tbody></table>\n", page->f);
    table_free(t);
}

void page_prices(const Page *page, const char *name)
{
    Table *t = table_read_part(page->dir, name, "reach", NULL);
    if (!t) return;
    fputs("<details open><summary>Every method at its best: CPU time to reach an error</summary>"
          "<div "
          "class=\"scroll\"><table><tr><th>problem</th><th>method</th><th>1e-2</th><th>1e-3</"
          "th><th>3e-4"
          "</th><th>1e-4</th></tr>\n",
          page->f);
    for (int row = 0; row + TARGETS <= t->nrow; row += TARGETS) {
        page_element(page->f, "<tr><td>", select_text(t, row, "problem"), "</td><td>");
        page_element(page->f, "", engine_label(select_text(t, row, "method")), "</td>");
        for (int k = 0; k < TARGETS; k++) {
            fputs("<td class=\"n\">", page->f);
            seconds(page->f, t, row + k);
            fputs("</td>", page->f);
        }
        fputs("</tr>\n", page->f);
    }
    fputs("</table></div></details>\n", page->f);
    table_free(t);
}
