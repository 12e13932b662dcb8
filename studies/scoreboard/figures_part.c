/* figures_part.c: one card per figure: picture, claims, origin of the numbers, and the command.
 * Pictures are embedded: the drawing itself, or its pixels where those are shorter. */
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "studies/phrase.h"
#include "studies/select.h"
#include "drawing.h"
#include "parts.h"

enum { MOVING = 600000 }; /* bytes of a moving picture that the page takes */

static long size_of(const Page *page, const char *name, const char *ending)
{
    struct stat s;
    const char *path = phrase("%s/%s.%s", page->dir, name, ending);
    const long size = stat(path, &s) == 0 ? (long)s.st_size : 0;
    return size;
}

/* Bytes as base64 text. */
static void put_base64(FILE *out, FILE *in)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    unsigned char b[3];
    for (size_t n; (n = fread(b, 1, 3, in)) > 0;) {
        for (size_t k = n; k < 3; k++) b[k] = 0;
        putc(digits[b[0] >> 2], out);
        putc(digits[(b[0] & 3) << 4 | b[1] >> 4], out);
        putc(n > 1 ? digits[(b[1] & 15) << 2 | b[2] >> 6] : '=', out);
        putc(n > 2 ? digits[b[2] & 63] : '=', out);
    }
}

/* The file of this name as an image: its bytes, or (drawing) that text. */
static void put_image(const Page *page, const char *name, const char *about, const char *ending,
                      const char *drawing)
{
    page_element(page->f, "<img alt=\"", about, "\" src='data:image/");
    if (drawing) {
        fprintf(page->f, "svg+xml;charset=utf-8,%s", drawing);
    } else {
        FILE *in = fopen(phrase("%s/%s.%s", page->dir, name, ending), "rb");
        fprintf(page->f, "%s;base64,", strcmp(ending, "gif") ? "png" : "gif");
        if (in) put_base64(page->f, in);
        if (in) fclose(in);
    }
    fputs("'>\n", page->f);
}

/* The drawing, or the pixels that were drawn for this page where those are shorter (plot.c); and a
 * moving picture, if there is one that is small enough. */
static void picture(const Page *page, const char *name, const char *about)
{
    const long gif = size_of(page, name, "gif"), png = size_of(page, name, "page.png");
    char *drawing = drawing_read(phrase("%s/%s.svg", page->dir, name));
    const bool pixels = drawing && png > 0 && 4 * png < 3 * (long)strlen(drawing);
    if (drawing) put_image(page, name, about, "page.png", pixels ? NULL : drawing);
    if (gif > 0 && gif < MOVING) put_image(page, name, "the same, moving", "gif", NULL);
    free(drawing);
}

static void figure_claims(const Page *page, const Study *study)
{
    int n = 0;
    for (const Claim *c = page->claims->list; c < page->claims->list + page->claims->n; c++) {
        if (c->study != study) continue;
        fputs(n++ ? ", " : "<p>Claims: ", page->f);
        page_claim_link(page->f, c);
    }
    if (n) fputs("</p>\n", page->f);
}

static void fact(FILE *f, const char *name, const char *value)
{
    if (!value) return;
    page_element(f, "<dt>", name, "</dt><dd>");
    page_element(f, "", value, "</dd>\n");
}

static void sidecar(const Page *page, const char *name)
{
    static const char *const facts[] = {"version",   "compiler", "flags",
                                        "processor", "sources",  "checksum"};
    const char *path = phrase("%s/%s.json", page->dir, name);
    json_t *json = json_load_file(path, 0, NULL), *dt = json_object_get(json, "dt");
    if (!json) return;
    fputs("<details><summary>Where the numbers come from</summary>\n<dl>\n", page->f);
    for (size_t k = 0; k < sizeof facts / sizeof *facts; k++)
        fact(page->f, facts[k], json_string_value(json_object_get(json, facts[k])));
    fprintf(page->f, "<dt>runs</dt><dd>%d in %.3g s</dd>\n",
            (int)json_array_size(json_object_get(json, "inputs")),
            json_number_value(json_object_get(json, "seconds")));
    if (json_is_number(json_object_get(dt, "min"))) {
        fprintf(page->f, "<dt>dt</dt><dd>%.4g to %.4g s; ",
                json_number_value(json_object_get(dt, "min")),
                json_number_value(json_object_get(dt, "max")));
        const char *definition = json_string_value(json_object_get(dt, "definition"));
        page_element(page->f, "", definition ? definition : "", "</dd>\n");
    }
    fact(page->f, "first run",
         json_string_value(json_array_get(json_object_get(json, "inputs"), 0)));
    fputs("</dl>\n</details>\n", page->f);
    json_decref(json);
}

static void link_to(const Page *page, const char *name, const char *ending)
{
    if (size_of(page, name, ending))
        fprintf(page->f, "<a href=\"%s.%s\">%s</a> ", name, ending, ending);
}

static void card(const Page *page, const Study *s, const char *command)
{
    fprintf(page->f, "<article class=\"card\" id=\"%s\">\n<h3>", s->name);
    page_element(page->f, "", s->figure, "</h3>\n");
    page_element(page->f, "<p>", s->about, "</p>\n");
    picture(page, s->name, s->about);
    page_prices(page, s->name);
    figure_claims(page, s);
    sidecar(page, s->name);
    fputs("<p class=\"soft\">Data: ", page->f);
    EACH_WORD(ending, "csv points.csv reach.csv json svg png") link_to(page, s->name, ending);
    page_element(page->f, "&middot; again: <code>", command, "</code></p>\n</article>\n");
}

void page_figures(const Page *page)
{
    static const Study bench[] = {
        {.name = "t_03_speed",
         .figure = "T-3",
         .about = "speed: CPU time and instructions of one particle-step"},
        {.name = "t_03_growth",
         .figure = "T-3b",
         .about = "growth: wall clock of one particle-step against the number of particles"}};
    for (const Study *s = studies; s->name; s++) {
        if (size_of(page, s->name, "csv")) card(page, s, phrase("build/mpmlab study %s", s->name));
    }
    for (int k = 0; k < 2; k++)
        if (size_of(page, bench[k].name, "csv")) card(page, &bench[k], "make bench");
}
