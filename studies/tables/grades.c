/* grades.c: see grades.h. */
#include "grades.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>
#include "studies/runs/run_args.h"

const char *const grade_mark_names[MARKS] = {"ok", "weak", "lost"};

bool has_grid(const Engine *engine, const char *method)
{
    double S, G;
    return engine->weight(method, 0, 0.25, &S, &G) == 0;
}

bool is_run(const char *format, ...)
{
    char text[SPEC_TEXT];
    const Engine *engine;
    RunSpec spec;
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return run_args_resolve(text, &spec, &engine, NULL) == 0;
}

bool has_param(const Info *method, const char *name)
{
    for (const Param *p = method->params; p && p->name; p++)
        if (strcmp(p->name, name) == 0) return true;
    return false;
}

static FILE *begin(const char *dir, const char *name, const char *part, const char *header,
                   Fault *fault)
{
    char path[PATH_TEXT];
    table_part_path(path, dir, name, part);
    FILE *f = file_begin(path, fault);
    if (f) fputs(header, f);
    return f;
}

FILE *grades_begin(const char *dir, const char *name, Fault *fault)
{
    return begin(dir, name, "grades", "case,method,grade,note\n", fault);
}

FILE *grades_remedies_begin(const char *dir, const char *name, Fault *fault)
{
    return begin(dir, name, "remedies", "case,method,remedy,before,after\n", fault);
}

int grades_end(FILE *f, const char *dir, const char *name, const char *part, Fault *fault)
{
    char path[PATH_TEXT];
    table_part_path(path, dir, name, part);
    return f ? file_commit(f, path, fault) : FAULT_MACHINE;
}

int grades_tables(const char *dir, const char *name, const char *part,
                  void (*points)(FILE *f, const Table *rows),
                  void (*marks)(FILE *f, const Table *points), Fault *fault)
{
    char path[PATH_TEXT];
    table_part_path(path, dir, name, part);
    Table *rows = table_read_part(dir, name, NULL, fault);
    FILE *f = rows ? file_begin(path, fault) : NULL;
    if (f) points(f, rows);
    table_free(rows);
    if (!f || file_commit(f, path, fault)) return FAULT_MACHINE;
    Table *t = table_read_part(dir, name, part, fault);
    FILE *g = t ? grades_begin(dir, name, fault) : NULL;
    if (g) marks(g, t);
    table_free(t);
    return grades_end(g, dir, name, "grades", fault);
}

void grade_remedy_add(FILE *f, const char *hard_case, const char *method, const char *remedy,
                      Mark before, Mark after)
{
    fprintf(f, "%s,%s,%s,%s,%s\n", hard_case, method, remedy, grade_mark_names[before],
            grade_mark_names[after]);
}

void grade_add(FILE *f, const char *hard_case, const char *method, Mark grade, const char *note,
               ...)
{
    char text[256];
    va_list args;
    va_start(args, note);
    vsnprintf(text, sizeof text, note, args);
    va_end(args);
    fprintf(f, "%s,%s,%s,", hard_case, method, grade_mark_names[grade]);
    table_put_cell(f, text);
    putc('\n', f);
}

Mark grade_mark_of(double value, double ok, double weak)
{
    return value <= ok ? MARK_OK : value <= weak ? MARK_WEAK : MARK_LOST;
}

Measure curve_worst(const Table *t, const char *methods, int each, const char *want,
                    const char *where)
{
    char words[256];
    Measure worst = {0};
    char *rest = words;
    snprintf(words, sizeof words, "%s", methods);
    for (char *m; (m = strtok_r(rest, " ", &rest));) {
        Curve c;
        curve_pick(&c, t, want, want, "method=%s %s", m, where);
        const Measure most = c.n ? curve_max(&c, each) : measure(NAN, 0, each);
        worst = worst.needs ? largest(worst, most) : most;
    }
    return worst;
}
