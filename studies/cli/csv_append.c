/* csv_append.c: one write() per row under flock, so that parallel runs can share a table. */
#include "csv_append.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include "common/base/table.h"

enum { BLOCK = 512, OLDEST = 27 /* columns of the first tables */ };

/* Columns of a header that is ours or, from an older program, the beginning of it; else 0. */
static int columns_of(const char *header, const char *ours)
{
    const size_t n = strlen(header);
    int columns = 1;
    if (strncmp(header, ours, n) != 0 || (ours[n] && ours[n] != ',')) return 0;
    for (const char *c = header; *c; c++) columns += *c == ',';
    return columns < OLDEST ? 0 : columns;
}

/* Reads the first line: the number of its columns, 0 if the file has none yet; -1 and a fault if
 * they are not ours. */
static int read_header(int fd, const char *path, Fault *fault)
{
    char text[ROW_TEXT + 2], ours[ROW_TEXT];
    int length = row_header(ours);
    ssize_t n = pread(fd, text, sizeof text - 1, 0);
    if (n < 0 && errno != ESPIPE) {
        fault_machine(fault, path);
        return -1;
    }
    if (n <= 0) return 0;
    text[n] = '\0';
    if (n < length && strncmp(text, ours, (size_t)n) == 0) return 0; /* a torn header: start anew */
    text[strcspn(text, "\r\n")] = '\0';
    const int columns = columns_of(text, ours);
    if (columns > 0) return columns;
    fault_set(fault, FAULT_USAGE,
              "--csv: got '%s', a file with other columns, takes a table of rows", path);
    return -1;
}

int csv_append_check(const char *path, Fault *fault)
{
    int fd = open(path, O_RDWR | O_APPEND | O_CLOEXEC);
    if (fd >= 0) {
        int header = read_header(fd, path, fault);
        close(fd);
        return header < 0 ? fault->code : 0;
    }
    return errno == ENOENT ? file_check(path, fault) : fault_machine(fault, path);
}

/* Makes the file end in a whole line. A last line without a newline gets one if it has every cell,
 * else it is dropped. It is also dropped if the file ends exactly at the boundary of a disk block:
 * a torn write stops there, and the last number may have lost digits. Returns the file's new size,
 * or -1. */
static off_t mend_tail(int fd, off_t size, int columns, const char *path, FILE *notes)
{
    char c = '\n';
    int cells = 1;
    off_t whole = size;
    while (whole > 0 && pread(fd, &c, 1, whole - 1) == 1 && c != '\n') {
        cells += c == ',';
        whole--;
    }
    if (whole == size) return size;
    if (cells == columns && size % BLOCK != 0) return write(fd, "\n", 1) == 1 ? size + 1 : -1;
    if (notes) fprintf(notes, "mpmlab: %s: dropped its last line, which was torn\n", path);
    return ftruncate(fd, whole) == 0 ? whole : -1;
}

/* Writes all of text or, as far as it can, nothing. */
static int write_whole(int fd, const char *path, const char *text, size_t n, off_t size,
                       Fault *fault)
{
    ssize_t done = write(fd, text, n);
    if (done == (ssize_t)n) return 0;
    if (done >= 0) errno = ENOSPC;
    int code = fault_machine(fault, path);
    return ftruncate(fd, size) == 0 ? code : code; /* what is left is then a torn line, and known */
}

/* The row as a line of the first `columns` cells. Returns its length. */
static int print_line(const Row *row, int columns, char *out)
{
    int n = row_print(row, out);
    for (int k = row_columns(); k > columns; k--)
        while (out[--n] != ',') continue;
    out[n++] = '\n';
    return n;
}

static int append_locked(int fd, const char *path, const Row *row, FILE *notes, Fault *fault)
{
    struct stat s;
    char text[2 * ROW_TEXT];
    const int found = read_header(fd, path, fault), columns = found ? found : row_columns();
    int n = 0;
    if (found < 0) return fault->code;
    if (fstat(fd, &s) != 0) return fault_machine(fault, path);
    off_t size = S_ISREG(s.st_mode) ? mend_tail(fd, s.st_size, columns, path, notes) : 0;
    if (size < 0) return fault_machine(fault, path);
    if (!found) {
        n = row_header(text);
        text[n++] = '\n';
    }
    n += print_line(row, columns, text + n);
    return write_whole(fd, path, text, (size_t)n, size, fault);
}

int csv_append(const char *path, const Row *row, FILE *notes, Fault *fault)
{
    int fd = open(path, O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
    if (fd < 0) return fault_machine(fault, path);
    int code = flock(fd, LOCK_EX) == 0 || errno == EINVAL ? 0 : fault_machine(fault, path);
    if (code == 0) code = append_locked(fd, path, row, notes, fault);
    if (close(fd) != 0 && code == 0) code = fault_machine(fault, path);
    return code;
}
