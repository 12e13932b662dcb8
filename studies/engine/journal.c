/* journal.c: one record a line, "LENGTH CRC32 KEY<tab>ROW", appended whole; what does not check out
 * is skipped byte by byte until a record does, so damage costs only the records it touched. */
#include "journal.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>
#include "common/base/info.h"
#include "common/base/table.h"
#include "studies/runs/must.h"

enum { HEAD = 18 }; /* "%08zu %08lx " */

static unsigned long checksum(const char *text, size_t n)
{
    return crc32(0, (const unsigned char *)text, (unsigned)n);
}

/* Length of the record that starts at text (n bytes left), newline included; 0 if there is none. */
static size_t record_at(const char *text, size_t n)
{
    if (n < HEAD || text[8] != ' ' || text[HEAD - 1] != ' ') return 0;
    for (int k = 0; k < 8; k++)
        if (!isdigit((unsigned char)text[k]) || !isxdigit((unsigned char)text[9 + k])) return 0;
    size_t length = strtoul(text, NULL, 10);
    if (length >= n - HEAD || text[HEAD + length] != '\n') return 0;
    if (strtoul(text + 9, NULL, 16) != checksum(text + HEAD, length)) return 0;
    const char *body = text + HEAD; /* one line of text, a tab behind the key */
    if (memchr(body, '\n', length) || memchr(body, '\0', length)) return 0;
    return memchr(body, '\t', length) ? HEAD + length + 1 : 0;
}

/* Is the word of n letters a number? The last word, the program's checksum, is none. */
static bool is_number(const char *word, size_t n, double *x)
{
    char text[64];
    if (!word[n] || n >= sizeof text) return false;
    snprintf(text, sizeof text, "%.*s", (int)n, word);
    return info_number_parse(text, x) == 0;
}

static int compare_words(const char *a, size_t n, const char *b, size_t m)
{
    double x = 0, y = 0;
    const int order = memcmp(a, b, n < m ? n : m);
    if (order == 0 && n == m && !a[n] == !b[m]) return 0;
    const bool is_x = is_number(a, n, &x), is_y = is_number(b, m, &y);
    if (is_x && is_y) return (x > y) - (x < y);
    if (is_x != is_y) return is_x ? -1 : 1;
    return order ? order : (n > m) - (n < m);
}

int journal_compare_keys(const char *a, const char *b)
{
    for (;;) {
        const size_t n = strcspn(a, " ="), m = strcspn(b, " =");
        const int order = compare_words(a, n, b, m);
        if (order) return order;
        if (a[n] != b[m]) return a[n] < b[m] ? -1 : 1;
        if (!a[n]) return 0;
        a += n + 1;
        b += m + 1;
    }
}

static int by_key(const void *a, const void *b)
{
    const Record *x = a, *y = b;
    int order = journal_compare_keys(x->key, y->key);
    return order ? order : (x->key > y->key) - (x->key < y->key); /* then by place in the file */
}

/* Finds the records in text, in place. Returns where the last one ends. */
static size_t scan(Journal *j, size_t size)
{
    size_t end = 0, length;
    j->n = 0;
    for (size_t at = 0; at < size; at += length ? length : 1) {
        length = record_at(j->text + at, size - at);
        if (!length) continue;
        end = at + length;
        char *key = j->text + at + HEAD, *tab = strchr(key, '\t');
        *tab = '\0';
        j->text[end - 1] = '\0';
        j->records = must_grow(j->records, j->n, sizeof *j->records);
        j->records[j->n++] = (Record){key, tab + 1};
    }
    return end;
}

/* Keeps the last of equal keys. */
static void sort_unique(Journal *j)
{
    int n = 0;
    if (j->n) qsort(j->records, (size_t)j->n, sizeof *j->records, by_key);
    for (int k = 0; k < j->n; k++) {
        if (n && journal_compare_keys(j->records[n - 1].key, j->records[k].key) == 0) n--;
        j->records[n++] = j->records[k];
    }
    j->n = n;
}

int journal_reload(Journal *j, const char *path, Fault *fault)
{
    struct stat s;
    if (fstat(j->fd, &s) != 0) return fault_machine(fault, path);
    size_t size = (size_t)s.st_size, n = 0;
    free(j->text);
    j->text = must(malloc(size + 1));
    while (n < size) {
        ssize_t got = pread(j->fd, j->text + n, size - n, (off_t)n);
        if (got <= 0) return fault_machine(fault, path);
        n += (size_t)got;
    }
    j->text[size] = '\0';
    size_t end = scan(j, size);
    sort_unique(j);
    if (end < size && ftruncate(j->fd, (off_t)end) != 0) return fault_machine(fault, path);
    return 0;
}

static int lock(int fd, const char *path)
{
    if (flock(fd, LOCK_EX | LOCK_NB) == 0) return 0;
    if (errno != EWOULDBLOCK) return -1;
    fprintf(stderr, "mpmlab: %s: waiting for the study that is writing it\n", path);
    return flock(fd, LOCK_EX);
}

