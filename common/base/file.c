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

enum { MOST_PATH = 4000 }; /* leaves room for what beside() appends */

static void beside(const char *path, char out[PATH_MAX])
{
    snprintf(out, PATH_MAX, "%.*s.%d.tmp", MOST_PATH, path, (int)getpid());
}

static void folder_of(const char *path, char out[PATH_MAX])
{
    const char *slash = strrchr(path, '/');
    snprintf(out, PATH_MAX, "%.*s", slash ? (int)(slash - path) + 1 : 1, slash ? path : ".");
}

/* A file without a name in path's folder; -1 where the file system has none. */
static int open_nameless(const char *path)
{
    char folder[PATH_MAX];
    folder_of(path, folder);
    return open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
}

/* Devices and pipes are written straight: they have nothing to keep whole, and must not be
 * replaced. */
static int is_special(const char *path)
{
    struct stat s;
    return stat(path, &s) == 0 && !S_ISREG(s.st_mode);
}

/* Can a file be made beside path and renamed over it? Leaves errno if not. */
static int is_replaceable(const char *path)
{
    struct stat s;
    char folder[PATH_MAX], temporary[PATH_MAX];
    folder_of(path, folder);
    beside(path, temporary);
    errno = ENAMETOOLONG;
    if (strlen(path) > MOST_PATH || access(folder, W_OK | X_OK) != 0) return 0;
    return lstat(temporary, &s) == 0 || errno == ENOENT; /* its name is the longer one */
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
    int fd = is_special(path) ? open(path, O_WRONLY | O_CLOEXEC) : open_nameless(path);
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

/* Gives the file its temporary name, if it has none yet. */
static int name_it(FILE *f, const char *temporary)
{
    struct stat s;
    char self[64];
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
    char temporary[PATH_MAX];
    beside(path, temporary);
    if (is_special(path)) return close_special(f, path, fault);
    if (fflush(f) == 0 && !ferror(f)) {
        if (same_bytes(f, path)) {
            file_abandon(f, path);
            return 0;
        }
        if (name_it(f, temporary) == 0 && rename(temporary, path) == 0) {
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
