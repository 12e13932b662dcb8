/* test_squeeze.c: the cases that the pages of W07's squeeze test share. */
#include <string.h>
#include "studies/engine/cases.h"
#include "studies/runs/engines.h"
#include "studies/w07/squeeze.h"
#include "tests/check.h"

static void squeezes(Cases *list, bool quick)
{
    squeeze_add(list, "gimp", "quadratic", 20, 5, quick);
}

/* 10 to 200 particles, 5 or 125 apart. */
static void test_squeezes(void)
{
    const Study page = {.name = "squeezes", .page = &(StudyPage){.cases = squeezes}};
    Cases list;
    CU_ASSERT_FATAL(cases_build(&list, &page, false, NULL, "scratch", NULL) == 0);
    CU_ASSERT(list.n == 39);
    for (int k = 0; k < list.n; k++) {
        CHECK_CLOSE(list.list[k].spec.ppc, (10 + 5 * k) / 20.0, 1e-15);
        const RunSpec *spec = &list.list[k].spec;
        CU_ASSERT(!strcmp(spec_get(spec, "field"), "quadratic") && !strcmp(spec->method, "gimp"));
    }
    cases_free(&list);
    CU_ASSERT(study_case_count(&page, true) == 2);
    CU_ASSERT(engine_method("gimp") && engine_method("fem") && !engine_method("gmp"));
}

static const TestCase tests[] = {
    {"cases", test_squeezes},
    {NULL, NULL},
};
CHECK_SUITE(tests)
