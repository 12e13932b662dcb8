/* h_02_ringing.c: hard case H2: velocities that the grid cannot see.
 *
 * In a block at rest the particles' velocities alternate, +d and -d; with two or more of them to a
 * cell they cancel at every node inside, v_i = 0. What is left of them is sqrt(K/K_0): of the
 * kinetic energy, in which little else than the ends' motion takes part. FLIP adds a dt to what a
 * particle has and so keeps it for ever; PIC takes velocities from the grid and so forgets it.
 *
 * WLS and WLS2 amplify it: they fit with splines and return with tents, and in a block that does
 * not lie on the grid's lines the mode draws energy until the run is lost. GE-WLS returns with
 * splines and takes the slopes of v from the particles' gradients, and keeps it. */
#include <math.h>
#include <string.h>
#include "studies/tables/files.h"
#include "studies/tables/grades.h"

static const char name[] = "h_02_ringing";
enum { STEPS = 1500, VARIANTS = 3 };
static const int shown[] = {0,  1,   2,   3,   5,   7,   10,  15,   20,   30,  50,
                            70, 100, 150, 200, 300, 500, 700, 1000, 1200, 1500};
enum { SHOWN = sizeof shown / sizeof *shown };

/* As it comes; its filter's first order, which is PIC; returned through splines. */
static const struct {
    const char *name, *param;
} variants[VARIANTS] = {{"usual", NULL}, {"order=1", "order"}, {"return=spline", "return"}};

static bool takes(const Engine *e, const Info *method, int variant)
{
    return has_grid(e, method->name) &&
           (!variants[variant].param || has_param(method, variants[variant].param));
}

static void part_name(char part[96], const char *method, int dim, int variant)
{
    snprintf(part, 96, "%s.%d.%d", method, dim, variant);
}

static void cases(Cases *list, bool quick)
{
    char part[96], file[128];
    for (const Engine *const *e = engines; *e; e++)
        for (const Info *const *m = (*e)->methods; *m; m++)
            for (int v = 0; v < VARIANTS; v++) {
                const int cells = (*e)->dim == 1 ? 128 : 16, steps = quick ? 10 : STEPS;
                if (!takes(*e, *m, v)) continue;
                part_name(part, (*m)->name, (*e)->dim, v);
                snprintf(file, sizeof file, "%s.%s.csv", name, part);
                case_add_with(list, "history", file,
                              "run block --method %s --cells %d --set dim=%d --set ripple=1e-4 "
                              "--set offset_x=0.3 --set offset_y=0.2 --t-end %.17g%s%s",
                              (*m)->name, cells, (*e)->dim,
                              steps * BLOCK_CFL / (cells * BLOCK_SPEED), v ? " --set " : "",
                              v ? variants[v].name : "");
            }
}

static void write_one(FILE *f, const Files *files, const char *method, int dim, int variant)
{
    char part[96];
    part_name(part, method, dim, variant);
    Table *t = table_read_part(files->dir, name, part, NULL);
    for (int k = 0; t && k < SHOWN; k++)
        if (shown[k] < t->nrow)
            fprintf(f, "%s,%d,%s,%d,%.10g,%s\n", method, dim, variants[variant].name, shown[k],
                    sqrt(table_number(t, shown[k], "kinetic") / table_number(t, 0, "kinetic")),
                    file_status(files, part));
    table_free(t);
}

/* Extremes over methods ("mpm gimp") and dimensions first .. 2 of what is left at the end. */
typedef struct Left {
    Measure least, most;
} Left;

static Left left(const Table *t, const char *methods, int first, int variant)
{
    Left out = {least_of(0), largest_of(0)};
    char words[128], *rest = words;
    snprintf(words, sizeof words, "%s", methods);
    for (char *m; (m = strtok_r(rest, " ", &rest));)
        for (int dim = first; dim <= 2; dim++) {
            Curve c;
            curve_pick(&c, t, "step", "kept", "method=%s dim=%d variant=%s", m, dim,
                       variants[variant].name);
            const Measure end = with_value(curve_max(&c, SHOWN), c.n ? c.y[c.n - 1] : NAN);
            out.least = least(out.least, end);
            out.most = largest(out.most, end);
        }
    return out;
}