/* Is fd still the file of that name? Whoever held it before may have replaced it. */
static int is_current(int fd, const char *path)
{
    struct stat ours, named;
    return fstat(fd, &ours) == 0 && stat(path, &named) == 0 && ours.st_ino == named.st_ino &&
           ours.st_dev == named.st_dev;
}

int journal_open(Journal *j, const char *path, Fault *fault)
{
    for (*j = (Journal){.fd = -1};;) {
        j->fd = open(path, O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
        if (j->fd < 0 || lock(j->fd, path) != 0) break;
        if (is_current(j->fd, path)) {
            int code = journal_reload(j, path, fault);
            if (code) journal_close(j);
            return code;
        }
        close(j->fd);
    }
    int code = fault_machine(fault, path);
    journal_close(j);
    return code;
}

const char *journal_row(const Journal *j, const char *key)
{
    for (int low = 0, high = j->n; low < high;) {
        int middle = (low + high) / 2, order = journal_compare_keys(key, j->records[middle].key);
        if (order == 0) return j->records[middle].row;
        if (order < 0)
            high = middle;
        else
            low = middle + 1;
    }
    return NULL;
}

/* A record as it stands in the file, its newline included; the caller frees it. */
static char *record_line(const char *key, const char *row)
{
    char *body = must_text("%s\t%s", key, row);
    size_t length = strlen(body);
    char *line = must_text("%08zu %08lx %s\n", length, checksum(body, length), body);
    free(body);
    return line;
}

int journal_append(int fd, const char *key, const char *row)
{
    char *line = record_line(key, row);
    ssize_t whole = (ssize_t)strlen(line), done = write(fd, line, (size_t)whole);
    int error = done < 0 ? errno : ENOSPC;
    free(line);
    return done == whole ? 0 : error;
}

/* ---- Compaction: rows of programs that are gone are dropped */

/* What the key says of the program that made the row: its last word. */
static const char *program_of(const char *key)
{
    const char *space = strrchr(key, ' ');
    return space ? space + 1 : key;
}

static int is_among(const char *const *programs, int n, const char *program)
{
    for (int k = 0; k < n; k++)
        if (strcmp(programs[k], program) == 0) return 1;
    return 0;
}

static int by_place(const void *a, const void *b)
{
    const Record *x = a, *y = b;
    return (x->key > y->key) - (x->key < y->key);
}

/* The programs to keep: this one, then those of the file's last rows. */
static int newest_programs(const Record *records, int n, const char *program,
                           const char *programs[MOST_PROGRAMS])
{
    int kept = 0;
    programs[kept++] = program;
    for (int k = n - 1; k >= 0 && kept < MOST_PROGRAMS; k--)
        if (!is_among(programs, kept, program_of(records[k].key)))
            programs[kept++] = program_of(records[k].key);
    return kept;
}

/* Writes the rows to keep, in the order they were made. How many bytes. */
static off_t write_kept(FILE *f, const Record *records, int n, const char *program)
{
    const char *programs[MOST_PROGRAMS];
    off_t size = 0;
    int kept = newest_programs(records, n, program, programs);
    for (int k = 0; k < n; k++) {
        if (!is_among(programs, kept, program_of(records[k].key))) continue;
        char *line = record_line(records[k].key, records[k].row);
        fputs(line, f);
        size += (off_t)strlen(line);
        free(line);
    }
    return size;
}

/* The new file under the old name, locked before it gets there. */
static int replace(Journal *j, FILE *f, const char *path, Fault *fault)
{
    int fd = fcntl(fileno(f), F_DUPFD_CLOEXEC, 3);
    if (fd < 0 || fcntl(fd, F_SETFL, O_APPEND) != 0 || flock(fd, LOCK_EX) != 0) {
        int error = errno;
        if (fd >= 0) close(fd);
        file_abandon(f, path);
        return fault_set(fault, FAULT_MACHINE, "%s: %s", path, strerror(error));
    }
    int code = file_commit(f, path, fault);
    close(code ? fd : j->fd);
    if (code) return code;
    j->fd = fd;
    return journal_reload(j, path, fault);
}

int journal_compact(Journal *j, const char *path, const char *program, Fault *fault)
{
    struct stat s;
    if (journal_reload(j, path, fault)) return FAULT_MACHINE;
    const size_t bytes = sizeof(Record) * (size_t)(j->n + 1);
    if (j->n == 0 || fstat(j->fd, &s) != 0) return 0;
    FILE *f = file_begin(path, fault);
    if (!f) return FAULT_MACHINE;
    Record *records = must(malloc(bytes));
    memcpy(records, j->records, sizeof(Record) * (size_t)j->n);
    qsort(records, (size_t)j->n, sizeof(Record), by_place);
    off_t size = write_kept(f, records, j->n, program);
    free(records);
    if (size < s.st_size) return replace(j, f, path, fault);
    file_abandon(f, path);
    return 0;
}

void journal_close(Journal *j)
{
    if (j->fd >= 0) close(j->fd);
    free(j->text);
    free(j->records);
    *j = (Journal){.fd = -1};
}
