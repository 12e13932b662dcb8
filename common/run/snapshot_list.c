/* snapshot_list.c: see snapshot_list.h. */
#include "snapshot_list.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "common/base/table.h"
#include "common/base/vtk_file.h"

static const char *const stems[SHOT_KINDS] = {"particles", "nodes", "cells"};

void snapshot_free(Snapshots *s)
{
    for (int k = 0; k < SHOT_KINDS; k++) free(s->step[k]), free(s->t[k]);
    *s = (Snapshots){0};
}

static void list_path(const char *dir, int kind, char path[PATH_MAX])
{
    snprintf(path, PATH_MAX, "%.4000s/%s.pvd", dir, stems[kind]);
}

void snapshot_path(const Snapshots *s, int kind, long step, char path[PATH_MAX])
{
    snprintf(path, PATH_MAX, "%.4000s/%s_%06ld.vtp", s->dir, stems[kind], step);
}

int snapshot_check(const char *dir, Fault *fault)
{
    char path[PATH_MAX];
    list_path(dir, SHOT_PARTICLES, path);
    return file_check(path, fault);
}

bool snapshot_room(Snapshots *s, int kind)
{
    if (s->n[kind] < s->room[kind]) return true;
    const size_t room = s->room[kind] ? 2 * (size_t)s->room[kind] : 64;
    long *step = realloc(s->step[kind], room * sizeof *step);
    if (step) s->step[kind] = step;
    double *t = realloc(s->t[kind], room * sizeof *t);
    if (t) s->t[kind] = t;
    if (step && t) s->room[kind] = (int)room;
    return step && t;
}

int snapshot_list(Snapshots *s, int kind, bool last, Fault *fault)
{
    char path[PATH_MAX];
    if (!s->n[kind] || s->listed[kind] == s->n[kind]) return 0;
    if (!last && s->n[kind] < s->listed[kind] + s->listed[kind] / 10 + 1) return 0;
    list_path(s->dir, kind, path);
    s->listed[kind] = s->n[kind];
    return vtk_file_collect(path, stems[kind], s->n[kind], s->step[kind], s->t[kind], fault);
}

void snapshot_stash(Snapshots *s, Stash *stash)
{
    const int every = s->every;
    const double every_s = s->every_s;
    if (!stash_same_option(stash, s->dir != NULL, s->dir ? "no --vtk" : "--vtk") || !s->dir) return;
    STASH(stash, s->every);
    STASH(stash, s->every_s);
    if (s->every != every || s->every_s < every_s || s->every_s > every_s) {
        stash->bad = true;
        stash->why = "another --every";
        return;
    }
    STASH(stash, s->slot);
    for (int kind = 0; kind < SHOT_KINDS; kind++) {
        int n = s->n[kind];
        STASH(stash, n);
        for (s->n[kind] = 0; s->n[kind] < n && !stash->bad; s->n[kind]++) {
            stash->bad = !snapshot_room(s, kind);
            if (stash->bad) return;
            STASH(stash, s->step[kind][s->n[kind]]);
            STASH(stash, s->t[kind][s->n[kind]]);
        }
    }
}

/* Deletes the snapshots behind the last one here that the list on disk names: the instant at which
 * the run was stopped. The folder may hold those of other runs. */
static void delete_later(const Snapshots *s, int kind)
{
    char path[PATH_MAX], line[PATH_MAX], form[64];
    long step;
    list_path(s->dir, kind, path);
    snprintf(form, sizeof form, "<DataSet timestep=\"%%*[^\"]\" part=\"0\" file=\"%s_%%ld.vtp",
             stems[kind]);
    FILE *list = fopen(path, "r");
    while (list && fgets(line, sizeof line, list)) {
        if (sscanf(line, form, &step) != 1 || step <= s->step[kind][s->n[kind] - 1]) continue;
        snapshot_path(s, kind, step, path);
        unlink(path);
    }
    if (list) fclose(list);
}

int snapshot_go_on(Snapshots *s, Fault *fault)
{
    char path[PATH_MAX];
    int code = 0;
    for (int kind = 0; kind < SHOT_KINDS && s->dir; kind++)
        for (int k = 0; k < s->n[kind]; k++) {
            snapshot_path(s, kind, s->step[kind][k], path);
            if (access(path, R_OK) != 0)
                return fault_set(fault, FAULT_USAGE,
                                 "--vtk: got '%s', takes the folder that has the run's snapshots "
                                 "so far (%s_%06ld.vtp)",
                                 s->dir, stems[kind], s->step[kind][k]);
        }
    for (int kind = 0; kind < SHOT_KINDS && s->dir && !code; kind++) {
        if (!s->n[kind]) continue;
        delete_later(s, kind);
        code = snapshot_list(s, kind, true, fault);
    }
    return code;
}
