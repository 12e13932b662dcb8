/* sidecar.c: the table of a study with its timings last, and its papers: NAME.json (jansson). */
#include "sidecar.h"

#include <dirent.h>
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>
#include "facts.h"
#include "studies/phrase.h"
#include "studies/runs/must.h"

/* Prints the cells of one row (a line without quotes), those of one sort: timing or not. */
static void print_cells(FILE *f, const char *line, int timing)
{
    for (int k = 0; k < row_columns(); k++) {
        int n = (int)strcspn(line, ",");
        if (row_column_is_timing(k) == timing) fprintf(f, "%s%.*s", k ? "," : "", n, line);
        line += n + (line[n] == ',');
    }
}

static void print_line(FILE *f, const char *line)
{
    print_cells(f, line, 0); /* the first column is no timing, so commas come out right */
    print_cells(f, line, 1);
    putc('\n', f);
}

int sidecar_write_rows(const Cases *cases, const Journal *journal, const char *path, Fault *fault)
{
    char header[ROW_TEXT];
    FILE *f = file_begin(path, fault);
    if (!f) return FAULT_MACHINE;
    row_header(header);
    print_line(f, header);
    for (int k = 0; k < cases->n; k++) {
        const char *row = journal_row(journal, cases->list[k].key);
        if (!row) { /* only if the disk did not keep what was written to it */
            file_abandon(f, path);
            return fault_set(fault, FAULT_MACHINE, "%s: the journal lost a row", path);
        }
        print_line(f, row);
    }
    return file_commit(f, path, fault);
}

typedef struct Digest {
    unsigned long sum; /* crc32 of every cell that is no timing */
    double seconds, dt_min, dt_max;
} Digest;

static bool is_timing(const char *column)
{
    for (int k = 0; k < row_columns(); k++)
        if (strcmp(row_column_name(k), column) == 0) return row_column_is_timing(k) != 0;
    return false;
}

static void add_row(Digest *d, char *const *cells, const Table *t)
{
    for (int k = 0; k < t->ncol; k++)
        if (!is_timing(t->name[k]))
            d->sum = crc32(d->sum, (const unsigned char *)cells[k], (unsigned)strlen(cells[k]) + 1);
}

static Digest digest(const Table *t)
{
    Digest d = {.dt_min = NAN, .dt_max = NAN};
    add_row(&d, t->name, t);
    for (int k = 0; k < t->nrow; k++) {
        double seconds = table_number(t, k, "wall_s"), dt = table_number(t, k, "dt");
        add_row(&d, t->cell + k * t->ncol, t);
        if (isfinite(seconds)) d.seconds += seconds;
        d.dt_min = fmin(d.dt_min, dt); /* fmin and fmax pass over NAN */
        d.dt_max = fmax(d.dt_max, dt);
    }
    return d;
}

static json_t *number(double x)
{
    return isfinite(x) ? json_real(x) : json_null();
}

static json_t *hex(unsigned long sum)
{
    return json_sprintf("%08lx", sum);
}

static json_t *inputs(const Cases *cases)
{
    json_t *list = json_array();
    for (int k = 0; k < cases->n; k++)
        json_array_append_new(list, json_string(cases->list[k].command));
    return list;
}

static json_t *time_steps(const Digest *d)
{
    static const char definition[] = "dt = t_end/n, n = ceil(t_end/dt0 - 1e-9), dt0 = cfl h/c; "
                                     "c as `mpmlab describe PROBLEM` says";
    return json_pack("{so so ss}", "min", number(d->dt_min), "max", number(d->dt_max), "definition",
                     definition);
}

/* "AMD EPYC 7571" as the system names the processor; null where it does not. */
static json_t *processor(void)
{
    char line[256], name[256] = "";
    FILE *f = fopen("/proc/cpuinfo", "r");
    while (f && !*name && fgets(line, sizeof line, f)) sscanf(line, "model name : %255[^\n]", name);
    if (f) fclose(f);
    return *name ? json_string(name) : json_null();
}

static json_t *describe(const Study *study, const Cases *cases, const Table *t)
{
    Digest d = digest(t);
    return json_pack("{ss ss ss ss ss ss so ss so so si so so so}", "study", study->name, "figure",
                     study->figure, "about", study->about, "version", FACT_VERSION, "compiler",
                     FACT_COMPILER, "flags", FACT_FLAGS, "processor", processor(), "sources",
                     FACT_SOURCES, "dt", time_steps(&d), "seconds", number(d.seconds), "rows",
                     t->nrow, "checksum", hex(d.sum), "inputs_checksum", hex(cases_checksum(cases)),
                     "inputs", inputs(cases));
}

