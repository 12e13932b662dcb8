/* stability_part.c: per method: the largest safe time step, its grade in each hard case, what
 * breaks it first and which option helps. All from tables that studies leave: NAME.grades.csv and
 * NAME.remedies.csv (grades.h), T-4's limits and T-5's grid. */
#include <math.h>
#include <string.h>
#include "studies/tables/grades.h"
#include "parts.h"
#include "studies/runs/engines.h"

typedef struct Sheet {
    const Study *study;
    Table *grades, *remedies; /* or NULL */
} Sheet;

enum { SHEETS = 128, METHODS = 64 };

typedef struct Sheets {
    int n;
    Sheet list[SHEETS];
    Table *safe, *pairs;  /* T-4 and T-5, or NULL */
    Table *ring, *points; /* W11-6 and H-5, or NULL */
} Sheets;

static void sheets_read(Sheets *s, const char *dir)
{
    *s = (Sheets){.safe = table_read_part(dir, "t_04_stability", "safe", NULL),
                  .pairs = table_read_part(dir, "t_05_compatibility", "grid", NULL),
                  .ring = table_read_part(dir, "w11_06_ring", NULL, NULL),
                  .points = table_read_part(dir, "h_05_small_mass", "points", NULL)};
    for (const Study *study = studies; study->name && s->n < SHEETS; study++) {
        Sheet one = {study, table_read_part(dir, study->name, "grades", NULL),
                     table_read_part(dir, study->name, "remedies", NULL)};
        if (one.grades || one.remedies) s->list[s->n++] = one;
    }
}

static void sheets_free(Sheets *s)
{
    for (int k = 0; k < s->n; k++) {
        table_free(s->list[k].grades);
        table_free(s->list[k].remedies);
    }
    table_free(s->safe);
    table_free(s->pairs);
    table_free(s->ring);
    table_free(s->points);
}

static Mark mark_read(const char *word)
{
    for (Mark m = MARK_OK; m < MARKS; m++)
        if (strcmp(word, grade_mark_names[m]) == 0) return m;
    return MARK_LOST;
}

/* "1D cd 0.7, uvf 1.4": the limits of T-4. */
static void safe_steps(FILE *f, const Table *t, const char *method)
{
    int found = 0;
    for (int dim = 1; dim <= 3; dim++) {
        int here = 0;
        EACH_ROW(row, t, "method=%s", method) {
            if (select_number(t, row, "dim") != dim) continue;
            if (here == 0)
                fprintf(f, "%s<span class=\"soft\">%dD</span> ", found ? "<br>" : "", dim);
            page_element(f, here ? ", " : "", select_text(t, row, "integrator"), " ");
            fprintf(f, "%.2g", select_number(t, row, "safe_cfl"));
            here++, found++;
        }
    }
    if (!found) fputs("&ndash;", f);
    EACH_ROW(row, t, "method=%s", method)
        if (select_text(t, row, "first_failure")[0]) {
            page_element(f, "<br><span class=\"soft\">then ", select_text(t, row, "first_failure"),
                         "</span>");
            break;
        }
}

/* The largest CFL number of W11-6 up to which every run on the ring, N = 32, reached its end. */
static double ring_limit(const Table *t, const char *method)
{
    const char *layout = strstr(method, "wls") ? "radial" : "cartesian";
    double lost = INFINITY, most = NAN;
    for (int pass = 0; t && pass < 2; pass++)
        EACH_ROW(row, t, "method=%s layout=%s cells=32", method, layout) {
            const double cfl = select_number(t, row, "cfl");
            if (pass == 0 && select_is_lost(t, row)) lost = fmin(lost, cfl);
            if (pass == 1 && cfl < lost) most = fmax(isnan(most) ? 0 : most, cfl);
        }
    return most;
}

/* The least critical step of H-5, over all depths [h/c]. */
static double touched_limit(const Table *t, const char *method)
{
    double least = NAN;
    EACH_ROW(row, t, "method=%s", method)
        least = fmin(isnan(least) ? INFINITY : least, select_number(t, row, "critical"));
    return least;
}

/* What limits the step elsewhere than on one wave. */
static void other_steps(FILE *f, const Sheets *s, const char *method)
{
    const double ring = ring_limit(s->ring, method), touched = touched_limit(s->points, method);
    if (!isnan(ring)) fprintf(f, "<br><span class=\"soft\">ring</span> %.2g", ring);
    if (!isnan(touched)) fprintf(f, "<br><span class=\"soft\">edge</span> %.2g", touched);
}

static void marks(FILE *f, const Sheets *s, const char *method)
{
    static const char *const signs[MARKS] = {"&#10003;", "~", "&times;"};
    for (const Sheet *one = s->list; one < s->list + s->n; one++)
        EACH_ROW(row, one->grades, "method=%s", method) {
            const Mark m = mark_read(select_text(one->grades, row, "grade"));
            fprintf(f, "<a class=\"m %s\" href=\"#%s\"", grade_mark_names[m], one->study->name);
            page_element(f, " title=\"", select_text(one->grades, row, "note"), "\">");
            page_element(f, "", select_text(one->grades, row, "case"), " ");
            fprintf(f, "%s</a>", signs[m]);
        }
}

/* The first hard case that it is worst at. */
static void first_break(FILE *f, const Sheets *s, const char *method)
{
    const Sheet *found = NULL;
    int at = 0;
    Mark worst = MARK_OK;
    for (const Sheet *one = s->list; one < s->list + s->n; one++)
        EACH_ROW(row, one->grades, "method=%s", method) {
            const Mark m = mark_read(select_text(one->grades, row, "grade"));
            if (m <= worst) continue;
            worst = m;
            found = one;
            at = row;
        }
    if (!found) {
        fputs("nothing tried here", f);
        return;
    }
    page_element(f, "<b>", select_text(found->grades, at, "case"), "</b>");
    fputs(worst == MARK_WEAK ? " (weak): " : ": ", f);
    page_text(f, select_text(found->grades, at, "note"));
}

