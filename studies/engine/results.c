/* results.c: see results.h. Tables that a page writes are kept in memory until it has written all
 * of them, so that a page that fails leaves none. */
#include "results.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "cases.h"
#include "studies/runs/must.h"
#include "studies/runs/run_row.h"
#include "studies/select.h"

/* A file that the page writes, or a table that it has read. */
typedef struct Part {
    struct Part *next;
    const char *path;
    char *text;
    size_t size;
    FILE *f; /* NULL: written */
    Table *table;
} Part;

enum { KEPT = 8, PART_TEXT = 256 };

/* A table that a run has left, by its part's name. */
typedef struct Kept {
    char part[PART_TEXT];
    Table *table;
} Kept;

struct ResultsOwn {
    Part *parts;
    Kept kept[KEPT]; /* the one used last comes first; a new one replaces the last */
    Table *rows;
    Cases cases;
    int *row; /* [cases.n] the case's row, or -1; NULL: not matched yet */
    char missing[192];
    Fault fault; /* the first */
};

static Table *no_table(void)
{
    return must(calloc(1, sizeof(Table)));
}

Results *results_open(const Study *study, const char *dir, bool quick)
{
    Results *r = must(calloc(1, sizeof *r));
    r->own = must(calloc(1, sizeof *r->own));
    Table *rows = table_read_part(dir, study->name, NULL, &r->own->fault);
    r->own->rows = rows ? rows : no_table();
    *r = (Results){study, dir, quick, r->own->rows, r->own};
    select_begin(study->name);
    return r;
}

/* ---- Tables of the page */

static Part *add_part(const Results *r, const char *path)
{
    Part *p = must(calloc(1, sizeof *p));
    p->path = path;
    p->next = r->own->parts;
    r->own->parts = p;
    return p;
}

static const char *path_of(const Results *r, const char *part, const char *ending)
{
    return phrase("%s/%s%s%s.%s", r->dir, r->study->name, *part ? "." : "", part, ending);
}

FILE *results_write(const Results *r, const char *part, const char *header)
{
    Part *p = add_part(r, path_of(r, part, "csv"));
    p->f = must(open_memstream(&p->text, &p->size));
    fprintf(p->f, "%s\n", header);
    return p->f;
}

FILE *results_write_notes(const Results *r)
{
    Part *p = add_part(r, path_of(r, "", "var"));
    return p->f = must(open_memstream(&p->text, &p->size));
}

/* One conversion with its argument. */
static void print_cell(FILE *f, char conversion, int precision, va_list *args)
{
    if (conversion == 's')
        fputs(va_arg(*args, const char *), f);
    else if (conversion == 'd')
        fprintf(f, "%d", va_arg(*args, int));
    else {
        const double x = va_arg(*args, double);
        if (isfinite(x)) fprintf(f, conversion == 'g' ? "%.*g" : "%.*f", precision, x);
    }
}

void results_print(FILE *table, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    for (const char *at = format; *at; at++) {
        char *end = NULL;
        if (*at != '%') {
            putc(*at, table);
            continue;
        }
        const long precision = at[1] == '.' ? strtol(at + 2, &end, 10) : -1; /* -1: none given */
        at = end ? end : at + 1;
        print_cell(table, *at, (int)precision, &args);
    }
    va_end(args);
}

/* Puts the file on disk, unless something has failed before. */
static void commit(Part *p, Fault *fault)
{
    if (!p->f) return;
    must(fclose(p->f) ? NULL : p);
    p->f = NULL;
    FILE *f = fault->code ? NULL : file_begin(p->path, fault);
    if (f) fwrite(p->text, 1, p->size, f);
    if (f) file_commit(f, p->path, fault);
}

const Table *results_part(const Results *r, const char *part)
{
    const char *path = path_of(r, part, "csv");
    Part *p = r->own->parts;
    while (p && strcmp(p->path, path) != 0) p = p->next;
    if (!p) p = add_part(r, path);
    if (p->table) return p->table;
    commit(p, &r->own->fault);
    p->table = table_read(p->path, NULL);
    if (!p->table)
        snprintf(r->own->missing, sizeof r->own->missing, "%s.%s.csv", r->study->name, part);
    return p->table ? p->table : (p->table = no_table());
}

