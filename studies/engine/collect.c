/* collect.c: cases out as commands, rows back in by file name. */
#include "collect.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>
#include "studies/phrase.h"
#include "studies/runs/must.h"
#include "run_study.h"

/* The place of case k's row: its number in the list, and a checksum of its key. */
static const char *row_file(const Study *study, const Cases *cases, int k, const char *dir)
{
    const char *key = cases->list[k].key;
    unsigned long sum = crc32(0, (const unsigned char *)key, (unsigned)strlen(key));
    return phrase("%s/%s.collect/%05d-%08lx.csv", dir, study->name, k, sum);
}

/* One word of a shell command. */
static void print_word(const char *word)
{
    if (!word[strcspn(word, " \t\n'\"\\$&|;<>()*?[]#~`!{}")]) {
        fputs(word, stdout);
        return;
    }
    putchar('\'');
    for (; *word; word++) {
        if (*word == '\'')
            fputs("'\\''", stdout);
        else
            putchar(*word);
    }
    putchar('\'');
}

static void print_option(const char *option, const char *value)
{
    printf(" --%s ", option);
    print_word(value);
}

int collect_list(const Study *study, const Cases *cases, const Journal *journal, const char *dir,
                 Fault *fault)
{
    char program[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    program[length > 0 ? length : 0] = '\0';
    int n, *missing = cases_missing(cases, journal, &n);
    int code = file_make_folder(phrase("%s/%s.collect", dir, study->name), fault);
    for (int k = 0; k < n && code == 0; k++) {
        const Case *c = &cases->list[missing[k]];
        print_word(program);
        printf(" %s", c->command);
        if (c->file) print_option(c->kind, c->file);
        print_option("csv", row_file(study, cases, missing[k], dir));
        putchar('\n');
    }
    free(missing);
    return code;
}

/* Are its columns a row's, and does the file end in a line's end? A torn last number may read well.
 */
static bool is_whole(const Table *t, const char *file)
{
    FILE *f = fopen(file, "r");
    bool whole = f && t->ncol == row_columns() && fseek(f, -1, SEEK_END) == 0 && getc(f) == '\n';
    for (int k = 0; whole && k < t->ncol; k++) whole = strcmp(t->name[k], row_column_name(k)) == 0;
    if (f) fclose(f);
    return whole;
}

/* The last row of a table as one line, or NULL if there is none. */
static char *last_row(const char *file)
{
    Table *t = table_read(file, NULL);
    char *line = NULL;
    if (t && !is_whole(t, file)) t->nrow = 0;
    for (int k = 0; t && t->nrow && k < t->ncol; k++) {
        const char *cell = t->cell[(t->nrow - 1) * t->ncol + k];
        char *longer = must_text("%s%s%s", line ? line : "", k ? "," : "", cell);
        free(line);
        line = longer;
    }
    table_free(t);
    return line;
}

int collect_merge(const Study *study, const Cases *cases, const Journal *journal, const char *path,
                  const char *dir, Fault *fault)
{
    int n, error = 0, *missing = cases_missing(cases, journal, &n);
    for (int k = 0; k < n && !error; k++) {
        char *row = last_row(row_file(study, cases, missing[k], dir));
        if (row) error = journal_append(journal->fd, cases->list[missing[k]].key, row);
        free(row);
    }
    free(missing);
    return error ? fault_set(fault, FAULT_MACHINE, "%s: %s", path, strerror(error)) : 0;
}
