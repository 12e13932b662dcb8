/* hard.c: see hard.h. */
#include "hard.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

const char *const grade_names[GRADES] = {"ok", "weak", "lost"};

bool has_grid(const Engine *engine, const char *method)
{
    double S, G;
    return engine->weight(method, 0, 0.25, &S, &G) == 0;
}

FILE *grades_begin(const char *dir, const char *name, Fault *fault)
{
    char path[PATH_TEXT];
    part_path(path, dir, name, "grades");
    FILE *f = file_begin(path, fault);
    if (f) fputs("case,method,grade,note\n", f);
    return f;
}

int grades_end(FILE *f, const char *dir, const char *name, Fault *fault)
{
    char path[PATH_TEXT];
    part_path(path, dir, name, "grades");
    return f ? file_commit(f, path, fault) : FAULT_MACHINE;
}

void grade_add(FILE *f, const char *hard_case, const char *method, Grade grade, const char *note,
               ...)
{
    char text[256];
    va_list args;
    va_start(args, note);
    vsnprintf(text, sizeof text, note, args);
    va_end(args);
    fprintf(f, "%s,%s,%s,", hard_case, method, grade_names[grade]);
    csv_cell(f, text);
    putc('\n', f);
}

Grade grade_of(double value, double ok, double weak)
{
    return value <= ok ? GRADE_OK : value <= weak ? GRADE_WEAK : GRADE_LOST;
}

double worst_of(const Table *t, const char *methods, const char *want, const char *where)
{
    char words[256], text[256];
    double worst = -INFINITY;
    char *rest = words;
    snprintf(words, sizeof words, "%s", methods);
    for (char *m; (m = strtok_r(rest, " ", &rest));) {
        Curve c;
        snprintf(text, sizeof text, "method=%s %s", m, where);
        curve_pick(&c, t, want, want, "%s", text);
        const double most = curve_max(&c);
        if (!(most <= worst)) worst = most;
        if (isnan(most)) return NAN;
    }
    return worst;
}
