/* plot.c: which figures must be drawn, once per format; a figure appears whole or not at all. */
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
#include "studies/phrase.h"
#include "studies/runs/must.h"

/* A figure is drawn as svg and png by NAME.gp, and once more in fewer pixels for the page of claims
 * if its svg has many bytes; a moving picture by NAME.gif.gp, if there is one. */
static const struct {
    const char *name, *script;
    bool always;
    long svg_bytes; /* of a drawing, from which on it is due */
} formats[] = {{"svg", ".gp", true, 0},
               {"png", ".gp", true, 0},
               {"page.png", ".gp", false, 200000},
               {"gif", ".gif.gp", false, 0}};
enum { FORMATS = 4 };

const char *plot_folder(void)
{
    static const char *const places[] = {"plots", "share/mpmlab/plots"};
    char above[PATH_MAX];
    ssize_t n = readlink("/proc/self/exe", above, sizeof above - 1);
    if (n <= 0) return NULL;
    above[n] = '\0';
    for (char *end; (end = strrchr(above, '/'));) {
        *end = '\0';
        for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
            const char *path = phrase("%s/%s", above, places[k]);
            if (access(phrase("%s/style.gp", path), R_OK) == 0) return path;
        }
    }
    return NULL;
}

/* "name='text'; " for gnuplot: quotes inside are doubled. */
static void put_setting(FILE *f, const char *name, const char *text)
{
    fprintf(f, "%s='", name);
    for (; *text; text++) fputs(*text == '\'' ? "''" : (char[]){*text, '\0'}, f);
    fputs("'; ", f);
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

/* "ROOM/NAME" of the script, without its ending. */
static const char *script_name(const Study *study)
{
    return phrase("%s/%s", study->room ? study->room : ".",
                  study->script ? study->script : study->name);
}

static int draw_format(const Study *study, const char *dir, const char *plots, int k, Fault *fault)
{
    const char *format = formats[k].name;
    const char *whole = phrase("%s/%s.%s", dir, study->name, format);
    const char *script = phrase("%s/%s%s", plots, script_name(study), formats[k].script);
    char *set;
    size_t size;
    FILE *f = file_begin(whole, fault), *settings = must(open_memstream(&set, &size));
    palette_put(settings);
    put_setting(settings, "fmt", format);
    put_setting(settings, "out", phrase("/proc/self/fd/%d", f ? fileno(f) : -1));
    put_setting(settings, "dir", dir);
    put_setting(settings, "name", study->name);
    put_setting(settings, "csv", phrase("%s/%s.csv", dir, study->name));
    put_setting(settings, "plots", plots);
    fclose(settings);
    const int code = f ? draw(must(set), script, f, whole, fault) : FAULT_MACHINE;
    free(set);
    return code;
}

/* Modification time of dir/name+ending [s], or -1 if there is no such file. */
static double age(const char *dir, const char *name, const char *ending)
{
    struct stat s;
    const char *path = phrase("%s/%s%s", dir, name, ending);
    if (stat(path, &s) != 0) return -1;
    return (double)s.st_mtim.tv_sec + 1e-9 * (double)s.st_mtim.tv_nsec;
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
    const double script = age(plots, script_name(study), formats[k].script);
    const double inputs =
        fmax(fmax(script, age(plots, "style", ".gp")), newest_input(dir, study->name));
    const bool fresh = age(dir, study->name, phrase(".%s", formats[k].name)) > inputs;
    struct stat svg;
    const bool small = formats[k].svg_bytes &&
                       stat(phrase("%s/%s.svg", dir, study->name), &svg) == 0 &&
                       svg.st_size < formats[k].svg_bytes;
    return (script > 0 || formats[k].always) && !fresh && !small;
}

int plot_study(const Study *study, const char *dir, Fault *fault)
{
    const char *plots = plot_folder();
    char folder[PATH_MAX];
    int code = 0;
    if (!plots)
        code = fault_set(fault, FAULT_MACHINE,
                         "no folder plots with style.gp above the program: %s is not drawn",
                         study->name);
    else if (age(plots, script_name(study), ".gp") > 0 && realpath(dir, folder))
        for (int k = 0; k < FORMATS && code == 0; k++)
            if (is_due(study, folder, plots, k)) code = draw_format(study, folder, plots, k, fault);
    return code;
}
