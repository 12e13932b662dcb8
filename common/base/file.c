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

/* The number of the open stream that path names, as /dev/stdout does; -1: it names none. */
static int stream_of(const char *path)
{
    static const char *const names[] = {"/dev/stdin", "/dev/stdout", "/dev/stderr"};
    int fd = -1;
    for (int k = 0; k < 3; k++)
        if (strcmp(path, names[k]) == 0) return k;
    return sscanf(path, "/dev/fd/%d", &fd) || sscanf(path, "/proc/self/fd/%d", &fd) ? fd : -1;
}

void file_target(const char *path, char out[PATH_MAX])
{
    char link[PATH_MAX], folder[PATH_MAX];
    int length = snprintf(out, PATH_MAX, "%s", path);
    for (int k = 0; k < MOST_LINKS && length < PATH_MAX && stream_of(out) < 0; k++) {
        const ssize_t n = readlink(out, link, sizeof link - 1);
        if (n < 0) return;
        link[n] = '\0';
        folder_of(out, folder);
        length = snprintf(out, PATH_MAX, "%s%s", link[0] == '/' ? "" : folder, link);
    }
}

bool file_is_special(const char *path)
{
    struct stat s;
    char target[PATH_MAX];
    file_target(path, target);
    return stream_of(target) >= 0 || (stat(path, &s) == 0 && !S_ISREG(s.st_mode));
}

/* A stream goes on where it is, also in a file. */
static int open_special(const char *path, const char *target)
{
    const int fd = stream_of(target);
    return fd < 0 ? open(path, O_WRONLY | O_CLOEXEC) : fcntl(fd, F_DUPFD_CLOEXEC, 0);
}

static void beside(const char *target, char out[PATH_MAX])
{
    snprintf(out, PATH_MAX, "%.*s.%d.tmp", MOST_PATH, target, (int)getpid());
}

/* A new file in the folder of what it will replace: without a name, or beside() where the file
 * system has no such files. */
static int open_new(const char *target)
{
    char folder[PATH_MAX], temporary[PATH_MAX];
    folder_of(target, folder);
    const int fd = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    if (fd >= 0) return fd;
    beside(target, temporary);
    unlink(temporary);
    return open(temporary, O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
}

/* Can a file be made beside target and renamed over it? Tries it. Leaves errno if not. */
static bool is_replaceable(const char *target)
{
    struct stat s;
    char temporary[PATH_MAX];
    beside(target, temporary);
    errno = ENAMETOOLONG;
    if (strlen(target) > MOST_PATH) return false;
    if (lstat(temporary, &s) != 0 && errno != ENOENT) return false; /* its name is the longer one */
    const int fd = open_new(target);
    if (fd < 0) return false;
    if (fstat(fd, &s) == 0 && s.st_nlink > 0) unlink(temporary);
    close(fd);
    return true;
}

static bool is_writable_stream(int fd)
{
    const int mode = fcntl(fd, F_GETFL);
    errno = EBADF;
    return mode >= 0 && (mode & O_ACCMODE) != O_RDONLY;
}

int file_check(const char *path, Fault *fault)
{
    struct stat s;
    char target[PATH_MAX];
    bool good;
    file_target(path, target);
    if (stream_of(target) >= 0)
        good = is_writable_stream(stream_of(target));
    else if (stat(path, &s) != 0)
        good = errno == ENOENT && is_replaceable(target);
    else if (S_ISDIR(s.st_mode))
        good = false, errno = EISDIR;
    else
        good = access(path, W_OK) == 0 && (!S_ISREG(s.st_mode) || is_replaceable(target));
    return good ? 0 : fault_machine(fault, path);
}

FILE *file_begin(const char *path, Fault *fault)
{
    char target[PATH_MAX];
    const bool special = file_is_special(path);
    file_target(path, target);
    const int fd = special ? open_special(path, target) : open_new(target);
    FILE *f = fd < 0 ? NULL : fdopen(fd, special ? "w" : "w+");
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

/* Gives the file the mode of the one that it replaces, and its temporary name if it has none yet.
 */
static int name_it(FILE *f, const char *target, const char *temporary)
{
    struct stat now, old;
    char self[64];
    if (fstat(fileno(f), &now) != 0) return -1;
    if (stat(target, &old) == 0 && (old.st_mode ^ now.st_mode) & 07777 &&
        fchmod(fileno(f), old.st_mode & 07777) != 0)
        return -1;
    if (now.st_nlink > 0) return 0;
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
    file_target(path, target);
    beside(target, temporary);
    if (file_is_special(path)) return close_special(f, path, fault);
    if (fflush(f) == 0 && !ferror(f)) {
        if (same_bytes(f, target)) {
            file_abandon(f, path);
            return 0;
        }
        if (name_it(f, target, temporary) == 0 && rename(temporary, target) == 0) {
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
    char temporary[PATH_MAX], target[PATH_MAX];
    file_target(path, target);
    beside(target, temporary);
    fclose(f);
    if (!file_is_special(path)) unlink(temporary);
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
