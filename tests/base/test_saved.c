/* test_saved.c: states on disk: whole ones are found, torn and foreign ones are not used. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "common/base/saved.h"
#include "common/base/table.h"
#include "tests/check.h"

static const SavedKey key = {"run bar --cells 8", 7};
static const char path[] = "saved_state", before[] = "saved_state.1";

enum { BODY = 1000 };

/* Writes a state whose bytes are all `value`. */
static void save(char value, const SavedKey *own)
{
    char body[BODY];
    Fault fault = {0};
    FILE *f = saved_begin(path, own, &fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    memset(body, value, sizeof body);
    Stash s = {.f = f};
    stash_bytes(&s, body, sizeof body);
    CU_ASSERT(!s.bad);
    CU_ASSERT(saved_commit(f, path, &fault) == 0);
}

/* The value of the state that is found, or -1 and why not. */
static int found(const SavedKey *own, Fault *fault)
{
    char body[BODY];
    FILE *f = saved_open(path, own, NULL, fault);
    if (!f) return -1;
    Stash s = {.f = f, .load = true};
    stash_bytes(&s, body, sizeof body);
    fclose(f);
    CU_ASSERT(!s.bad);
    for (int k = 0; k < BODY; k++) CU_ASSERT(body[k] == body[0]);
    return body[0];
}

/* The newest; the one before it, if that is missing, cut off anywhere or has a byte changed. */
static void test_newest(void)
{
    Fault fault = {0};
    unlink(path), unlink(before);
    CU_ASSERT(found(&key, &fault) == -1 && fault.code == FAULT_USAGE);
    save(1, &key);
    CU_ASSERT(found(&key, &fault) == 1);
    save(2, &key);
    CU_ASSERT(found(&key, &fault) == 2);
    char text[2 * BODY];
    FILE *f = fopen(path, "r");
    const size_t n = fread(text, 1, sizeof text, f);
    fclose(f);
    for (size_t k = 0; k < n; k += 1 + k % 7) {
        const bool cut = k % 2;
        f = fopen(path, "w");
        text[k] ^= (char)!cut;
        fwrite(text, 1, cut ? k : n, f);
        text[k] ^= (char)!cut;
        fclose(f);
        CU_ASSERT(found(&key, &fault) == 1);
    }
    unlink(path);
    CU_ASSERT(found(&key, &fault) == 1);
}

static void test_foreign(void)
{
    Fault fault = {0};
    const SavedKey run = {"run bar --cells 80", 7}, program = {"run bar --cells 8", 8};
    unlink(path), unlink(before);
    save(1, &key);
    CU_ASSERT(found(&run, &fault) == -1 && strstr(fault.text, "another run: run bar --cells 8"));
    CU_ASSERT(found(&program, &fault) == -1 && strstr(fault.text, "another build"));
    save(2, &run);
    CU_ASSERT(found(&key, &fault) == -1); /* the newest is another run's: not the one before */
    Stash s = {.f = fopen(path, "r"), .load = true};
    CU_ASSERT(!stash_same(&s, 3) && s.bad);
    fclose(s.f);
}

static const TestCase tests[] = {
    {"the newest whole state", test_newest},
    {"states of another run or program", test_foreign},
    {NULL, NULL},
};
CHECK_SUITE(tests)
