/* trial.c: see trial.h. */
#include "trial.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "tests/check.h"
#include "trial_case.h"

static void say_settings(const Case *c, Row *row)
{
    size_t at = 0;
    const char *layout = spec_get(&c->spec, "layout");
    snprintf(row->layout, sizeof row->layout, "%s",
             layout                                        ? layout
             : strstr(c->spec.method, "wls") && !is_fem(c) ? "radial"
                                                           : "cartesian");
    for (int k = 0; k < c->spec.nset; k++)
        if (strcmp(c->spec.set[k].name, "layout") != 0)
            at += (size_t)snprintf(row->params + at, sizeof row->params - at, "%s%s=%s",
                                   at ? ";" : "", c->spec.set[k].name, c->spec.set[k].value);
}

/* What all numbers of row k are multiplied by. */
static double factor_of(Spoiled how, int k)
{
    switch (how) {
    case LARGER:
        return 1e3;
    case SMALLER:
        return 1e-3;
    case UNEVEN:
        return pow(10, 6 * spread(7 * k + 3) - 3);
    case UNEVEN_TOO:
        return pow(10, 3 - 6 * spread(7 * k + 3));
    default:
        return 1;
    }
}

static void say_results(const Case *c, int k, Spoiled how, Row *row)
{
    const double n = row->cells, factor = factor_of(how, k);
    snprintf(row->status, sizeof row->status, how == LOST_RUN ? "inverted" : "ok");
    if (how == LOST_RUN) return;
    row->steps = 100;
    row->dt = row->t_end / 100;
    row->error_linf = factor * 0.3 *
                      (1 + 0.1 * spread((int)strlen(row->method) + (int)(n + 100 * c->spec.ppc))) /
                      (n * n);
    row->error_l2 = 0.5 * row->error_linf;
    row->error_l1 = 0.3 * row->error_linf;
    row->energy_drift = -factor * 1e-3 * (1 + spread(k));
    row->momentum_drift = factor * 1e-14;
    row->fallbacks = factor * 3;
    row->elements = is_fem(c) ? n * n : NAN;
    row->cpu_s = row->wall_s = factor * 1e-6 * n * n * (1 + 0.1 * spread(k + 1));
}

static Row row_of(const Case *c, int k, Spoiled how)
{
    Row row = row_empty();
    const RunSpec *s = &c->spec;
    snprintf(row.problem, sizeof row.problem, "%s", s->problem);
    snprintf(row.method, sizeof row.method, "%s", s->method);
    snprintf(row.integrator, sizeof row.integrator, "%s", s->integrator);
    row.cells = s->cells;
    row.h = 1 / s->cells;
    row.ppc = is_fem(c) ? NAN : s->ppc;
    row.cfl = s->cfl > 0 ? s->cfl : NAN;
    row.particles = round(s->ppc * s->cells);
    row.t_end = s->t_end;
    say_settings(c, &row);
    say_results(c, k, how, &row);
    return row;
}

static void print_row(FILE *f, const Case *c, int k, Spoiled how)
{
    char text[ROW_TEXT];
    const Row row = row_of(c, k, how);
    row_print(&row, text);
    if (how != ABSENT) fprintf(f, "%s\n", text);
}

char *trial_text(const Cases *cases, Spoiled how)
{
    char header[ROW_TEXT], *text = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&text, &size);
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    row_header(header);
    fprintf(f, "%s\n", header);
    for (int k = 0; k < cases->n; k++) print_row(f, &cases->list[k], k, how);
    fclose(f);
    return text;
}

static FILE *open_table(const Study *study, const char *dir)
{
    char path[TRIAL_PATH];
    snprintf(path, sizeof path, "%s/%s.csv", dir, study->name);
    FILE *f = fopen(path, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    return f;
}

void trial_rows(const Study *study, const Cases *cases, const char *dir, Spoiled how)
{
    FILE *f = open_table(study, dir);
    char *text = trial_text(cases, how);
    fputs(text, f);
    fclose(f), free(text);
}

void trial_one_row(const Study *study, const Cases *cases, const char *sound, const char *dir,
                   int row, Spoiled how)
{
    FILE *f = open_table(study, dir);
    const char *from = strchr(sound, '\n') + 1;
    for (int k = 0; k < row; k++) from = strchr(from, '\n') + 1;
    fwrite(sound, 1, (size_t)(from - sound), f);
    print_row(f, &cases->list[row], row, how);
    fputs(strchr(from, '\n') + 1, f);
    fclose(f);
}

/* ---- spoiled folders */

static void each_file(const char *dir, void (*act)(const char *path))
{
    char path[TRIAL_PATH];
    DIR *d = opendir(dir);
    for (struct dirent *e; d && (e = readdir(d));) {
        if (e->d_name[0] == '.') continue;
        snprintf(path, sizeof path, "%s/%.200s", dir, e->d_name);
        act(path);
    }
    if (d) closedir(d);
}

static void keep_header(const char *path)
{
    char line[ROW_TEXT] = "";
    FILE *f = fopen(path, "r");
    if (f && !fgets(line, sizeof line, f)) line[0] = '\0';
    if (f) fclose(f);
    CU_ASSERT(truncate(path, (off_t)strlen(line)) == 0);
}

static void remove_file(const char *path)
{
    unlink(path);
}

void trial_empty(const char *dir)
{
    each_file(dir, keep_header);
}

void trial_clear(const char *dir)
{
    each_file(dir, remove_file);
}

bool trial_is_one(const char *name, const char *const list[])
{
    for (; *list; list++) {
        const size_t n = strlen(*list);
        if (strncmp(name, *list, n) == 0 && ((*list)[n - 1] == '.' || !name[n])) return true;
    }
    return false;
}
