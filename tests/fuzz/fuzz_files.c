/* fuzz_files.c: damaged files of every kind: what is whole in them stays, nothing else gets in. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "common/base/table.h"
#include "studies/cli/csv_append.h"
#include "studies/engine/journal.h"
#include "fuzz.h"

/* Every record is a line of its own; appending adds just one; closing and opening changes none. */
static const char *try_journal(const char *path)
{
    Journal j, again;
    const char *wrong = NULL, key[] = "a key", row[] = "a,row";
    if (journal_open(&j, path, NULL)) return "a journal that cannot be read";
    for (int k = 0; k < j.n && !wrong; k++) {
        const Record *r = &j.records[k];
        if (strpbrk(r->key, "\t\n") || strchr(r->row, '\n')) wrong = "a record of several lines";
        if (journal_row(&j, r->key) != r->row) wrong = "a row that is not found by its key";
    }
    const int n = j.n + !journal_row(&j, key);
    if (journal_append(j.fd, key, row)) wrong = "a row that cannot be appended";
    close(j.fd);
    j.fd = -1;
    if (journal_open(&again, path, NULL)) return "a journal that cannot be read twice";
    if (again.n != n) wrong = "records lost or doubled";
    for (int k = 0; k < j.n && !wrong; k++) {
        const char *now = journal_row(&again, j.records[k].key);
        if (!now || (strcmp(now, j.records[k].row) && strcmp(now, row))) wrong = "a row changed";
    }
    if (!journal_row(&again, key) || strcmp(journal_row(&again, key), row)) wrong = "not appended";
    journal_close(&again);
    journal_close(&j);
    return wrong;
}

/* "Rkey<tab>row" lines become records of a whole journal; all else is taken as it is. */
static void put_line(FILE *out, char *line)
{
    char body[4096], *tab = strchr(line, '\t');
    int fds[2];
    if (line[0] != 'R' || !tab || strlen(line) > sizeof body / 2 || pipe(fds)) {
        fprintf(out, "%s\n", line);
        return;
    }
    *tab = '\0';
    if (journal_append(fds[1], line + 1, tab + 1) == 0) {
        ssize_t n = read(fds[0], body, sizeof body);
        fwrite(body, 1, n > 0 ? (size_t)n : 0, out);
    }
    close(fds[0]);
    close(fds[1]);
}

const char *fuzz_journal(const unsigned char *data, size_t n)
{
    enum { MOST = 64 };
    const char *path = fuzz_file(data, n), *wrong = try_journal(path);
    char *text = fuzz_text(data, n), *lines[MOST];
    const int count = fuzz_split(text, '\n', lines, MOST);
    FILE *out = fopen(path, "w");
    for (int k = 0; out && k < count; k++) put_line(out, lines[k]);
    if (!out || fclose(out) != 0) abort();
    if (!wrong) wrong = try_journal(path);
    free(text);
    unlink(path);
    return wrong;
}

static const char *write_again(const Table *t, const char *path)
{
    FILE *out = fopen(path, "w");
    if (!out) abort();
    for (int r = -1; r < t->nrow; r++)
        for (int c = 0; c < t->ncol; c++) {
            table_put_cell(out, r < 0 ? t->name[c] : t->cell[r * t->ncol + c]);
            putc(c + 1 < t->ncol ? ',' : '\n', out);
        }
    if (fclose(out) != 0) abort();
    Table *again = table_read(path, NULL);
    if (!again) return "a table that is not read back";
    const char *wrong = again->ncol == t->ncol && again->nrow == t->nrow ? NULL : "other cells";
    for (int k = 0; !wrong && k < t->ncol * (t->nrow + 1); k++)
        if (strcmp(t->name[k], again->name[k])) wrong = "a cell that changed";
    table_free(again);
    return wrong;
}

const char *fuzz_table(const unsigned char *data, size_t n)
{
    const char *path = fuzz_file(data, n), *wrong = NULL;
    Fault fault = {0};
    Table *t = table_read(path, &fault);
    if (!t && (fault.code != FAULT_MACHINE || !fault.text[0])) wrong = "refused without a word";
    if (t && memchr(data, '\0', n)) wrong = "a table that ends at a zero byte";
    for (int r = 0; t && r < t->nrow; r++) table_number(t, r, t->name[t->ncol - 1]);
    if (t && !wrong) wrong = write_again(t, path);
    table_free(t);
    unlink(path);
    return wrong;
}

/* Whole lines before stay as they are; the row is the last line, whole. */
const char *fuzz_append(const unsigned char *data, size_t n)
{
    char header[ROW_TEXT], line[ROW_TEXT], *before = malloc(n + ROW_TEXT + 2);
    const char *wrong = NULL;
    Row row = row_empty();
    Fault fault = {0};
    if (!before) abort();
    row_header(header);
    size_t size = (size_t)(n && data[0] == '+' ? sprintf(before, "%s\n", header) : 0), after;
    if (n) memcpy(before + size, data, n);
    size += n;
    const char *path = fuzz_file((unsigned char *)before, size);
    row.h = 0.5;
    row_print(&row, line);
    int code = csv_append(path, &row, NULL, &fault);
    char *text = fuzz_read(path, &after);
    while (size > 0 && before[size - 1] != '\n') size--;
    if (code && !fault.text[0]) wrong = "refused without a word";
    if (after < size || memcmp(text, before, size)) wrong = "lines that changed";
    const size_t length = strlen(line);
    if (!code && (after < length + 1 || strncmp(text + after - length - 1, line, length)))
        wrong = "no row";
    free(text);
    free(before);
    unlink(path);
    return wrong;
}
