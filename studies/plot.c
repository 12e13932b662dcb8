/* plot.c: runs gnuplot, once a format, without a shell and not for ever; a figure appears whole. */
#define _GNU_SOURCE /* memfd_create */
#include "plot.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include "memory.h"

extern char **environ;

enum { SECONDS = 120, TICKS = 200 /* a second */ };

static const char *const formats[] = {"svg", "png"};
enum { FORMATS = 2 };

char *plots_folder(void)
{
    static const char *const places[] = {"../plots", "../../plots", "../share/mpmlab/plots"};
    char self[PATH_MAX], found[PATH_MAX];
    ssize_t n = readlink("/proc/self/exe", self, sizeof self - 1);
    if (n <= 0) return NULL;
    self[n] = '\0';
    *strrchr(self, '/') = '\0';
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        char *path = text_of("%s/%s", self, places[k]);
        int there = realpath(path, found) != NULL;
        free(path);
        if (there) return text_of("%s", found);
    }
    return NULL;
}

/* Text between single quotes for gnuplot: quotes inside are doubled. */
static char *quoted(const char *text)
{
    char *out = must(malloc(2 * strlen(text) + 3)), *o = out;
    *o++ = '\'';
    for (; *text; text++) {
        if (*text == '\'') *o++ = '\'';
        *o++ = *text;
    }
    strcpy(o, "'");
    return out;
}

/* "fmt='svg'; out='...'; ..." */
static char *settings(const char *const values[][2], int n)
{
    char *all = text_of("%s", "");
    for (int k = 0; k < n; k++) {
        char *value = quoted(values[k][1]),
             *longer = text_of("%s%s=%s; ", all, values[k][0], value);
        free(value);
        free(all);
        all = longer;
    }
    return all;
}

/* Starts gnuplot with its messages going to log. 0, or an errno (ENOENT: there is none). */
static int start(const char *set, const char *script, int log, pid_t *pid)
{
    char *const argv[] = {"gnuplot", "-e", (char *)set, (char *)script, NULL};
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, log, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, log, STDERR_FILENO);
    int error = posix_spawnp(pid, "gnuplot", &actions, &attributes, argv, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

/* The status of a process that ends in time, or -1: it was killed. */
static int wait_for(pid_t pid)
{
    const struct timespec tick = {.tv_nsec = 1000000000 / TICKS};
    int status;
    for (int k = 0; k < SECONDS * TICKS; k++) {
        pid_t got = waitpid(pid, &status, WNOHANG);
        if (got == pid) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        if (got < 0 && errno != EINTR) return -1;
        nanosleep(&tick, NULL);
    }
    kill(pid, SIGKILL);
    waitpid(pid, &status, 0);
    return -1;
}

/* The last line that gnuplot wrote: what went wrong. */
static void last_line(int log, char line[256])
{
    char text[4096];
    ssize_t n = pread(log, text, sizeof text - 1, 0);
    text[n > 0 ? n : 0] = '\0';
    while (n > 0 && strchr(" \t\r\n", text[n - 1])) text[--n] = '\0';
    const char *last = strrchr(text, '\n');
    snprintf(line, 256, "%.255s", last ? last + 1 + strspn(last + 1, " \t") : text);
}

static int draw(const char *set, const char *script, const char *part, const char *whole,
                Fault *fault)
{
    pid_t pid;
    struct stat s;
    char line[256];
    int log = memfd_create("gnuplot", MFD_CLOEXEC), error = start(set, script, log, &pid);
    int status = error ? -1 : wait_for(pid);
    last_line(log, line);
    close(log);
    if (error == ENOENT) return PLOT_NO_GNUPLOT;
    if (status == 0 && stat(part, &s) == 0 && s.st_size > 0) {
        if (rename(part, whole) == 0) return 0;
        snprintf(line, sizeof line, "%s", strerror(errno));
    }
    unlink(part);
    return fault_set(fault, FAULT_MACHINE, "%.200s: %s", script,
                     line[0] ? line : "gnuplot drew nothing");
}

static const char *script_name(const Study *study)
{
    return study->script ? study->script : study->name;
}

static int draw_format(const Study *study, const char *dir, const char *plots, const char *format,
                       Fault *fault)
{
    char *script = text_of("%s/%s.gp", plots, script_name(study));
    char *csv = text_of("%s/%s.csv", dir, study->name);
    char *whole = text_of("%s/%s.%s", dir, study->name, format);
    char *part = text_of("%s.tmp", whole);
    const char *const values[][2] = {{"fmt", format},       {"out", part}, {"dir", dir},
                                     {"name", study->name}, {"csv", csv},  {"plots", plots}};
    char *set = settings(values, 6);
    int code = draw(set, script, part, whole, fault);
    free(set);
    free(part);
    free(whole);
    free(csv);
    free(script);
    return code;
}

static double seconds(struct timespec t)
{
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Modification time of dir/name+ending [s], or -1 if there is no such file. */
static double age(const char *dir, const char *name, const char *ending)
{
    struct stat s;
    char *path = text_of("%s/%s%s", dir, name, ending);
    int there = stat(path, &s) == 0;
    free(path);
    return there ? seconds(s.st_mtim) : -1;
}

/* Is this file one that the study's figure is drawn from: NAME.var, NAME.csv, NAME.more.csv? */
static bool is_input(const char *file, const char *name)
{
    size_t n = strlen(name);
    const char *ending = strrchr(file, '.');
    return strncmp(file, name, n) == 0 && ending &&
           (strcmp(ending, ".csv") == 0 || strcmp(ending, ".var") == 0);
}

/* When the youngest of them was written [s]. */
static double newest_input(const char *dir, const char *name)
{
    double newest = 0;
    DIR *d = opendir(dir);
    for (struct dirent *e; d && (e = readdir(d));)
        if (is_input(e->d_name, name)) newest = fmax(newest, age(dir, e->d_name, ""));
    if (d) closedir(d);
    return newest;
}

static bool is_fresh(const Study *study, const char *dir, const char *plots)
{
    double inputs = fmax(age(plots, script_name(study), ".gp"), age(plots, "style", ".gp"));
    inputs = fmax(inputs, newest_input(dir, study->name));
    return age(dir, study->name, ".svg") > inputs && age(dir, study->name, ".png") > inputs;
}

int plot_study(const Study *study, const char *dir, Fault *fault)
{
    char *plots = plots_folder(), folder[PATH_MAX];
    int code = 0;
    if (plots && age(plots, script_name(study), ".gp") > 0 && realpath(dir, folder) &&
        !is_fresh(study, folder, plots))
        for (int k = 0; k < FORMATS && code == 0; k++)
            code = draw_format(study, folder, plots, formats[k], fault);
    free(plots);
    return code;
}
