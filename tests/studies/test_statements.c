/* test_statements.c: every claim on a page of a paper tests one sentence of it or is said to be
 * our own; every sentence has a claim or a reason; claims can be read alone, and can fail. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "studies/engine/claims.h"
#include "studies/statements.h"
#include "tests/check.h"

/* The claims of all studies, judged on tables that are not there. */
static void all_claims(Check *c)
{
    Fault f = {0};
    char dir[] = "/tmp/statementsXXXXXX";
    CU_ASSERT_PTR_NOT_NULL_FATAL(mkdtemp(dir));
    for (const Study *s = studies; s->name; s++)
        if (s->page->check) {
            const int before = c->n;
            claims_judge_study(c, s, dir, &f); /* says that there is no table */
            if (c->n - before != s->page->claims)
                printf("%s: %d claims, declares %d\n", s->name, c->n - before, s->page->claims);
            CU_ASSERT_EQUAL(c->n - before, s->page->claims);
        }
    rmdir(dir);
}

static void fault_if(bool wrong, const char *what, const char *which)
{
    if (wrong) printf("%s: %s\n", what, which);
    CU_ASSERT(!wrong);
}

/* How many lines name this id. */
static int lines_of(const char *id)
{
    int n = 0;
    for (const Statement *s = statements; s->paper; s++) {
        char ids[1024], *rest = NULL;
        snprintf(ids, sizeof ids, "%s", s->claims);
        for (char *w = strtok_r(ids, " ", &rest); w; w = strtok_r(NULL, " ", &rest))
            n += strcmp(w, id) == 0;
    }
    return n;
}

static bool is_made(const Check *c, const char *id)
{
    for (int k = 0; k < c->n; k++)
        if (strcmp(c->list[k].id, id) == 0) return true;
    return false;
}

/* The ids of all lines are claims of this program. */
static void check_ids(const Check *c)
{
    for (const Statement *s = statements; s->paper; s++) {
        char ids[1024], *rest = NULL;
        fault_if(!*s->claims == !*s->why && statement_is_published(s), "either claims or a reason",
                 s->text);
        snprintf(ids, sizeof ids, "%s", s->claims);
        for (char *w = strtok_r(ids, " ", &rest); w; w = strtok_r(NULL, " ", &rest)) {
            fault_if(!is_made(c, w), "no claim", w);
            fault_if(lines_of(w) != 1, "in several lines", w);
        }
    }
}

static void test_sentences(void)
{
    Check c = {0};
    all_claims(&c);
    for (int k = 0; k < c.n; k++) {
        const bool paper =
            strncmp(c.list[k].id, "W07-", 4) == 0 || strncmp(c.list[k].id, "W11-", 4) == 0;
        const Statement *s = statement_of_claim(c.list[k].id);
        fault_if(paper && !s, "neither a sentence nor our own", c.list[k].id);
        fault_if(paper && s && strncmp(c.list[k].id, s->paper, 3) != 0, "another paper's line",
                 c.list[k].id);
        const bool published = s && statement_is_published(s) && paper;
        fault_if(published != (*claim_group(&c.list[k]) == 'W'), "group", c.list[k].id);
        for (int i = 0; i < k; i++)
            fault_if(strcmp(c.list[i].id, c.list[k].id) == 0, "two claims of one id", c.list[k].id);
    }
    check_ids(&c);
    CU_ASSERT_PTR_NULL(statement_of_claim("W07-5.mpm"));
    free(c.list);
}

/* Statements are read out of order. */
static void test_alone(void)
{
    static const char *const openings[] = {"and ",   "nor ", "which ", "but ",     "the same",
                                           "it is ", "it\t", "so ",    "with musl"};
    Check c = {0};
    all_claims(&c);
    for (int k = 0; k < c.n; k++)
        for (size_t w = 0; w < sizeof openings / sizeof *openings; w++) {
            const size_t n = strlen(openings[w]);
            fault_if(strncasecmp(c.list[k].statement, openings[w], n) == 0, "cannot be read alone",
                     c.list[k].statement);
        }
    for (int k = 0; k < c.n; k++) {
        fault_if(strstr(c.list[k].statement, ": the same") != NULL, "cannot be read alone",
                 c.list[k].statement);
        fault_if(islower(c.list[k].statement[0]), "begins with a small letter",
                 c.list[k].statement);
    }
    free(c.list);
}

static const TestCase tests[] = {
    {"a sentence for every claim of a paper", test_sentences},
    {"claims that can be read alone", test_alone},
    {NULL, NULL},
};
CHECK_SUITE(tests)
