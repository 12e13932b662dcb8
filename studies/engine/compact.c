/* compact.c: journals lose the rows of programs that are gone (journal.h). */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include "common/base/table.h"
#include "journal.h"
#include "studies/runs/memory.h"

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
        char *line = journal_line(records[k].key, records[k].row);
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
