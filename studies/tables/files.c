/* files.c: see files.h. */
#include "files.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "studies/runs/memory.h"

static const Study *find(const char *name)
{
    const Study *const *s = studies;
    while (*s && strcmp((*s)->name, name) != 0) s++;
    return *s;
}

/* Is every setting of the case in the row's params, as they are spelled there? */
static bool has_settings(const char *params, const RunSpec *spec)
{
    for (int k = 0; k < spec->nset; k++) {
        char text[80];
        const int n = snprintf(text, sizeof text, "%s=%s", spec->set[k].name, spec->set[k].value);
        if (strcmp(spec->set[k].name, "layout") == 0) continue;
        if (strncmp(params, text, (size_t)n) != 0 || (params[n] && params[n] != ';')) return false;
        params += n + (params[n] == ';');
    }
    return !*params;
}

static bool is_near(double a, double b)
{
    return fabs(a - b) <= 1e-9 * fabs(b);
}

/* Body-fitted particles are not quite as many as asked for. */
static bool is_row_of(const Table *rows, int row, const Case *c)
{
    const double ppc = table_number(rows, row, "ppc"), t_end = table_number(rows, row, "t_end");
    return strcmp(table_text(rows, row, "problem"), c->spec.problem) == 0 &&
           strcmp(table_text(rows, row, "method"), c->spec.method) == 0 &&
           is_near(table_number(rows, row, "cells"), c->spec.cells) &&
           (c->engine->dim > 1 || is_near(ppc, c->spec.ppc)) &&
           (t_end <= 0 || is_near(t_end, c->spec.t_end)) &&
           has_settings(table_text(rows, row, "params"), &c->spec);
}

/* Rows stand in the order of cases, those of methods that were not asked for left out. Returns how
 * many rows found their case. */
static int match(Files *f)
{
    int row = 0;
    f->row = must(malloc(sizeof *f->row * ((size_t)f->cases.n + 1)));
    for (int k = 0; k < f->cases.n; k++) {
        const bool found =
            f->rows && row < f->rows->nrow && is_row_of(f->rows, row, &f->cases.list[k]);
        f->row[k] = found ? row++ : -1;
    }
    return row;
}

void files_open(Files *f, const char *dir, const char *name)
{
    const Study *study = find(name);
    *f = (Files){.dir = dir, .name = name, .rows = table_read_part(dir, name, NULL, NULL)};
    for (int quick = 0; study && quick < 2; quick++) {
        cases_build(&f->cases, study, quick, NULL, dir, NULL);
        const int matched = match(f);
        if (quick || !f->rows || matched >= f->rows->nrow || study->refine) return;
        cases_free(&f->cases);
        free(f->row);
    }
}

void files_close(Files *f)
{
    cases_free(&f->cases);
    table_free(f->rows);
    free(f->row);
}

static const char *path_status(const Files *f, const char *path)
{
    const char *status = "absent";
    for (int k = 0; k < f->cases.n; k++) {
        const char *file = f->cases.list[k].file;
        if (!file || strcmp(file, path) != 0) continue;
        if (f->row[k] < 0) return "absent";
        if (select_is_lost(f->rows, f->row[k])) return "lost";
        status = "ok";
    }
    return status;
}

bool path_kept(const Files *f, const char *path)
{
    return strcmp(path_status(f, path), "ok") == 0;
}

bool file_path(const Files *f, const char *part, char path[PATH_TEXT])
{
    table_part_path(path, f->dir, f->name, part);
    return path_kept(f, path);
}

bool file_kept(const Files *f, const char *part)
{
    char path[PATH_TEXT];
    return file_path(f, part, path);
}

const char *file_status(const Files *f, const char *part)
{
    char path[PATH_TEXT];
    table_part_path(path, f->dir, f->name, part);
    return path_status(f, path);
}

Table *file_read(const Files *f, const char *part)
{
    return file_kept(f, part) ? table_read_part(f->dir, f->name, part, NULL) : NULL;
}