const char *results_missing(const Results *r)
{
    return r->own->missing;
}

int results_close(Results *r, Fault *fault)
{
    struct ResultsOwn *own = r->own;
    for (Part *p = own->parts, *next; p; p = next) {
        commit(p, &own->fault);
        next = p->next;
        table_free(p->table);
        free(p->text);
        free(p);
    }
    const int code = own->fault.code;
    if (code) fault_set(fault, code, "%s", own->fault.text);
    cases_free(&own->cases);
    for (int k = 0; k < KEPT; k++) table_free(own->kept[k].table);
    table_free(own->rows);
    free(own->row);
    free(own);
    free(r);
    return code;
}

int results_tables(const Study *study, const char *dir, bool quick, Fault *fault)
{
    Results *r = results_open(study, dir, quick);
    if (!study->page->cases) r->own->fault.code = 0;
    if (r->own->fault.code == 0) study->page->tables(r);
    if (r->own->fault.code == 0 && r->own->missing[0])
        fault_set(&r->own->fault, FAULT_MACHINE, "%s/%s: no table", dir, r->own->missing);
    return results_close(r, fault);
}

/* ---- Files of runs */

/* Rows stand in the order of cases; those of methods that were not asked for are left out. Returns
 * how many rows found their case. */
static int match(struct ResultsOwn *own)
{
    const Table *rows = own->rows;
    int row = 0;
    own->row = must(malloc(sizeof *own->row * ((size_t)own->cases.n + 1)));
    for (int k = 0; k < own->cases.n; k++) {
        const Case *c = &own->cases.list[k];
        const bool is_its = row < rows->nrow && run_row_is(rows, row, &c->spec, c->engine);
        own->row[k] = is_its ? row++ : -1;
    }
    return row;
}

/* Which of both lists of cases the rows are of. */
static void find_cases(const Results *r)
{
    struct ResultsOwn *own = r->own;
    for (int quick = 0; quick < 2; quick++) {
        cases_build(&own->cases, r->study, quick, NULL, r->dir, NULL);
        if (match(own) >= own->rows->nrow || r->study->page->refine || quick) return;
        cases_free(&own->cases);
        free(own->row);
    }
}

const char *results_status(const Results *r, const char *part)
{
    const char *path = path_of(r, part, "csv"), *status = "absent";
    if (!r->own->row) find_cases(r);
    for (int k = 0; k < r->own->cases.n; k++) {
        const char *file = r->own->cases.list[k].file;
        if (!file || strcmp(file, path) != 0) continue;
        const int row = r->own->row[k];
        status = row < 0 ? "absent" : select_is_lost(r->rows, row) ? "lost" : "ok";
        if (status[0] != 'o') break;
    }
    return status;
}

/* The file that any run has left. */
static Table *file_left(const Results *r, const char *part)
{
    return table_read_part(r->dir, r->study->name, part, NULL);
}

const char *results_path(const Results *r, const char *part)
{
    return results_status(r, part)[0] == 'o' ? path_of(r, part, "csv") : NULL;
}

/* The table that a run has left, read when it is first asked for. */
static const Table *keep(const Results *r, const char *part)
{
    Kept *kept = r->own->kept;
    int at = 0;
    while (at < KEPT - 1 && !(kept[at].table && strcmp(kept[at].part, part) == 0)) at++;
    Kept one = kept[at];
    if (!one.table || strcmp(one.part, part) != 0) {
        table_free(one.table);
        one.table = file_left(r, part);
        if (!one.table) one.table = no_table();
        snprintf(one.part, sizeof one.part, "%s", part);
    }
    memmove(kept + 1, kept, sizeof *kept * (size_t)at);
    kept[0] = one;
    return one.table;
}

const Table *results_run(const Results *r, const char *part, ...)
{
    static const Table none;
    char text[PART_TEXT];
    PHRASE_INTO(text, part);
    return results_status(r, text)[0] == 'o' ? keep(r, text) : &none;
}

const Table *results_ended(const Results *r, const char *part, ...)
{
    char text[PART_TEXT];
    PHRASE_INTO(text, part);
    return keep(r, text);
}
