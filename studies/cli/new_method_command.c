/* new_method_command.c: `new-method`: the starting file of a method and its line in the registry,
 * in the source tree that this program was built from. */
#include <ctype.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>
#include "common/base/table.h"
#include "cli.h"
#include "studies/phrase.h"
#include "studies/runs/engines.h"

enum { LONGEST = 31 };

/* A name is part of a C symbol, of a file's name and of settings. */
static int check_name(const char *name, Fault *fault)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyz0123456789_";
    const size_t n = strlen(name);
    if (n > 0 && n <= LONGEST && islower((unsigned char)name[0]) && strspn(name, letters) == n)
        return 0;
    return option_refuse(fault, "NAME", name, "at most 31 of a-z, 0-9 and _, with a letter first",
                         NULL, 0);
}

/* The source tree's methods/ beside the program's build folder, or NULL. */
static const char *methods_folder(void)
{
    static const char *const places[] = {"../methods", "../../methods"};
    char self[PATH_MAX], found[PATH_MAX];
    const ssize_t n = readlink("/proc/self/exe", self, sizeof self - 1);
    if (n <= 0) return NULL;
    self[n] = '\0';
    *strrchr(self, '/') = '\0';
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        const char *list = phrase("%s/%s/methods.def", self, places[k]);
        if (access(list, R_OK) != 0 || !realpath(list, found)) continue;
        *strrchr(found, '/') = '\0';
        return phrase("%s", found);
    }
    return NULL;
}

static char *read_all(const char *path, Fault *fault)
{
    FILE *f = fopen(path, "r");
    char *text = NULL;
    size_t size = 0;
    if (!f || getdelim(&text, &size, '\0', f) < 0) {
        fault_machine(fault, path);
        free(text);
        text = NULL;
    }
    if (f) fclose(f);
    return text;
}

/* The template with NAME and LABEL filled in. */
static void write_filled(FILE *f, const char *text, const char *name)
{
    for (; *text; text++) {
        if (strncmp(text, "NAME", 4) == 0) {
            fputs(name, f);
            text += 3;
        } else if (strncmp(text, "LABEL", 5) == 0) {
            for (const char *c = name; *c; c++)
                putc(*c == '_' ? '-' : toupper((unsigned char)*c), f);
            text += 4;
        } else
            putc(*text, f);
    }
}

static int write_source(const char *folder, const char *path, const char *name, Fault *fault)
{
    char *text = read_all(phrase("%s/new_method.txt", folder), fault);
    FILE *f = text ? file_begin(path, fault) : NULL;
    if (f) write_filled(f, text, name);
    free(text);
    return f ? file_commit(f, path, fault) : FAULT_MACHINE;
}

static int write_line(const char *path, const char *name, Fault *fault)
{
    char *old = read_all(path, fault);
    FILE *f = old ? file_begin(path, fault) : NULL;
    if (f)
        fprintf(f, "%s%sMETHOD(%s)\n", old, *old && old[strlen(old) - 1] != '\n' ? "\n" : "", name);
    free(old);
    return f ? file_commit(f, path, fault) : FAULT_MACHINE;
}

/* Is there a line METHOD(name), or a file of that name? */
static int is_taken(const char *source, const char *list, const char *name)
{
    char *text = read_all(list, NULL);
    const int taken =
        access(source, F_OK) == 0 || (text && strstr(text, phrase("METHOD(%s)", name)));
    free(text);
    return taken;
}

static int add(const char *folder, const char *name, Fault *fault)
{
    const char *names[64];
    const char *source = phrase("%s/%s.c", folder, name), *list = phrase("%s/methods.def", folder);
    int known = 0, code;
    for (int k = engine_method_names(names, 64) - 1; k >= 0; k--)
        known |= strcmp(names[k], name) == 0;
    if (known || is_taken(source, list, name))
        code = option_refuse(fault, "NAME", name, "a name that no method has yet", NULL, 0);
    else if (!(code = write_source(folder, source, name, fault)) &&
             (code = write_line(list, name, fault)))
        unlink(source); /* both or none */
    if (!code) printf("%s\n%s\n", source, list);
    return code;
}

static int new_method(int argc, char **argv, Fault *fault)
{
    const char *name = NULL;
    int code = options_read(argc, argv, options_none, option_take_word, &name, fault);
    if (code || (code = check_name(name ? name : "", fault))) return code;
    const char *folder = methods_folder();
    if (!folder)
        return fault_set(fault, FAULT_MACHINE,
                         "new-method: no methods/methods.def beside the program's build folder");
    const int lock = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock >= 0) flock(lock, LOCK_EX); /* two at a time would lose a line */
    code = add(folder, name, fault);
    if (lock >= 0) close(lock);
    return code;
}

const Command new_method_command = {
    .name = "new-method",
    .usage = "NAME",
    .about = "starts a method: writes methods/NAME.c to be filled in and its registry line",
    .options = options_none,
    .run = new_method,
};
