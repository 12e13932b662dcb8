/* plot.c: which figures are to be drawn, once a format; a figure appears whole. */
#include "plot.h"

#include <dirent.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#include "gnuplot.h"
#include "palette.h"
#include "studies/runs/must.h"

/* A figure is drawn as svg and png by NAME.gp; a moving picture by NAME.gif.gp, if there is one. */
static const struct {
    const char *name, *script;
    int always;
} formats[] = {{"svg", ".gp", 1}, {"png", ".gp", 1}, {"gif", ".gif.gp", 0}};
enum { FORMATS = 3 };

char *plot_folder(void)
{
    static const char *const places[] = {"plots", "share/mpmlab/plots"};
    char above[PATH_MAX];
    ssize_t n = readlink("/proc/self/exe", above, sizeof above - 1);
    if (n <= 0) return NULL;
    above[n] = '\0';
    for (char *end; (end = strrchr(above, '/'));) {
        *end = '\0';
        for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
            char *path = must_text("%s/%s", above, places[k]),
                 *style = must_text("%s/style.gp", path);
            const bool there = access(style, R_OK) == 0;
            free(style);
            if (there) return path;
            free(path);
        }
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
    char *all = must_text("%s", "");
    for (int k = 0; k < n; k++) {
        char *value = quoted(values[k][1]),
             *longer = must_text("%s%s=%s; ", all, values[k][0], value);
        free(value);
        free(all);
        all = longer;
    }
    return all;
}

/* A new drawing is stamped as such even if it is the old one, or it would be drawn again. */
static int draw(const char *set, const char *script, FILE *f, const char *whole, Fault *fault)
{
    struct stat s;
    int code = gnuplot_run(set, script, fileno(f), fault);
    if (code == 0 && (fstat(fileno(f), &s) != 0 || s.st_size == 0))
        code = fault_set(fault, FAULT_MACHINE, "%.200s: gnuplot drew nothing", script);
    if (code) {
        file_abandon(f, whole);
        return code;
    }
    code = file_commit(f, whole, fault);
    if (code == 0) utimensat(AT_FDCWD, whole, NULL, 0);
    return code;
}

/* "ROOM/NAME" of the script, without its ending. To be freed. */
static char *script_name(const Study *study)
{
    return must_text("%s/%s", study_room(study), study->script ? study->script : study->name);
}

static int draw_format(const Study *study, const char *dir, const char *plots, int k, Fault *fault)
{
    const char *format = formats[k].name;
    char *own = script_name(study), *script = must_text("%s/%s%s", plots, own, formats[k].script);
    char *csv = must_text("%s/%s.csv", dir, study->name);
    char *whole = must_text("%s/%s.%s", dir, study->name, format);
    FILE *f = file_begin(whole, fault);
    char *out = must_text("/proc/self/fd/%d", f ? fileno(f) : -1);
    const char *const values[][2] = {{"fmt", format},       {"out", out}, {"dir", dir},
                                     {"name", study->name}, {"csv", csv}, {"plots", plots}};
    char *own_set = settings(values, 6), *palette = palette_settings();
    char *set = must_text("%s%s", palette, own_set);
    free(own_set);
    free(palette);
    int code = f ? draw(set, script, f, whole, fault) : FAULT_MACHINE;
    free(set);
    free(out);
    free(whole);
    free(csv);
    free(script);
    free(own);
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
    char *path = must_text("%s/%s%s", dir, name, ending);
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

/* Must this format be drawn? */
static bool is_due(const Study *study, const char *dir, const char *plots, int k)
{
    char *own = script_name(study);
    const double script = age(plots, own, formats[k].script);
    free(own);
    const double inputs =
        fmax(fmax(script, age(plots, "style", ".gp")), newest_input(dir, study->name));
    char *ending = must_text(".%s", formats[k].name);
    const bool fresh = age(dir, study->name, ending) > inputs;
    free(ending);
    return (script > 0 || formats[k].always) && !fresh;
}

int plot_study(const Study *study, const char *dir, Fault *fault)
{
    char *plots = plot_folder(), *script = script_name(study), folder[PATH_MAX];
    int code = 0;
    if (!plots)
        code = fault_set(fault, FAULT_MACHINE,
                         "no folder plots with style.gp above the program: %s is not drawn",
                         study->name);
    else if (age(plots, script, ".gp") > 0 && realpath(dir, folder))
        for (int k = 0; k < FORMATS && code == 0; k++)
            if (is_due(study, folder, plots, k)) code = draw_format(study, folder, plots, k, fault);
    free(script);
    free(plots);
    return code;
}
