/* page.c: a static page that stands by itself: no script, no font, no style from elsewhere. */
#include "page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "../common/info.h"
#include "facts.h"
#include "memory.h"

static const char head[] =
    "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
    "<title>mpmlab: figures and claims</title>\n<style>\n"
    ":root{color-scheme:light dark;--paper:#fcfcfa;--ink:#1c1e21;--soft:#63676d;--line:#dcdcd6;"
    "--card:#fff;--pass:#00704f;--fail:#b3261e;--differs:#8a5300;--not:#63676d}\n"
    "@media(prefers-color-scheme:dark){:root{--paper:#15171a;--ink:#e6e6e3;--soft:#9ba0a6;"
    "--line:#33373c;--card:#1c1f23;--pass:#4fc79a;--fail:#ff8a80;--differs:#f0b45a;--not:#9ba0a6}}"
    "\n"
    "body{margin:0 auto;max-width:62rem;padding:2rem 1rem 4rem;background:var(--paper);"
    "color:var(--ink);font:1rem/1.5 system-ui,sans-serif}\n"
    "h1{font-size:1.6rem;margin:0}h2{font-size:1.15rem;margin:3rem 0 .25rem}p{margin:.25rem 0}\n"
    ".soft{color:var(--soft);font-size:.9rem}a{color:inherit}\n"
    ".wide{overflow-x:auto}table{border-collapse:collapse;width:100%;font-size:.9rem}\n"
    "th,td{text-align:left;vertical-align:top;padding:.35rem .75rem .35rem 0;"
    "border-bottom:1px solid var(--line)}th{font-weight:600;color:var(--soft)}\n"
    "td.n{white-space:nowrap;font-variant-numeric:tabular-nums}\n"
    ".v{font-weight:600;white-space:nowrap}.PASS{color:var(--pass)}.FAIL{color:var(--fail)}"
    ".DIFFERS{color:var(--differs)}.NOT_RUN{color:var(--not)}\n"
    "img{display:block;width:100%;max-width:45rem;margin:1rem 0;background:#fff;border-radius:6px;"
    "border:1px solid var(--line)}\n"
    "code{font:.85rem/1.4 ui-monospace,monospace;background:var(--card);padding:.15rem .4rem;"
    "border:1px solid var(--line);border-radius:4px;overflow-wrap:anywhere}\n"
    "</style>\n</head>\n<body>\n<h1>mpmlab</h1>\n";

static void escaped(FILE *f, const char *text)
{
    for (; *text; text++) {
        if (*text == '<')
            fputs("&lt;", f);
        else if (*text == '>')
            fputs("&gt;", f);
        else if (*text == '&')
            fputs("&amp;", f);
        else if (*text == '"')
            fputs("&quot;", f);
        else
            putc(*text, f);
    }
}

static void element(FILE *f, const char *open, const char *text, const char *close)
{
    fputs(open, f);
    escaped(f, text);
    fputs(close, f);
}

/* For reading: four digits; the exact number is in claims.csv. */
static void number(FILE *f, double x)
{
    if (isnan(x))
        fputs("&ndash;", f);
    else
        fprintf(f, "%.4g", x);
}

static void claim_row(FILE *f, const Claim *c)
{
    const char *verdict = verdict_name(c->verdict);
    fprintf(f, "<tr><td class=\"v %s\">%s</td>", verdict, verdict);
    element(f, "<td class=\"n\">", c->id, "</td>");
    element(f, "<td>", c->statement, "");
    if (c->reason[0]) element(f, "<br><span class=\"soft\">", c->reason, "</span>");
    fputs("</td><td class=\"n\">", f);
    number(f, c->measured);
    fputs("</td><td class=\"n\">", f);
    number(f, c->low);
    fputs(" to ", f);
    number(f, c->high);
    fputs("</td></tr>\n", f);
}

/* The claims of one study, or of all (study NULL). */
static void claim_table(FILE *f, const Check *claims, const Study *study)
{
    int rows = 0;
    for (int k = 0; k < claims->n; k++) {
        if (study && claims->list[k].study != study) continue;
        if (rows++ == 0)
            fputs(
                "<div class=\"wide\"><table>\n<tr><th>verdict</th><th>claim</th><th>statement</th>"
                "<th>measured</th><th>expected</th></tr>\n",
                f);
        claim_row(f, &claims->list[k]);
    }
    if (rows) fputs("</table></div>\n", f);
}

static void summary(FILE *f, const Check *claims)
{
    int count[4] = {0};
    for (int k = 0; k < claims->n; k++) count[claims->list[k].verdict]++;
    fputs("<p>", f);
    for (Verdict v = PASS; v <= NOT_RUN; v++)
        fprintf(f, "%s<span class=\"v %s\">%d %s</span>", v ? " &middot; " : "", verdict_name(v),
                count[v], verdict_name(v));
    element(f, "</p>\n<p class=\"soft\">", FACT_VERSION, " &middot; ");
    element(f, "", FACT_COMPILER, " &middot; ");
    element(f, "", FACT_FLAGS, "</p>\n");
}

static bool has(const char *dir, const char *name, const char *ending)
{
    char *path = text_of("%s/%s.%s", dir, name, ending);
    int there = access(path, R_OK) == 0;
    free(path);
    return there;
}

static void link_to(FILE *f, const char *dir, const char *name, const char *ending)
{
    if (has(dir, name, ending)) fprintf(f, "<a href=\"%s.%s\">%s</a> ", name, ending, ending);
}

static void figure(FILE *f, const Check *claims, const Study *s, const char *dir)
{
    fprintf(f, "<h2 id=\"%s\">", s->name);
    element(f, "", s->figure, "</h2>\n");
    element(f, "<p>", s->about, "</p>\n");
    if (has(dir, s->name, "svg")) {
        fprintf(f, "<img src=\"%s.svg\" loading=\"lazy\" alt=\"", s->name);
        element(f, "", s->about, "\">\n");
    }
    if (has(dir, s->name, "gif"))
        fprintf(f, "<img src=\"%s.gif\" loading=\"lazy\" alt=\"the same, moving\">\n", s->name);
    claim_table(f, claims, s);
    fputs("<p class=\"soft\">", f);
    link_to(f, dir, s->name, "csv");
    link_to(f, dir, s->name, "json");
    link_to(f, dir, s->name, "png");
    link_to(f, dir, s->name, "gif");
    fprintf(f, "<code>build/mpmlab study %s</code></p>\n", s->name);
}

int page_write(const Check *claims, const char *dir, Fault *fault)
{
    char *path = text_of("%s/index.html", dir);
    FILE *f = file_begin(path, fault);
    int code = FAULT_MACHINE;
    if (f) {
        fputs(head, f);
        summary(f, claims);
        claim_table(f, claims, NULL);
        for (const Study *const *s = studies; *s; s++)
            if (has(dir, (*s)->name, "csv")) figure(f, claims, *s, dir);
        fputs("</body>\n</html>\n", f);
        code = file_commit(f, path, fault);
    }
    free(path);
    return code;
}
