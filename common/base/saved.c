/* saved.c: see saved.h. */
#define _GNU_SOURCE /* fileno */
#include "saved.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>
#include "spec.h"
#include "table.h"

static const char magic[] = "mpmlab checkpoint 1\n";
enum { SUM = 9, HEAD = SPEC_TEXT + 64 }; /* SUM: eight digits and a newline */

static void path_before(const char *path, char out[PATH_MAX])
{
    char target[PATH_MAX];
    file_target(path, target);
    snprintf(out, PATH_MAX, "%.4000s.1", target);
}

int saved_check_before(const char *path, Fault *fault)
{
    char before[PATH_MAX], text[sizeof magic] = "";
    path_before(path, before);
    if (file_check(before, fault)) return FAULT_MACHINE;
    FILE *f = file_is_special(before) ? NULL : fopen(before, "r");
    const size_t n = f ? fread(text, 1, sizeof magic - 1, f) : 0;
    if (f) fclose(f);
    if (!file_is_special(before) && memcmp(text, magic, n) == 0) return 0; /* a torn one is short */
    return fault_set(fault, FAULT_USAGE,
                     "--checkpoint: got '%s', takes a path where FILE.1 is free or a checkpoint",
                     path);
}

int saved_check_path(const char *option, const char *path, Fault *fault)
{
    if (!path || !file_is_special(path)) return 0;
    return fault_set(fault, FAULT_USAGE, "%s: got '%s', takes a regular file with --checkpoint",
                     option, path);
}

/* Checksum of the first n bytes. */
static unsigned long sum_of(FILE *f, long n)
{
    unsigned char part[1 << 14];
    unsigned long sum = 0;
    rewind(f);
    for (size_t got = 1; n > 0 && got > 0; n -= (long)got) {
        got = fread(part, 1, n < (long)sizeof part ? (size_t)n : sizeof part, f);
        sum = crc32(sum, part, (unsigned)got);
    }
    return sum;
}

static void print_head(const SavedKey *key, char out[HEAD])
{
    snprintf(out, HEAD, "%s%08lx %s\n", magic, key->program, key->command);
}

FILE *saved_begin(const char *path, const SavedKey *key, Fault *fault)
{
    char head[HEAD];
    FILE *f = file_begin(path, fault);
    print_head(key, head);
    if (f) fputs(head, f);
    return f;
}

/* Gives the state at path, if there is one, the second name path.1. It is linked under a temporary
 * name first and then renamed, so that a program that is killed here leaves the old path.1 or the
 * new one, never none. */
static bool keep_before(const char *path)
{
    char target[PATH_MAX], before[PATH_MAX], part[PATH_MAX];
    file_target(path, target);
    path_before(path, before);
    snprintf(part, sizeof part, "%.4000s.%ld.tmp", before, (long)getpid());
    unlink(part);
    if (link(target, part) != 0) return errno == ENOENT;
    const bool kept = rename(part, before) == 0;
    const int error = errno;
    unlink(part); /* rename() does nothing where both names are one file already */
    errno = error;
    return kept;
}

int saved_commit(FILE *f, const char *path, Fault *fault)
{
    const long n = ftell(f);
    fflush(f);
    const unsigned long sum = sum_of(f, n);
    fseek(f, n, SEEK_SET);
    fprintf(f, "%08lx\n", sum);
    const bool written = fflush(f) == 0 && !ferror(f) && fsync(fileno(f)) == 0;
    if (!written || !keep_before(path)) {
        const int error = errno;
        file_abandon(f, path);
        return fault_set(fault, FAULT_MACHINE, "%s: %s", path, strerror(error ? error : EIO));
    }
    return file_commit(f, path, fault);
}

typedef enum { WHOLE, TORN, MISSING, FOREIGN } Found;

/* Is it whole, by its checksum? */
static Found check_sum(FILE *f)
{
    char text[SUM + 1] = "";
    if (fseek(f, 0, SEEK_END) != 0) return TORN;
    const long n = ftell(f) - SUM;
    if (n < (long)sizeof magic || fseek(f, n, SEEK_SET) != 0 || fread(text, 1, SUM, f) != SUM)
        return TORN;
    return text[SUM - 1] == '\n' && strtoul(text, NULL, 16) == sum_of(f, n) ? WHOLE : TORN;
}

/* Opens path if it is a complete state; its head, which names the run, is copied to `head`. */
static Found look(const char *path, const SavedKey *key, FILE **out, char head[HEAD])
{
    char ours[HEAD];
    FILE *f = fopen(path, "r");
    Found found = f ? check_sum(f) : MISSING;
    print_head(key, ours);
    head[0] = '\0';
    if (found == WHOLE) {
        rewind(f);
        char line[sizeof magic] = "";
        const size_t start = strlen(magic);
        if (!fgets(line, sizeof line, f) || strcmp(line, magic) || !fgets(head, HEAD, f))
            head[0] = 0;
        if (strcmp(head, ours + start) != 0) found = FOREIGN;
    }
    if (f && found != WHOLE) fclose(f);
    *out = found == WHOLE ? f : NULL;
    head[strcspn(head, "\n")] = '\0';
    return found;
}

static int refuse_foreign(const char *path, const SavedKey *key, const char *head, Fault *fault)
{
    char *command = NULL;
    const unsigned long program = strtoul(head, &command, 16);
    if (!*head)
        return fault_set(fault, FAULT_USAGE, "--resume: got '%s', which is no checkpoint", path);
    if (program != key->program)
        return fault_set(fault, FAULT_USAGE,
                         "--resume: got '%s', a checkpoint by another build of the program", path);
    return fault_set(fault, FAULT_USAGE, "--resume: got '%s', a checkpoint of another run:%s", path,
                     command);
}

FILE *saved_open(const char *path, const SavedKey *key, char chosen[PATH_MAX], Fault *fault)
{
    static const char *const words[] = {"whole", "no whole checkpoint", "missing", "foreign"};
    char before[PATH_MAX], head[HEAD];
    FILE *f;
    path_before(path, before);
    const Found found = look(path, key, &f, head);
    if (chosen) snprintf(chosen, PATH_MAX, "%.4000s", found == WHOLE ? path : before);
    if (found == WHOLE) return f;
    if (found == FOREIGN) {
        refuse_foreign(path, key, head, fault);
        return NULL;
    }
    const Found second = look(before, key, &f, head);
    if (second == WHOLE) return f;
    if (second == FOREIGN)
        refuse_foreign(before, key, head, fault);
    else
        fault_set(fault, FAULT_USAGE, "--resume: got '%s', which is %s, and %s is %s", path,
                  words[found], before, words[second]);
    return NULL;
}
