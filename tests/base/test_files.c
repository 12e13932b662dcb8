/* test_files.c: what is on disk: tables, whole files, journals with torn and damaged records. */
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "common/base/table.h"
#include "studies/engine/journal.h"
#include "tests/check.h"

/* A path in a folder of our own below the build folder (the working folder of the tests). */
static const char *scratch(const char *name)
{
    static char path[128];
    mkdir("scratch", 0777);
    snprintf(path, sizeof path, "scratch/%s.%d", name, (int)getpid());
    unlink(path);
    return path;
}

static void put_file(const char *path, const char *text)
{
    FILE *f = fopen(path, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    fputs(text, f);
    CU_ASSERT(fclose(f) == 0);
}

static void test_csv_round_trip(void)
{
    static const char *const cells[] = {"plain", "a,b", "say \"hi\"", "two\nlines", "", "\""};
    const char *path = scratch("csv");
    Fault f;
    FILE *out = file_begin(path, &f);
    CU_ASSERT_PTR_NOT_NULL_FATAL(out);
    fputs("number,text\n", out);
    for (int k = 0; k < 6; k++) {
        fprintf(out, "%d,", k);
        table_put_cell(out, cells[k]);
        putc('\n', out);
    }
    CU_ASSERT(file_commit(out, path, &f) == 0);
    Table *t = table_read(path, &f);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    CU_ASSERT(t->ncol == 2 && t->nrow == 6);
    for (int k = 0; k < t->nrow; k++) {
        CHECK_TEXT(table_text(t, k, "text"), cells[k]);
        CU_ASSERT(table_number(t, k, "number") == k);
    }
    CU_ASSERT(isnan(table_number(t, 0, "text")) && isnan(table_number(t, 0, "absent")));
    CU_ASSERT(table_column(t, "absent") == -1);
    table_free(t);
    unlink(path);
}

static void test_csv_damaged(void)
{
    static const char *const wrong[] = {
        "", "\n1\n", "a,b\n1\n", "a,b\n1,2,3\n", "a,b\n1,\"2\n", "a,b\n1,\"2\"3\n", "a\n1\n2,3\n"};
    const char *path = scratch("damaged");
    Fault f;
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        put_file(path, wrong[k]);
        Table *t = table_read(path, &f);
        CU_ASSERT(k == 1 ? t != NULL : t == NULL && f.code == FAULT_MACHINE);
        table_free(t);
    }
    put_file(path, "a,b\r\n1,2\r\n3,4"); /* foreign line ends, and none at the last */
    Table *t = table_read(path, &f);
    CU_ASSERT(t && t->nrow == 2 && table_number(t, 1, "b") == 4);
    table_free(t);
    unlink(path);
    CU_ASSERT_PTR_NULL(table_read(path, &f));
}

