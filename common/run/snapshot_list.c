/* snapshot_list.c: see snapshot_list.h. */
#include "snapshot_list.h"
#include <dirent.h>
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
    const char *const other = s->dir ? "no --vtk" : "--vtk";
    if (!stash_same_option(stash, s->dir != NULL, other) || !s->dir) return;
    long every_s; /* its bits */
    memcpy(&every_s, &s->every_s, sizeof every_s);
    if (!stash_same_option(stash, s->every, "another --every") ||
        !stash_same_option(stash, every_s, "another --every"))
        return;
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

/* Deletes the snapshots behind the last one of the list. */
static void delete_later(const Snapshots *s, int kind)
{
    const size_t n = strlen(stems[kind]);
    const long last = s->n[kind] ? s->step[kind][s->n[kind] - 1] : -1;
    char path[PATH_MAX];
    DIR *d = opendir(s->dir);
    for (struct dirent *e; d && (e = readdir(d));) {
        long step = -1;
        if (strncmp(e->d_name, stems[kind], n) != 0) continue;
        if (sscanf(e->d_name + n, "_%ld.vtp", &step) != 1 || step <= last) continue;
        snapshot_path(s, kind, step, path);
        unlink(path);
    }
    if (d) closedir(d);
}

int snapshot_go_on(Snapshots *s, Fault *fault)
{
    char path[PATH_MAX];
    for (int kind = 0; kind < SHOT_KINDS && s->dir; kind++) {
        for (int k = 0; k < s->n[kind]; k++) {
            snapshot_path(s, kind, s->step[kind][k], path);
            if (access(path, R_OK) != 0)
                return fault_set(fault, FAULT_USAGE,
                                 "--vtk: got '%s', takes the folder that has the run's snapshots "
                                 "so far (%s_%06ld.vtp)",
                                 s->dir, stems[kind], s->step[kind][k]);
        }
        if (snapshot_list(s, kind, true, fault)) return FAULT_MACHINE;
        delete_later(s, kind);
    }
    return 0;
}
