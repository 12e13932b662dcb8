/* test_fuzz_corpus.c: inputs that the fuzzers once found or start from (tests/fuzz/found). */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include "tests/check.h"
#include "fuzz.h"

typedef const char *(*Property)(const unsigned char *data, size_t n);

/* FOUND is the folder, an absolute path. */
static void replay(const char *name, Property holds)
{
    char path[4096];
    int files = 0;
    snprintf(path, sizeof path, "%s/%s", FOUND, name);
    DIR *d = opendir(path);
    for (struct dirent *e; d && (e = readdir(d));) {
        size_t n;
        if (e->d_name[0] == '.') continue;
        snprintf(path, sizeof path, "%s/%s/%.255s", FOUND, name, e->d_name);
        char *data = fuzz_read(path, &n);
        const char *wrong = holds((const unsigned char *)data, n);
        if (wrong) printf("%s: %s\n", path, wrong);
        CU_ASSERT_PTR_NULL(wrong);
        free(data);
        files++;
    }
    if (d) closedir(d);
    CU_ASSERT(files > 0);
}

static void test_run(void)
{
    replay("run", fuzz_run);
}

static void test_set(void)
{
    replay("set", fuzz_set);
}

static void test_case(void)
{
    replay("case", fuzz_case);
}

static void test_journal(void)
{
    replay("journal", fuzz_journal);
}

static void test_table(void)
{
    replay("table", fuzz_table);
}

static void test_append(void)
{
    replay("append", fuzz_append);
}

static void test_sweep(void)
{
    replay("sweep", fuzz_sweep);
}

static const TestCase tests[] = {
    {"arguments", test_run},    {"settings", test_set}, {"runs", test_case},
    {"journals", test_journal}, {"tables", test_table}, {"appended rows", test_append},
    {"sweeps", test_sweep},     {NULL, NULL},
};
CHECK_SUITE(tests)