static void put_whole(const char *path, const char *text)
{
    FILE *out = file_begin(path, NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(out);
    fputs(text, out);
    CU_ASSERT(file_commit(out, path, NULL) == 0);
}

static void test_file_commit(void)
{
    char path[128];
    struct stat before, after;
    Fault f;
    snprintf(path, sizeof path, "%s", scratch("whole"));
    put_file(path, "old");
    CU_ASSERT(stat(path, &before) == 0);
    FILE *out = file_begin(path, &f);
    CU_ASSERT_PTR_NOT_NULL_FATAL(out);
    fputs("new", out);
    fflush(out);
    CU_ASSERT(stat(path, &after) == 0 && after.st_size == 3 && after.st_ino == before.st_ino);
    file_abandon(out, path);
    put_whole(path, "old");
    CU_ASSERT(stat(path, &after) == 0 && after.st_ino == before.st_ino); /* same bytes: kept */
    put_whole(path, "newer");
    CU_ASSERT(stat(path, &after) == 0 && after.st_size == 5);
    unlink(path);
    CU_ASSERT(file_check(path, &f) == 0 && file_check("no-such-file-yet", &f) == 0);
    CU_ASSERT(file_check("/nowhere/at/all", &f) == FAULT_MACHINE);
    CU_ASSERT(file_check(".", &f) == FAULT_MACHINE && strstr(f.text, "directory"));
    char name[300];
    memset(name, 'x',
           sizeof name); /* files of 250 letters may be, but not while they are written */
    name[250] = '\0';
    CU_ASSERT(file_check(name, &f) == FAULT_MACHINE && strstr(f.text, "too long"));
    name[200] = '\0';
    CU_ASSERT(file_check(name, &f) == 0 && access(name, F_OK) != 0);
    put_file(path, "a file");
    snprintf(name, sizeof name, "%s/below", path);
    CU_ASSERT(file_check(name, &f) == FAULT_MACHINE && file_check(path, &f) == 0);
    unlink(path);
    CU_ASSERT_PTR_NULL(file_begin("/nowhere/at/all", &f));
    CU_ASSERT(f.code == FAULT_MACHINE && strstr(f.text, "/nowhere/at/all"));
}

/* Never renamed over: as root that would take /dev/null away. */
static void test_file_special(void)
{
    const char *path = scratch("pipe");
    char text[8] = "";
    struct stat s;
    CU_ASSERT_FATAL(mkfifo(path, 0666) == 0);
    int reader = open(path, O_RDONLY | O_NONBLOCK);
    FILE *out = file_begin(path, NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(out);
    fputs("whole", out);
    CU_ASSERT(file_commit(out, path, NULL) == 0);
    CU_ASSERT(stat(path, &s) == 0 && S_ISFIFO(s.st_mode));
    CU_ASSERT(read(reader, text, sizeof text) == 5);
    CHECK_TEXT(text, "whole");
    close(reader);
    unlink(path);
}

/* A link stays one, whether its target exists or not; a file keeps its mode. */
static void test_file_links(void)
{
    static const char *const links[] = {"scratch/first", "scratch/second"};
    static const char real[] = "scratch/real", *const texts[] = {"new", "another"};
    struct stat s;
    mkdir("scratch", 0777);
    unlink(real), unlink(links[0]), unlink(links[1]);
    CU_ASSERT_FATAL(symlink("second", links[0]) == 0 && symlink("real", links[1]) == 0);
    for (int k = 0; k < 4; k++) {
        CU_ASSERT(file_check(links[k / 2], NULL) == 0);
        put_whole(links[k / 2], texts[k % 2]);
        CU_ASSERT(lstat(links[k / 2], &s) == 0 && S_ISLNK(s.st_mode));
        CU_ASSERT(lstat(real, &s) == 0 && S_ISREG(s.st_mode));
        CU_ASSERT((size_t)s.st_size == strlen(texts[k % 2]));
        if (k == 2) CU_ASSERT_FATAL(chmod(real, 0600) == 0);
    }
    CU_ASSERT((s.st_mode & 0777) == 0600);
    unlink(real), unlink(links[0]), unlink(links[1]);
}

static void test_order_fit(void)
{
    double x[9], y[9], err;
    for (int k = 0; k < 9; k++) {
        x[k] = k + 1;
        y[k] = 3 * pow(x[k], -2.5);
    }
    CHECK_CLOSE(table_order_fit(9, x, y, &err), -2.5, 1e-12);
    CU_ASSERT(err < 1e-6);
    y[3] = NAN;
    y[4] = 0;
    x[5] = -1;
    CHECK_CLOSE(table_order_fit(9, x, y, NULL), -2.5, 1e-12);
    CU_ASSERT(isnan(table_order_fit(1, x, y, NULL)) && isnan(table_order_fit(0, x, y, NULL)));
}

static void journal_of(const char *path, int n)
{
    Journal j;
    CU_ASSERT_FATAL(journal_open(&j, path, NULL) == 0);
    for (int k = 0; k < n; k++) {
        char key[32], row[32];
        snprintf(key, sizeof key, "key %d", k);
        snprintf(row, sizeof row, "row,%d", k);
        CU_ASSERT(journal_append(j.fd, key, row) == 0);
    }
    journal_close(&j);
}

static void test_journal(void)
{
    const char *path = scratch("journal");
    Journal j;
    journal_of(path, 5);
    CU_ASSERT_FATAL(journal_open(&j, path, NULL) == 0);
    CU_ASSERT(j.n == 5);
    CHECK_TEXT(journal_row(&j, "key 3"), "row,3");
    CU_ASSERT_PTR_NULL(journal_row(&j, "key"));
    CU_ASSERT(journal_append(j.fd, "key 3", "row,again") == 0);
    CU_ASSERT(journal_reload(&j, path, NULL) == 0 && j.n == 5); /* none doubled, the newest kept */
    CHECK_TEXT(journal_row(&j, "key 3"), "row,again");
    CU_ASSERT(journal_append(j.fd, "--cfl 0.29999999999999999 1f", "row,old") == 0);
    CU_ASSERT(journal_reload(&j, path, NULL) == 0);
    CHECK_TEXT(journal_row(&j, "--cfl 0.3 1f"), "row,old");
    CU_ASSERT_PTR_NULL(journal_row(&j, "--cfl 0.31 1f"));
    CU_ASSERT(journal_append(j.fd, "--cfl 3e-1 1f", "row,new") == 0);
    CU_ASSERT(journal_reload(&j, path, NULL) == 0 && j.n == 6);
    CHECK_TEXT(journal_row(&j, "--cfl 0.3 1f"), "row,new");
    journal_close(&j);
    unlink(path);
}

/* Cuts the tail at every byte: the whole records before it stay, and the next one does not glue. */
static void test_journal_torn_tail(void)
{
    const char *path = scratch("torn");
    Journal j;
    struct stat s;
    journal_of(path, 3);
    CU_ASSERT_FATAL(stat(path, &s) == 0);
    const off_t record = s.st_size / 3;
    for (off_t cut = 1; cut < record; cut++) {
        journal_of(path, 3);
        CU_ASSERT(truncate(path, s.st_size - cut) == 0);
        CU_ASSERT_FATAL(journal_open(&j, path, NULL) == 0);
        CU_ASSERT(j.n == 2 && journal_row(&j, "key 1") && !journal_row(&j, "key 2"));
        CU_ASSERT(journal_append(j.fd, "key 2", "row,2") == 0);
        CU_ASSERT(journal_reload(&j, path, NULL) == 0 && j.n == 3);
        journal_close(&j);
        unlink(path);
    }
}

/* Any byte of the middle record damaged or lost: only that record goes. */
static void test_journal_torn_middle(void)
{
    const char *path = scratch("middle");
    char text[256] = "";
    Journal j;
    journal_of(path, 3);
    FILE *f = fopen(path, "r");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    const size_t n = fread(text, 1, sizeof text - 1, f), record = n / 3;
    fclose(f);
    for (size_t at = record; at < 2 * record; at++)
        for (int lost = 0; lost < 2; lost++) {
            char damaged[256];
            memcpy(damaged, text, sizeof damaged);
            damaged[at] = '~';
            if (lost) memmove(damaged + at, text + at + 1, n - at);
            put_file(path, damaged);
            CU_ASSERT_FATAL(journal_open(&j, path, NULL) == 0);
            CU_ASSERT(j.n == 2 && journal_row(&j, "key 0") && journal_row(&j, "key 2"));
            journal_close(&j);
        }
    unlink(path);
}

/* A journal that five programs wrote into, two rows each. */
static void test_journal_compact(void)
{
    const char *path = scratch("compact");
    struct stat before, after;
    char key[32], row[32];
    Journal j;
    CU_ASSERT_FATAL(journal_open(&j, path, NULL) == 0);
    for (int k = 0; k < 15; k++) {
        snprintf(key, sizeof key, "run %d 0000000%d", k % 2, k / 3);
        snprintf(row, sizeof row, "row,%d", k);
        CU_ASSERT(journal_append(j.fd, key, row) == 0);
    }
    CU_ASSERT(journal_reload(&j, path, NULL) == 0 && j.n == 10);
    CU_ASSERT(fstat(j.fd, &before) == 0);
    CU_ASSERT(journal_compact(&j, path, "00000001", NULL) == 0);
    CU_ASSERT(fstat(j.fd, &after) == 0 && after.st_size < before.st_size);
    CU_ASSERT(j.n == 8); /* ours and the newest three: program 0 is gone, the doubled rows, too */
    CU_ASSERT(!journal_row(&j, "run 0 00000000") && journal_row(&j, "run 1 00000001"));
    CHECK_TEXT(journal_row(&j, "run 0 00000004"), "row,14");
    CU_ASSERT(journal_append(j.fd, "new", "row") == 0);
    CU_ASSERT(journal_compact(&j, path, "00000001", NULL) == 0);
    journal_close(&j);
    CU_ASSERT(journal_open(&j, path, NULL) == 0 && j.n == 7); /* "new" is a program of its own */
    journal_close(&j);
    unlink(path);
}

static const TestCase tests[] = {
    {"CSV round trip", test_csv_round_trip},
    {"CSV damaged", test_csv_damaged},
    {"files appear whole", test_file_commit},
    {"devices and pipes are written directly", test_file_special},
    {"files behind links", test_file_links},
    {"order fit", test_order_fit},
    {"journal", test_journal},
    {"journal with a torn tail", test_journal_torn_tail},
    {"journal torn in the middle", test_journal_torn_middle},
    {"journal loses the rows of old programs", test_journal_compact},
    {NULL, NULL},
};
CHECK_SUITE(tests)