int sidecar_write(const Study *study, const Cases *cases, const char *dir, Fault *fault)
{
    const char *csv = phrase("%s/%s.csv", dir, study->name);
    const char *path = phrase("%s/%s.json", dir, study->name);
    Table *t = table_read(csv, fault);
    json_t *json = t ? must(describe(study, cases, t)) : NULL;
    FILE *f = json ? file_begin(path, fault) : NULL;
    int code = FAULT_MACHINE;
    if (f) {
        json_dumpf(json, f, JSON_INDENT(1) | JSON_REAL_PRECISION(17));
        putc('\n', f);
        code = file_commit(f, path, fault);
    }
    json_decref(json);
    table_free(t);
    return code;
}

static bool has_text(const json_t *json, const char *name, unsigned long sum)
{
    char text[32];
    const char *value = json_string_value(json_object_get(json, name));
    snprintf(text, sizeof text, "%08lx", sum);
    return value && strcmp(value, text) == 0;
}

static const char *why_not(const Study *study, const char *dir, const json_t *json, const Table *t)
{
    Cases cases;
    if (!json || !t) return "not run yet";
    if (!has_text(json, "checksum", digest(t).sum)) return "the table is not the one that was made";
    int code = cases_build(&cases, study, false, NULL, dir, NULL);
    bool same = code == 0 && has_text(json, "inputs_checksum", cases_checksum(&cases));
    cases_free(&cases);
    return same ? NULL : "made from other sources or for other cases: run the study again";
}

bool sidecar_is_current(const Study *study, const char *dir, char reason[128])
{
    const char *csv = phrase("%s/%s.csv", dir, study->name);
    const char *path = phrase("%s/%s.json", dir, study->name);
    json_t *json = json_load_file(path, 0, NULL);
    Table *t = table_read(csv, NULL);
    const char *why = why_not(study, dir, json, t);
    snprintf(reason, 128, "%s", why ? why : "");
    table_free(t);
    json_decref(json);
    return !why;
}

static int by_text(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* How many of the listed runs are not among the cases. */
static int runs_beyond(const json_t *list, const Cases *cases)
{
    const size_t n = (size_t)cases->n;
    const char **known = must(calloc(n + 1, sizeof *known));
    int beyond = 0;
    for (size_t k = 0; k < n; k++) known[k] = cases->list[k].command;
    qsort(known, n, sizeof *known, by_text);
    for (size_t k = 0; k < json_array_size(list); k++) {
        const char *run = json_string_value(json_array_get(list, k));
        beyond += run && !bsearch(&run, known, n, sizeof *known, by_text);
    }
    free(known);
    return beyond;
}

/* NAME-1, or the first number that is free. */
static const char *free_name(const char *dir, const char *name)
{
    int k = 1;
    while (access(phrase("%s/%s-%d.json", dir, name, k), F_OK) == 0) k++;
    return phrase("%s-%d", name, k);
}

static int rename_part(const char *dir, const char *name, const char *to, const char *ending,
                       Fault *fault)
{
    const char *from = phrase("%s/%s%s", dir, name, ending),
               *now = phrase("%s/%s%s", dir, to, ending);
    return rename(from, now) == 0 ? 0 : fault_machine(fault, now);
}

/* Everything that belongs to the table; its NAME.json last, so that a rename that was interrupted
 * goes on next time. */
static int rename_all(const char *dir, const char *name, const char *to, Fault *fault)
{
    static const char *const others[] = {".rows", ".collect", ".json"};
    const size_t n = strlen(name);
    DIR *d = opendir(dir);
    int code = 0;
    for (struct dirent *e; d && code == 0 && (e = readdir(d));) {
        const char *ending = e->d_name + n;
        bool moves = strncmp(e->d_name, name, n) == 0 && *ending == '.';
        for (int k = 0; k < 3 && moves; k++) moves = strcmp(ending, others[k]) != 0;
        if (moves) code = rename_part(dir, name, to, ending, fault);
    }
    if (d) closedir(d);
    return code ? code : rename_part(dir, name, to, ".json", fault);
}

int sidecar_keep(const Study *study, const Cases *cases, const char *dir, Fault *fault)
{
    const char *path = phrase("%s/%s.json", dir, study->name);
    json_t *json = json_load_file(path, 0, NULL);
    int code = 0;
    if (runs_beyond(json_object_get(json, "inputs"), cases)) {
        const char *to = free_name(dir, study->name);
        code = rename_all(dir, study->name, to, fault);
        if (code == 0)
            fprintf(stderr,
                    "mpmlab: %s was another sweep, which is kept as %s; --name keeps both "
                    "under names of their own\n",
                    study->name, to);
    }
    json_decref(json);
    return code;
}
