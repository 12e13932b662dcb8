/* page.c: OUT/index.html from plots/page.html: every line there that is a marker (@NAME@) is
 * replaced by what its part writes. The page stands by itself: nothing in it is loaded. */
#include "page.h"

#include <string.h>
#include "facts.h"
#include "parts.h"
#include "studies/engine/plot.h"

void page_text(FILE *f, const char *text)
{
    static const char special[] = "<>&\"";
    static const char *const names[] = {"&lt;", "&gt;", "&amp;", "&quot;"};
    for (; *text; text++) {
        const char *s = strchr(special, *text);
        if (s)
            fputs(names[s - special], f);
        else
            putc(*text, f);
    }
}

void page_element(FILE *f, const char *open, const char *text, const char *close)
{
    fputs(open, f);
    page_text(f, text);
    fputs(close, f);
}

static void build_facts(const Page *page)
{
    page_element(page->f, "<p class=\"soft\">", FACT_VERSION, " &middot; ");
    page_element(page->f, "", FACT_COMPILER, " &middot; ");
    page_element(page->f, "", FACT_FLAGS, "</p>\n");
}

static const struct Part {
    const char *marker;
    void (*write)(const Page *page);
} parts[] = {
    {"@BUILD@\n", build_facts},          {"@COUNTS@\n", page_counts},
    {"@WHICH@\n", page_which},           {"@PAPERS@\n", page_papers},
    {"@VERDICTS@\n", page_verdicts},     {"@FIGURE_NAMES@\n", page_figure_names},
    {"@CLAIMS@\n", page_claims},         {"@FIGURES@\n", page_figures},
    {"@STABILITY@\n", page_stability},   {"@NEEDS@\n", page_needs},
    {"@STATEMENTS@\n", page_statements}, {"@PROBLEMS@\n", page_problems},
};

static void write_line(const Page *page, const char *line)
{
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        if (strcmp(line, parts[k].marker) == 0) {
            parts[k].write(page);
            return;
        }
    fputs(line, page->f);
}

static FILE *open_template(Fault *fault)
{
    const char *plots = plot_folder(), *path = phrase("%s/page.html", plots ? plots : "plots");
    FILE *f = fopen(path, "r");
    if (!f) fault_machine(fault, path);
    return f;
}

int page_write(const Check *claims, const char *dir, Fault *fault)
{
    const char *path = phrase("%s/index.html", dir);
    char line[1024];
    FILE *template = open_template(fault);
    Page page = {template ? file_begin(path, fault) : NULL, claims, dir};
    int code = FAULT_MACHINE;
    if (page.f) {
        while (fgets(line, sizeof line, template)) write_line(&page, line);
        code = file_commit(page.f, path, fault);
    }
    if (template) fclose(template);
    return code;
}
