/* statements_part.c: what each paper says, sentence by sentence, with the claims that test it; and
 * a card per problem: what moves, exactly how, and what its errors are divided by. */
#include <string.h>
#include "studies/runs/engines.h"
#include "studies/select.h"
#include "studies/statements.h"
#include "parts.h"

static const Claim *claim_named(const Page *page, const char *id)
{
    for (const Claim *c = page->claims->list; c < page->claims->list + page->claims->n; c++)
        if (strcmp(c->id, id) == 0) return c;
    return NULL;
}

/* A link to the claim's row, in the colour of its verdict. */
void page_claim_link(FILE *f, const Claim *c)
{
    const char *verdict = claim_verdict_name(c->verdict);
    fprintf(f, "<a class=\"v %s\" href=\"#c-%s\"", verdict, c->id);
    page_element(f, " title=\"", c->statement, "\">");
    fprintf(f, "%s</a> <span class=\"soft\">%s</span>", c->id, verdict);
}

static void put_claims(const Page *page, const Statement *s)
{
    EACH_WORD(w, s->claims) {
        const Claim *c = claim_named(page, w);
        fputs("<div>", page->f);
        if (c)
            page_claim_link(page->f, c);
        else
            page_element(page->f, "<span class=\"soft\">", w, " not run</span>");
        fputs("</div>", page->f);
    }
    if (*s->why) page_element(page->f, "<span class=\"soft\">no claim: ", s->why, "</span>");
}

/* Of a sentence: PASS if all its claims do, else the first other verdict; NOT_RUN if one is not
 * there. */
static Verdict verdict_of(const Page *page, const Statement *s)
{
    Verdict verdict = PASS;
    EACH_WORD(w, s->claims) {
        const Claim *c = claim_named(page, w);
        if (verdict == PASS) verdict = c ? c->verdict : NOT_RUN;
    }
    return verdict;
}

void page_sentences(const Page *page, const char *paper)
{
    int n = 0, tested = 0, of[NOT_RUN + 1] = {0};
    for (const Statement *s = statements; s->paper; s++) {
        if (strcmp(s->paper, paper) != 0 || !statement_is_published(s)) continue;
        n++;
        if (!*s->claims) continue;
        tested++;
        of[verdict_of(page, s)]++;
    }
    if (n == 0) return;
    fprintf(page->f,
            " Of %d sentences that can be measured, claims test %d, here or on pages of our own: "
            "<span class=\"v PASS\">%d hold</span>, <span class=\"v DIFFERS\">%d differ</span> in "
            "some claim, <span class=\"v FAIL\">%d fail</span>",
            n, tested, of[PASS], of[DIFFERS], of[FAIL]);
    if (of[NOT_RUN]) fprintf(page->f, ", <span class=\"v NOT_RUN\">%d not run</span>", of[NOT_RUN]);
    fputs(".", page->f);
}

void page_statements(const Page *page)
{
    const char *last = "";
    for (const Statement *s = statements; s->paper; s++) {
        if (!statement_is_published(s)) continue;
        if (strcmp(s->paper, last) != 0) {
            if (*last) fputs("</tbody></table></details>\n", page->f);
            page_element(page->f, "<details open><summary>", s->paper,
                         ": every sentence that can be measured, in our words</summary>\n<table "
                         "class=\"stack sort\"><thead><tr><th>where</th><th>the paper says</th>"
                         "<th>claims</th></tr></thead><tbody>\n");
        }
        last = s->paper;
        page_element(page->f, "<tr><td>", s->place, "</td>");
        page_element(page->f, "<td>", s->text, "</td><td>");
        put_claims(page, s);
        fputs("</td></tr>\n", page->f);
    }
    if (*last) fputs("</tbody></table></details>\n", page->f);
}

/* The study whose picture shows a problem; the browser copies it from its card. */
static const char *picture_of(const char *problem)
{
    static const char *const shown[][2] = {{"squeeze", "w07_04_squeeze"},
                                           {"bar", "w07_11_bar_history"},
                                           {"sine_bar", "w07_13_sine_bar"},
                                           {"plate_vibration", "w07_14_plate_positions"},
                                           {"ring", "w11_05_ring_stress"},
                                           {"disk_impact", "w11_07_disk_strain"},
                                           {"hole_plate", "w11_09_plate_stress"},
                                           {"cantilever", "h_04_locking"},
                                           {"vortex", "h_15_large_deformation"},
                                           {"hanging_bar", "h_15_large_deformation"},
                                           {"free_block", "h_08_spin"},
                                           {"block", "h_02_ringing"},
                                           {"patch", "h_10_edges"},
                                           {"axis_mms", "t_06_norms"}};
    for (size_t k = 0; k < sizeof shown / sizeof *shown; k++)
        if (strcmp(problem, shown[k][0]) == 0) return shown[k][1];
    return NULL;
}

void page_problems(const Page *page)
{
    const char *names[64];
    const int n = engine_problem_names(names, 64);
    fputs("<div class=\"grid\">\n", page->f);
    for (int k = 0; k < n; k++) {
        const Info *p = engine_problem(names[k]);
        const char *study = picture_of(names[k]);
        page_element(page->f, "<div class=\"card\"><h3>", p->name, "</h3>\n");
        page_element(page->f, "<p>", p->about, "</p>\n");
        if (study) fprintf(page->f, "<a data-from=\"%s\"></a>\n", study);
        fputs("<dl>", page->f);
        page_element(page->f, "<dt>exact</dt><dd>", p->formula ? p->formula : "none", "</dd>");
        page_element(page->f, "<dt>errors over</dt><dd>", p->scale ? p->scale : "none", "</dd>");
        page_element(page->f, "<dt>source</dt><dd>", p->source && *p->source ? p->source : "own",
                     "</dd></dl>");
        fputs("</div>\n", page->f);
    }
    fputs("</div>\n", page->f);
}