/* How a pair of T-5 went: 0 best, 3 lost; -1: not tried. */
static int pair_grade(const Table *t, const char *method, const char *integrator)
{
    EACH_ROW(row, t, "method=%s", method)
        if (select_is(t, row, "integrator", integrator)) return (int)select_number(t, row, "grade");
    return -1;
}

static int fresh_gradients(FILE *f, const Table *t, const char *method)
{
    const int stale = pair_grade(t, method, "musl"), fresh = pair_grade(t, method, "musl fresh");
    if (fresh < 0 || fresh >= stale) return 0;
    fputs("<code>refresh=1</code> <span class=\"soft\">musl, uvf (T-5)</span>", f);
    return 1;
}

/* What the same option makes worse in the study's other cases, or does not help. */
static void worse(FILE *f, const Table *t, const char *method, const char *remedy)
{
    EACH_ROW(row, t, "method=%s", method) {
        if (!select_is(t, row, "remedy", remedy)) continue;
        const Mark before = mark_read(select_text(t, row, "before"));
        const Mark after = mark_read(select_text(t, row, "after"));
        if (after < before) continue;
        page_element(f, "; ", select_text(t, row, "case"),
                     after > before ? " worse" : " no better");
        const char *note = select_text(t, row, "note");
        if (*note) page_element(f, " (", note, ")");
    }
}

/* Options under which a case got a better mark. */
static void helps(FILE *f, const Sheets *s, const char *method)
{
    int n = fresh_gradients(f, s->pairs, method);
    for (const Sheet *one = s->list; one < s->list + s->n; one++)
        EACH_ROW(row, one->remedies, "method=%s", method) {
            const Table *t = one->remedies;
            if (mark_read(select_text(t, row, "after")) >= mark_read(select_text(t, row, "before")))
                continue;
            page_element(f, n++ ? "<br><code>" : "<code>", select_text(t, row, "remedy"),
                         "</code> ");
            page_element(f, "<span class=\"soft\">", select_text(t, row, "case"), ": ");
            page_element(f, "", select_text(t, row, "before"), " &rarr; ");
            page_element(f, "", select_text(t, row, "after"), "");
            worse(f, t, method, select_text(t, row, "remedy"));
            fputs("</span>", f);
        }
    if (n == 0) fputs("&ndash;", f);
}

static bool is_graded(const Sheets *s, const char *method)
{
    for (const Sheet *one = s->list; one < s->list + s->n; one++)
        if (select_next(one->grades, -1, "method=%s", method) >= 0) return true;
    return false;
}

static void method_row(FILE *f, const Sheets *s, const char *method)
{
    page_element(f, "<tr><th>", engine_label(method),
                 "</th><td data-label=\"stable on one wave, CFL:\">");
    safe_steps(f, s->safe, method);
    other_steps(f, s, method);
    fputs("</td><td data-label=\"breaks first:\">", f);
    first_break(f, s, method);
    fputs("</td><td>", f);
    marks(f, s, method);
    fputs("</td><td data-label=\"helps:\">", f);
    helps(f, s, method);
    fputs("</td></tr>\n", f);
}

void page_stability(const Page *page)
{
    Sheets s;
    const char *names[METHODS];
    sheets_read(&s, page->dir);
    const int n = engine_method_names(names, METHODS);
    if (s.n == 0)
        fputs("<p>Not run yet: <code>build/mpmlab study all</code></p>\n", page->f);
    else
        fputs(
            "<p>Stable on one wave: the largest CFL at which ten periods of a standing wave (sine "
            "bar; in 2D axis-aligned waves) neither end early nor gain 5 % of energy, at every "
            "amplitude and number of particles tried (T-4). No more than that: below it stand "
            "the largest CFL up to which every run of the oscillating ring reaches its end "
            "(W11-6, N = 32), and the least stable step if a free edge lies barely inside a cell "
            "(H-5). What helps is what gave a better mark in a run, with what it makes worse."
            "</p>\n<details><summary>Hard cases: &#10003;, ~ or &times;, and where the lines are "
            "drawn</summary><ul><li>H-1 force inside a uniformly stressed body / (sigma A): 1e-10, "
            ".1</li><li>H-2 null space: left after 1500 steps: .1, 1.1</li><li>H-3 stress at "
            "stretch 4: right, or right but not carried</li><li>H-4 cantilever at nu = .499: bends "
            "within .1, .5 of the reference</li><li>H-5 stable step with an edge barely in a cell: "
            ".3, .1 h/c</li><li>H-6, H-10 error of a linear field: 1e-12, 1</li><li>H-7 particles "
            "per "
            "axis for an error below .1: .5, 1.5</li><li>H-8a area after ten imposed turns: within "
            ".01; any</li><li>H-8b angular momentum per turn: .002, 1</li><li>H-13 energy over "
            "long "
            "runs: 5 %; reaches the end</li><li>H-14 free fall: 1e-12, 1e-3 m</li><li>H-15 vortex, "
            "G = .5: error .03 m; reaches the end</li></ul></details>\n<table class=\"stack sort\" "
            "id=\"hard\"><thead><tr><th>method</th><th>stable on one wave</th><th>breaks "
            "first</th><th>hard cases</th><th>what helps</th></tr></thead><tbody>\n",
            page->f);
    for (int k = 0; k < n && s.n > 0; k++)
        if (is_graded(&s, names[k])) method_row(page->f, &s, names[k]);
    if (s.n > 0) fputs("</tbody></table>\n", page->f);
    sheets_free(&s);
}
