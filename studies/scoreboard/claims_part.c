/* claims_part.c: verdicts on the page: counts, what differs from the papers, the table. */
#include <math.h>
#include <string.h>
#include "studies/statements.h"
#include "parts.h"

/* Claims of a group ("": of all). */
static int count(const Page *page, const char *group, Verdict verdict)
{
    int n = 0;
    for (const Claim *c = page->claims->list; c < page->claims->list + page->claims->n; c++)
        n += c->verdict == verdict && (!*group || strcmp(claim_group(c), group) == 0);
    return n;
}

void page_counts(const Page *page)
{
    if (page->claims->n == 0) fputs("<p>A quick run: no verdicts.</p>\n", page->f);
    fputs("<p>", page->f);
    for (Verdict v = PASS; v <= NOT_RUN && page->claims->n; v++)
        fprintf(page->f, "%s<span class=\"v %s\">%d %s</span>", v ? " &middot; " : "",
                claim_verdict_name(v), count(page, "", v), claim_verdict_name(v));
    fputs("</p>\n", page->f);
}

static void paper(const Page *page, const char *prefix, const char *name)
{
    const int holds = count(page, prefix, PASS), differs = count(page, prefix, DIFFERS);
    const int fails = count(page, prefix, FAIL), not_run = count(page, prefix, NOT_RUN);
    fprintf(page->f, "<p><b>%s</b>: of %d claims <span class=\"v PASS\">%d hold</span>, ", name,
            holds + differs + fails + not_run, holds);
    fprintf(page->f,
            "<span class=\"v DIFFERS\">%d differ</span>, <span class=\"v FAIL\">%d fail"
            "</span>",
            differs, fails);
    if (not_run) fprintf(page->f, ", <span class=\"v NOT_RUN\">%d not run</span>", not_run);
    fputs(".", page->f);
    page_sentences(page, prefix);
    fputs("</p>\n", page->f);
}

void page_papers(const Page *page)
{
    FILE *f = page->f;
    paper(page, "W07", "W07, Wallstedt and Guilkey 2007");
    paper(page, "W11", "W11, Wallstedt and Guilkey 2011");
    paper(page, "own", "Our own methods, agreed values and findings (not sentences of a paper)");
    paper(page, "hard", "Hard cases (H-...)");
    if (count(page, "", DIFFERS) + count(page, "", FAIL) == 0) return;
    fputs("<details open><summary>What differs or fails, and why</summary>\n<ul>\n", f);
    for (const Claim *c = page->claims->list; c < page->claims->list + page->claims->n; c++) {
        if (c->verdict != DIFFERS && c->verdict != FAIL) continue;
        fprintf(f, "<li><span class=\"v %s\">%s</span> ", claim_verdict_name(c->verdict),
                claim_verdict_name(c->verdict));
        fprintf(f, "<a href=\"#%s\">%s</a> ", c->study->name, c->study->figure);
        page_text(f, c->statement);
        fprintf(f, ": %.4g. <span class=\"soft\">", c->measured);
        page_element(f, "", c->reason, "</span></li>\n");
    }
    fputs("</ul>\n</details>\n", f);
}

void page_verdicts(const Page *page)
{
    for (Verdict v = PASS; v <= NOT_RUN; v++)
        fprintf(page->f,
                "<button type=\"button\" class=\"%s\" data-verdict=\"%s\" aria-pressed=\"true\">"
                "%s %d</button>\n",
                claim_verdict_name(v), claim_verdict_name(v), claim_verdict_name(v),
                count(page, "", v));
}

void page_figure_names(const Page *page)
{
    const Study *last = NULL;
    for (const Claim *c = page->claims->list; c < page->claims->list + page->claims->n; c++) {
        if (c->study != last) fprintf(page->f, "<option>%s</option>\n", c->study->figure);
        last = c->study;
    }
}

/* For reading: four digits; the exact number is in claims.csv. */
static void number(FILE *f, double x)
{
    if (isnan(x))
        fputs("&ndash;", f);
    else
        fprintf(f, "%.4g", x);
}

static void put_claim(FILE *f, const Claim *c)
{
    const char *verdict = claim_verdict_name(c->verdict);
    const Statement *s = statement_of_claim(c->id);
    const bool published = s && statement_is_published(s);
    fprintf(f, "<tr id=\"c-%s\" data-verdict=\"%s\" data-figure=\"%s\"><td class=\"v %s\">%s</td>",
            c->id, verdict, c->study->figure, verdict, verdict);
    fprintf(f, "<td><a href=\"#%s\">", c->study->name);
    page_element(f, "", c->id, "</a>");
    page_element(f, "<br><span class=\"soft\">", published ? s->paper : claim_group(c), " ");
    page_element(f, "", published ? s->place : "", "</span></td>");
    page_element(f, "<td>", c->statement, "");
    if (published) page_element(f, "<br><i>", s->text, "</i>");
    if (c->reason[0]) page_element(f, "<br><span class=\"soft\">", c->reason, "</span>");
    fputs("</td><td class=\"n\" data-label=\"measured\">", f);
    number(f, c->measured);
    fputs("</td><td class=\"n\" data-label=\"expected\">", f);
    number(f, c->low);
    fputs(" to ", f);
    number(f, c->high);
    fputs("</td></tr>\n", f);
}

void page_claims(const Page *page)
{
    for (int k = 0; k < page->claims->n; k++) put_claim(page->f, &page->claims->list[k]);
}
