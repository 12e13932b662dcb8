/* test_select.c: rows chosen by columns and settings, and names that no table has. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "studies/engine/palette.h"
#include "studies/select.h"
#include "tests/check.h"

static Table *runs(void)
{
    return check_table("method,cells,steps,params,status,e\n"
                       "gimp,40,7,A=0.01;nu=0.3,ok,1\n"
                       "mpm,40,7,A=0.01;nu=0.45,ok,2\n"
                       "gimp,4e1,1,A=0.1;domain=stretch;nu=0.3;steps=1,energy_growth,3\n"
                       "gimp,80,5,A=0.1;nu=.45,inverted,4\n");
}

static void test_columns(void)
{
    double out[4];
    Table *t = runs();
    CU_ASSERT(select_all(t, "e", 4, out, "method=%s cells=40", "gimp") == 2);
    CU_ASSERT(out[0] == 1 && out[1] == 3);
    CU_ASSERT(select_all(t, "e", 1, out, "method=gimp") == 1 &&
              select_all(t, "e", 4, out, " ") == 4);
    CU_ASSERT(isnan(out[3]) && select_next(t, 0, "cells=40") == 1 && select_next(t, 3, " ") == -1);
    CU_ASSERT(select_value(t, "e", "cells=80").rows == 0 &&
              select_value(t, "e", "cells=9").rows == 0);
    CU_ASSERT(select_ended(t, "e", "cells=80").value == 4 &&
              select_ended(t, "e", "cells=80").rows == 1);
    CU_ASSERT(select_count_lost(t, 3, "method=gimp").value == 1);
    CU_ASSERT(select_is(t, 1, "method", "mpm") && !select_is(t, 1, "method", "mp"));
    table_free(t);
}

/* Settings stand in any order; one that a row does not spell out has its default. */
static void test_settings(void)
{
    Table *t = runs();
    CU_ASSERT(select_next(t, -1, "nu=0.45 A=0.01") == 1 && select_next(t, -1, "A=.1 nu=0.45") == 3);
    CU_ASSERT(select_next(t, -1, "domain=stretch") == 2 && select_next(t, 0, "domain=fxx") == 1);
    CU_ASSERT(select_next(t, -1, "set.steps=1") == 2 && select_next(t, -1, "steps=5") == 3);
    CU_ASSERT(select_number(t, 1, "nu") == 0.45 && select_number(t, 2, "set.steps") == 1);
    CU_ASSERT(select_number(t, 0, "set.steps") == 0 && isnan(select_number(t, 2, "domain")));
    CU_ASSERT(select_next(t, -1, "field=linear") == -1); /* a setting of other problems */
    table_free(t);
}

/* What a child that does this prints on standard error; it must exit with status 1. */
static void check_fault(const Table *t, const char *name, const char *where, const char *near)
{
    char text[512] = "", nearest[64];
    int ends[2], status = 0;
    fflush(NULL);
    CU_ASSERT_FATAL(pipe(ends) == 0);
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        select_begin("a_page");
        _exit(isnan(select_value(t, name, "%s", where).value) ? 2 : 3);
    }
    close(ends[1]);
    const ssize_t n = read(ends[0], text, sizeof text - 1);
    close(ends[0]);
    CU_ASSERT(waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 1);
    snprintf(nearest, sizeof nearest, "did you mean '%s'?", near);
    CU_ASSERT(n > 0 && strstr(text, "mpmlab: a_page: ") && strstr(text, nearest));
    if (!strstr(text, nearest)) printf("%s, %s: got %s\n", name, where, text);
}

static void test_unknown(void)
{
    Table *t = runs(), *plain = check_table("method,error\ngimp,1\n");
    check_fault(t, "e", "metod=gimp", "method");
    check_fault(t, "statis", "method=gimp", "status");
    check_fault(t, "e", "method=nobody arangement=centred", "arrangement");
    check_fault(t, "e", "method", "method");
    check_fault(plain, "error", "nu=0.3", "error"); /* no table of runs */
    const int rows = t->nrow;
    t->nrow = 0;
    check_fault(t, "e", "colour=red", "cells");
    t->nrow = rows; /* to free them */
    table_free(plain);
    table_free(t);
}

static void test_words(void)
{
    const char *rest = " gimp  wls";
    CHECK_TEXT(select_word(&rest), "gimp");
    CHECK_TEXT(select_word(&rest), "wls");
    CU_ASSERT_PTR_NULL(select_word(&rest));
}

/* Every method has a colour of its own, however many there will be. */
static void test_colours(void)
{
    enum { MANY = 60 };
    char colour[MANY][8];
    for (int k = 0; k < MANY; k++) {
        palette_colour(k, colour[k]);
        CU_ASSERT(strlen(colour[k]) == 7 && palette_marker(k) > 0);
        for (int j = 0; j < k; j++) CU_ASSERT(strcmp(colour[j], colour[k]) != 0);
    }
    char settings[4096] = "";
    FILE *f = fmemopen(settings, sizeof settings, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    palette_put(f);
    fclose(f);
    CU_ASSERT_PTR_NOT_NULL(strstr(settings, "METHODS='mpm gimp ge_mpm"));
    CU_ASSERT_PTR_NOT_NULL(strstr(settings, "LABELS='MPM GIMP GE-MPM"));
    CU_ASSERT_PTR_NOT_NULL(strstr(settings, "COLOURS='#D55E00 "));
}

static const TestCase tests[] = {
    {"rows by columns", test_columns},
    {"rows by settings", test_settings},
    {"a name that no table has is a fault", test_unknown},
    {"words of a list", test_words},
    {"a colour per method", test_colours},
    {NULL, NULL},
};
CHECK_SUITE(tests)