/* The most that is left at the end, or to which it had grown when the run was lost. */
static Measure last_left(const Table *t, const char *methods, int variant)
{
    Measure out = largest_of(0);
    char words[128], *rest = words;
    snprintf(words, sizeof words, "%s", methods);
    for (char *m; (m = strtok_r(rest, " ", &rest));)
        for (int dim = 1; dim <= 2; dim++) {
            Measure last = sum_of(1);
            for (int k = 0; k < SHOWN; k++) {
                const Measure at =
                    select_ended_value(t, "kept", "method=%s dim=%d variant=%s step=%d", m, dim,
                                       variants[variant].name, shown[k]);
                if (at.rows) last = at;
            }
            const Measure kept = select_value(t, "kept", "method=%s dim=%d variant=%s", m, dim,
                                              variants[variant].name);
            if (!kept.rows && !(last.value > 1.1)) last = measure(NAN, 0, 1);
            out = largest(out, last);
        }
    return out;
}

static Mark mark_kept(double part)
{
    return grade_mark_of(part, 0.1, 1.1);
}

static int write_grades(const char *dir, Fault *fault)
{
    Table *t = table_read_part(dir, name, "kept", fault);
    FILE *f = t ? grades_begin(dir, name, fault) : NULL;
    FILE *g = f ? grades_remedies_begin(dir, name, fault) : NULL;
    for (const Info *const *m = engine_2d.methods; g && *m; m++) {
        if (!has_grid(&engine_2d, (*m)->name)) continue;
        const double usual = last_left(t, (*m)->name, 0).value;
        grade_add(f, "H2", (*m)->name, mark_kept(usual),
                  usual > 1.1 ? "grows to %.3g times what it was in %d steps"
                              : "%.2g of it left after %d steps",
                  usual, STEPS);
        for (int v = 1; v < VARIANTS; v++)
            if (takes(&engine_2d, *m, v))
                grade_remedy_add(g, "H2", (*m)->name, variants[v].name, mark_kept(usual),
                                 mark_kept(last_left(t, (*m)->name, v).value));
    }
    table_free(t);
    const int code = grades_end(g, dir, name, "remedies", fault);
    return grades_end(f, dir, name, "grades", fault) ? FAULT_MACHINE : code;
}

static int tables(const char *dir, bool quick, Fault *fault)
{
    char path[PATH_TEXT];
    Files files;
    (void)quick;
    table_part_path(path, dir, name, "kept");
    FILE *f = file_begin(path, fault);
    if (!f) return FAULT_MACHINE;
    files_open(&files, dir, name);
    fputs("method,dim,variant,step,kept,status\n", f);
    for (const Engine *const *e = engines; *e; e++)
        for (const Info *const *m = (*e)->methods; *m; m++)
            for (int v = 0; v < VARIANTS; v++)
                if (takes(*e, *m, v)) write_one(f, &files, (*m)->name, (*e)->dim, v);
    files_close(&files);
    return file_commit(f, path, fault) ? FAULT_MACHINE : write_grades(dir, fault);
}

static void check(Check *c, const Table *rows, const char *dir)
{
    Table *t = claim_part(c, dir, "kept");
    (void)rows;
    claim(c, "H2.flip", "FLIP keeps what the grid cannot see: least left at the end, five methods",
          left(t, "mpm gimp ge_mpm ge_gimp bspline", 1, 0).least, 0.9, 1.1);
    claim(c, "H2.pic", "PIC (order 1 of XPIC and FMPM), APIC and TPIC forget it: most left",
          largest(left(t, "xpic fmpm", 1, 1).most, left(t, "apic tpic", 1, 0).most), 0, 0.1);
    claim(c, "H2.xpic", "XPIC(2) and FMPM(2) forget it, too: most left",
          left(t, "xpic fmpm", 1, 0).most, 0, 0.1);
    claim_differs(c, "H2.wls",
                  "WLS, WLS2 filter on the way to the grid only and keep it: most at the end",
                  last_left(t, "wls wls2", 0), 0.9, 1.1, 1.1, 1e6,
                  "it grows by itself where the block is off the grid's lines; less so, or not at "
                  "all, if returned through splines, as it was fitted");
    claim(c, "H2.wls-spline", "returned through splines, as fitted, WLS keeps it: most left",
          left(t, "wls", 1, 2).most, 0.9, 1.1);
    claim(c, "H2.wls2-spline",
          "WLS2 with return=spline, 2D: the mode still grows (range set from our own runs): most "
          "left",
          left(t, "wls2", 2, 2).most, 1.1, 100);
    claim(c, "H2.ge_wls", "GE-WLS keeps what the grid cannot see, 1D and 2D: most left",
          left(t, "ge_wls", 1, 0).most, 0.9, 1.1);
    table_free(t);
}

const Study study_h_02_ringing = {
    .name = name,
    .figure = "H2",
    .about = "particle velocities that the grid cannot see: who keeps them, who forgets",
    .cases = cases,
    .tables = tables,
    .check = check,
    .claims = 7,
};
