/* run_files.c: see run_files.h. */
#include "run_files.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "common/base/table.h"
#include "must.h"

static const struct File {
    const char *option;
    size_t at;
} files[] = {
    {"history", offsetof(RunArgs, spec.history)},
    {"particles", offsetof(RunArgs, spec.particles)},
    {"nodes", offsetof(RunArgs, spec.nodes)},
    {"samples", offsetof(RunArgs, spec.samples)},
    {"errors", offsetof(RunArgs, spec.errors)},
    {"patches", offsetof(RunArgs, spec.patches)},
    {"vtk", offsetof(RunArgs, spec.vtk)},
    {"checkpoint", offsetof(RunArgs, spec.checkpoint)},
    {"csv", offsetof(RunArgs, csv)},
};

/* Do both paths name one file, there or not yet? Devices may serve several options. */
static bool is_same_file(const char *path_a, const char *path_b)
{
    struct stat s, t;
    char a[PATH_MAX], b[PATH_MAX];
    file_target(path_a, a);
    file_target(path_b, b);
    if (strcmp(a, b) == 0) return true;
    if (stat(a, &s) == 0)
        return S_ISREG(s.st_mode) && stat(b, &t) == 0 && s.st_dev == t.st_dev &&
               s.st_ino == t.st_ino;
    const char *base_a = strrchr(a, '/'), *base_b = strrchr(b, '/');
    if (strcmp(base_a ? base_a + 1 : a, base_b ? base_b + 1 : b) != 0) return false;
    char *dir_a = must_text("%.*s.", base_a ? (int)(base_a - a) + 1 : 0, a);
    char *dir_b = must_text("%.*s.", base_b ? (int)(base_b - b) + 1 : 0, b);
    const bool same = stat(dir_a, &s) == 0 && stat(dir_b, &t) == 0 && s.st_dev == t.st_dev &&
                      s.st_ino == t.st_ino;
    free(dir_a);
    free(dir_b);
    return same;
}

int run_files_take(RunArgs *args, const char *option, const char *got, Fault *fault)
{
    const struct File *f = files, *const end = files + sizeof files / sizeof *files;
    while (f < end && strcmp(f->option, option) != 0) f++;
    if (f == end) return -1;
    if (!*got) return fault_set(fault, FAULT_USAGE, "--%s: got '', takes a path", f->option);
    for (const struct File *o = files; o < end; o++) {
        const char *taken = *(const char **)((char *)args + o->at);
        if (taken && o != f && is_same_file(taken, got))
            return fault_set(fault, FAULT_USAGE, "--%s: got '%.80s', takes another path than --%s",
                             f->option, got, o->option);
    }
    *(const char **)((char *)args + f->at) = got;
    return 0;
}

/* Is `path` that of a snapshot or of a list of them, in this folder? */
static bool is_snapshot(const char *path, const char *folder)
{
    char target[PATH_MAX];
    file_target(path, target);
    const char *slash = strrchr(target, '/'), *name = slash ? slash + 1 : target;
    const char *ending = strrchr(name, '.');
    if (!ending || (strcmp(ending, ".vtp") != 0 && strcmp(ending, ".pvd") != 0)) return false;
    char *beside = must_text("%s/%s", folder, name);
    const bool same = is_same_file(beside, target);
    free(beside);
    return same;
}

/* Is it the other name of a state, FILE.1? (A run that was killed may leave one file with both
 * names.) */
static bool is_state_before(const char *path, const char *state)
{
    char target[PATH_MAX];
    file_target(state, target);
    char *before = must_text("%s.1", target);
    const bool same = is_same_file(before, path);
    free(before);
    return same;
}

int run_files_check(const RunArgs *args, Fault *fault)
{
    const RunSpec *s = &args->spec;
    for (const struct File *f = files; f < files + sizeof files / sizeof *files; f++) {
        const char *path = *(const char *const *)((const char *)args + f->at), *wrong = NULL;
        if (!path || path == s->checkpoint) continue;
        if (s->vtk && path != s->vtk && is_snapshot(path, s->vtk)) wrong = "a snapshot of --vtk";
        if (s->checkpoint && is_state_before(path, s->checkpoint)) wrong = "FILE.1 of --checkpoint";
        if (s->resume && (is_same_file(path, s->resume) || is_state_before(path, s->resume)))
            wrong = "the state of --resume";
        if (wrong)
            return fault_set(fault, FAULT_USAGE, "--%s: got '%.80s', takes another path than %s",
                             f->option, path, wrong);
    }
    return 0;
}
