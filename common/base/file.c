/* file.c: files that appear whole or not at all (table.h): written without a name where the system
 * can (O_TMPFILE), so that a killed program leaves nothing behind, then linked and renamed into
 * place. */
#define _GNU_SOURCE /* O_TMPFILE */
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "table.h"

enum { MOST_PATH = 4000, MOST_LINKS = 40 }; /* MOST_PATH leaves room for what beside() appends */

static void folder_of(const char *path, char out[PATH_MAX])
{
    const char *slash = strrchr(path, '/');
    snprintf(out, PATH_MAX, "%.*s", slash ? (int)(slash - path) + 1 : 2, slash ? path : "./");
}

void file_target(const char *path, char out[PATH_MAX])
{
    char link[PATH_MAX], folder[PATH_MAX];
    int length = snprintf(out, PATH_MAX, "%s", path);
    for (int k = 0; k < MOST_LINKS && length < PATH_MAX; k++) {
        const ssize_t n = readlink(out, link, sizeof link - 1);
        if (n < 0) return;
        link[n] = '\0';
        folder_of(out, folder);
        length = snprintf(out, PATH_MAX, "%s%s", link[0] == '/' ? "" : folder, link);
    }
}

static void beside(const char *path, char out[PATH_MAX])
{
    char target[PATH_MAX];
    file_target(path, target);
    snprintf(out, PATH_MAX, "%.*s.%d.tmp", MOST_PATH, target, (int)getpid());
}

/* A file without a name in the folder of what will be replaced; -1 where the file system has none.
 */
static int open_nameless(const char *path)
{
    char target[PATH_MAX], folder[PATH_MAX];
    file_target(path, target);
    folder_of(target, folder);
    return open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
}

/* The number of the open stream that path names, as /dev/stdout does; -1: it names none. */
static int stream_of(const char *path)
{
    static const char *const names[] = {"/dev/stdin", "/dev/stdout", "/dev/stderr"};
    int fd = -1;
    for (int k = 0; k < 3; k++)
        if (strcmp(path, names[k]) == 0) return k;
    return sscanf(path, "/dev/fd/%d", &fd) || sscanf(path, "/proc/self/fd/%d", &fd) ? fd : -1;
}

/* Streams, devices and pipes are written straight: they have nothing to keep whole, and must not be
 * replaced. */
static int is_special(const char *path)
{
    struct stat s;
    return stream_of(path) >= 0 || (stat(path, &s) == 0 && !S_ISREG(s.st_mode));
}

/* A stream goes on where it is, also in a file. */
static int open_special(const char *path)
{
    const int fd = stream_of(path);
    return fd < 0 ? open(path, O_WRONLY | O_CLOEXEC) : fcntl(fd, F_DUPFD_CLOEXEC, 0);
}

/* Can a file be made beside path and renamed over it? Tries it. Leaves errno if not. */
static int is_replaceable(const char *path)
{
    struct stat s;
    char temporary[PATH_MAX];
    beside(path, temporary);
    errno = ENAMETOOLONG;
    if (strlen(path) > MOST_PATH) return 0;
    if (lstat(temporary, &s) != 0 && errno != ENOENT) return 0; /* its name is the longer one */
    int fd = open_nameless(path);
    if (fd < 0) {
        fd = open(temporary, O_CREAT | O_TRUNC | O_RDWR | O_CLOEXEC, 0666);
        if (fd >= 0) unlink(temporary);
    }
    if (fd >= 0) close(fd);
    return fd >= 0;
}

int file_check(const char *path, Fault *fault)
{
    struct stat s;
    const int there = stat(path, &s) == 0, missing = !there && errno == ENOENT;
    if (there && S_ISDIR(s.st_mode))
        errno = EISDIR;
    else if (there && access(path, W_OK) == 0 && (!S_ISREG(s.st_mode) || is_replaceable(path)))
        return 0;
    else if (missing && is_replaceable(path))
        return 0;
    return fault_machine(fault, path);
}

FILE *file_begin(const char *path, Fault *fault)
{
    char temporary[PATH_MAX];
    beside(path, temporary);
    int fd = is_special(path) ? open_special(path) : open_nameless(path);
    if (fd < 0 && !is_special(path))
        fd = open(temporary, O_CREAT | O_TRUNC | O_RDWR | O_CLOEXEC, 0666);
    FILE *f = fd < 0 ? NULL : fdopen(fd, is_special(path) ? "w" : "w+");
    if (!f) fault_machine(fault, path);
    return f;
}

/* An unchanged file keeps its old time stamp, so that what is made from it is not made again. */
static int same_bytes(FILE *f, const char *path)
{
    FILE *old = fopen(path, "r");
    if (!old) return 0;
    char a[8192], b[sizeof a];
    size_t na, nb;
    rewind(f);
    do {
        na = fread(a, 1, sizeof a, f);
        nb = fread(b, 1, sizeof b, old);
    } while (na == nb && na > 0 && memcmp(a, b, na) == 0);
    fclose(old);
    return na == 0 && nb == 0;
}

/* Gives the file its temporary name, if it has none yet, and the mode of the file that it replaces.
 */
static int name_it(FILE *f, const char *path, const char *temporary)
{
    struct stat s;
    char self[64];
    if (stat(path, &s) == 0 && fchmod(fileno(f), s.st_mode & 07777) != 0) return -1;
    if (fstat(fileno(f), &s) != 0 || s.st_nlink > 0) return 0;
    unlink(temporary);
    snprintf(self, sizeof self, "/proc/self/fd/%d", fileno(f));
    return linkat(AT_FDCWD, self, AT_FDCWD, temporary, AT_SYMLINK_FOLLOW);
}

static int close_special(FILE *f, const char *path, Fault *fault)
{
    const int bad = fflush(f) != 0 || ferror(f), error = errno;
    fclose(f);
    return bad ? fault_set(fault, FAULT_MACHINE, "%s: %s", path, strerror(error)) : 0;
}

int file_commit(FILE *f, const char *path, Fault *fault)
{
    char temporary[PATH_MAX], target[PATH_MAX];
    beside(path, temporary);
    file_target(path, target);
    if (is_special(path)) return close_special(f, path, fault);
    if (fflush(f) == 0 && !ferror(f)) {
        if (same_bytes(f, path)) {
            file_abandon(f, path);
            return 0;
        }
        if (name_it(f, path, temporary) == 0 && rename(temporary, target) == 0) {
            fclose(f); /* flushed above: nothing left to fail */
            return 0;
        }
    }
    int error = errno;
    file_abandon(f, path);
    return fault_set(fault, FAULT_MACHINE, "%s: %s", path, strerror(error ? error : EIO));
}

void file_abandon(FILE *f, const char *path)
{
    char temporary[PATH_MAX];
    beside(path, temporary);
    fclose(f);
    if (!is_special(path)) unlink(temporary);
}

int file_make_folder(const char *path, Fault *fault)
{
    char part[PATH_MAX];
    int failed = strlen(path) >= sizeof part;
    if (failed) return fault_set(fault, FAULT_MACHINE, "%s: %s", path, strerror(ENAMETOOLONG));
    strcpy(part, path);
    for (char *c = part + 1; !failed && *c; c++) {
        if (*c != '/') continue;
        *c = '\0';
        failed = mkdir(part, 0777) != 0 && errno != EEXIST;
        *c = '/';
    }
    failed = failed || (mkdir(part, 0777) != 0 && errno != EEXIST);
    return failed ? fault_machine(fault, path) : 0;
}
