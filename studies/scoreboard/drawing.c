/* drawing.c: see drawing.h. gnuplot writes each point as an element of its own, lines in absolute
 * coordinates, and the same attributes with every element. */
#include "drawing.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "studies/runs/must.h"

enum { FEW = 4 /* points are no shorter as markers */, POINT_TEXT = 160 };

static bool begins(const char *s, const char *with)
{
    return strncmp(s, with, strlen(with)) == 0;
}

/* Where the last vertex of a path was [tenths of a pixel]. */
typedef struct Pen {
    long x, y;
    int vertices;
} Pen;

static void put_tenths(FILE *out, long v, bool apart)
{
    if (v < 0 || apart) putc(v < 0 ? '-' : ' ', out);
    const long whole = labs(v) / 10, rest = labs(v) % 10;
    if (whole || !rest) fprintf(out, "%ld", whole);
    if (rest) fprintf(out, ".%ld", rest);
}

/* Writes the step to the next vertex, m with the pen up; the letter of a line may be left out. The
 * first step of a path starts from (0, 0). */
static void put_vertex(FILE *out, Pen *pen, double x, double y, bool up)
{
    const long to_x = lround(10 * x), to_y = lround(10 * y);
    if (up) putc('m', out);
    put_tenths(out, to_x - pen->x, !up);
    put_tenths(out, to_y - pen->y, true);
    *pen = (Pen){to_x, to_y, pen->vertices + 1};
}

/* Writes the vertices of a path in relative coordinates; returns what follows the last one. */
static const char *put_path(FILE *out, const char *s)
{
    Pen pen = {0, 0, 0};
    for (;;) {
        char *comma, *end;
        s += strspn(s, " \t\n");
        if (*s != 'M' && (*s != 'L' || pen.vertices == 0)) return s;
        const double x = strtod(s + 1, &comma);
        if (*comma != ',') return s;
        const double y = strtod(comma + 1, &end);
        if (end == comma + 1) return s;
        put_vertex(out, &pen, x, y, *s == 'M');
        s = end;
    }
}

typedef struct Point {
    char symbol[8], scale[16], colour[32];
    double x, y;
} Point;

/* Reads the point that s begins with. Returns what follows it; NULL if it is no point. */
static const char *read_point(const char *s, Point *p)
{
    char text[POINT_TEXT];
    int n = 0;
    s += strspn(s, " \t\n");
    if (!begins(s, "<use xlink:href='#gpPt")) return NULL;
    snprintf(text, sizeof text, "%.*s", POINT_TEXT - 1, s);
    const int got = sscanf(text,
                           "<use xlink:href='#%7[^']' transform='translate(%lf,%lf) scale(%15[^)])'"
                           " color='%31[^']'/>%n",
                           p->symbol, &p->x, &p->y, p->scale, p->colour, &n);
    return got == 5 && n > 0 ? s + n : NULL;
}

static bool is_alike(const Point *a, const Point *b)
{
    return strcmp(a->symbol, b->symbol) == 0 && strcmp(a->scale, b->scale) == 0 &&
           strcmp(a->colour, b->colour) == 0;
}

/* Writes equal points in a row as one path, number *k of the drawing, with a marker at each vertex.
 * Returns what follows them; s if they are fewer than FEW. */
static const char *put_points(FILE *out, const char *s, int *k)
{
    Point first, p;
    Pen pen = {0, 0, 0};
    int n = 0;
    if (!read_point(s, &first)) return s;
    for (const char *at = s; n < FEW && (at = read_point(at, &p)) && is_alike(&p, &first);) n++;
    if (n < FEW) return s;
    fprintf(out,
            "<marker id='m%d' overflow='visible' markerUnits='userSpaceOnUse'><use "
            "xlink:href='#%s' transform='scale(%s)' color='%s'/></marker><path stroke='none' "
            "style='marker:url(#m%d)' d='",
            *k, first.symbol, first.scale, first.colour, *k);
    ++*k;
    for (const char *at = s; (at = read_point(at, &p)) && is_alike(&p, &first); s = at)
        put_vertex(out, &pen, p.x, p.y, pen.vertices == 0);
    fputs("'/>", out);
    return s;
}

/* Returns what follows an element that is not visible (a title, an empty group, an unused filter);
 * s if it is another. */
static const char *skip_unseen(const char *s, bool filtered)
{
    static const char *const unseen[][2] = {
        {"<title>", "</title>"}, {"<desc>", "</desc>"}, {"<filter ", "</filter>"}};
    for (int k = 0; k < (filtered ? 2 : 3); k++)
        if (begins(s, unseen[k][0])) {
            const char *end = strstr(s, unseen[k][1]);
            return end ? end + strlen(unseen[k][1]) : s;
        }
    if (!begins(s, "<g ")) return s;
    const char *inside = s + strcspn(s, ">");
    inside += *inside == '>';
    inside += strspn(inside, " \t\n");
    return begins(inside, "</g>") ? inside + 4 : s;
}

/* The drawing with fewer elements and shorter paths. */
static char *shorten(const char *s)
{
    const bool filtered = strstr(s, "url(#") != NULL;
    char *text;
    size_t size;
    int markers = 0;
    FILE *out = must(open_memstream(&text, &size));
    while (*s) {
        const char *next = skip_unseen(s, filtered);
        if (next == s) next = put_points(out, s, &markers);
        if (next != s) {
            s = next;
        } else if (begins(s, " d='")) {
            fputs(" d='", out);
            s = put_path(out, s + 4);
        } else
            putc(*s++, out);
    }
    fclose(out);
    return must(text);
}

/* The place of a character in a drawing. */
typedef struct Place {
    bool in_tag, quoted, blank; /* blank: white space was before it */
    int before;                 /* the last character kept */
    int decimals;               /* of the number, that were kept; -1: before its point */
} Place;

/* Is it the second or a later decimal of a coordinate: less than a tenth of a pixel? */
static bool is_too_exact(Place *at, int c)
{
    if (!isdigit(c) || !at->quoted) at->decimals = c == '.' && isdigit(at->before) ? 0 : -1;
    return isdigit(c) && at->decimals >= 0 && at->decimals++ > 0;
}

/* May white space be left out here: between tags, behind a bracket or comma, before a command of a
 * path? */
static bool is_idle_blank(const Place *at, int c)
{
    return at->quoted ? strchr("(,\"", at->before) || (strchr("MLlmhvz", c) && isdigit(at->before))
                      : strchr("<>\"", at->before) && strchr("</>", c);
}

static void put_character(FILE *out, Place *at, int c)
{
    if (isspace(c)) {
        at->blank = true;
        at->decimals = -1;
        return;
    }
    if (c == '\'' && at->in_tag) c = '"';
    if (at->in_tag && is_too_exact(at, c)) return;
    if (at->blank && !is_idle_blank(at, c)) putc(' ', out);
    at->blank = false;
    at->in_tag = c == '<' || (at->in_tag && c != '>');
    at->quoted = at->in_tag && at->quoted != (c == '"');
    at->before = c;
    if (strchr("#%'", c))
        fprintf(out, "%%%02X", (unsigned)c);
    else if (c == '&')
        fputs("&amp;", out);
    else
        putc(c, out);
}

/* Attributes that gnuplot repeats with every element, and what replaces them: they are set once, on
 * the outermost group. */
static const struct {
    const char *text, *instead;
} repeated[] = {{"<g id=\"gnuplot_canvas\"",
                 "<g font-family=\"DejaVu Sans\" fill=\"none\" stroke=\"currentColor\""},
                {" fill=\"#ffffff\"/>", " fill=\"#fff\" stroke=\"none\"/>"}, /* the background */
                {" font-family=\"DejaVu Sans\"", ""},
                {"<g fill=\"none\" color=", "<g color="},
                {" stroke=\"currentColor\"", ""},
                {" stroke-width=\"1.00\"", ""},
                {" class=\"gridline\"", ""},
                {" stroke-linecap=\"butt\" stroke-linejoin=\"miter\"", ""}};

/* Writes s, shortened, as the text of a URL. */
static void put_url(FILE *out, const char *s)
{
    Place at = {.before = '>', .decimals = -1};
    while (*s) {
        const char *instead = NULL;
        for (size_t k = 0; k < sizeof repeated / sizeof *repeated && !instead; k++)
            if (begins(s, repeated[k].text)) {
                instead = repeated[k].instead;
                s += strlen(repeated[k].text);
            }
        if (!instead) put_character(out, &at, (unsigned char)*s++);
        for (; instead && *instead; instead++) put_character(out, &at, (unsigned char)*instead);
    }
}

/* A whole file as text, to be freed; NULL if it cannot be read. */
static char *read_all(const char *path)
{
    FILE *in = fopen(path, "rb"), *out;
    char *text, part[4096];
    size_t size, n;
    if (!in) return NULL;
    out = must(open_memstream(&text, &size));
    while ((n = fread(part, 1, sizeof part, in)) > 0) fwrite(part, 1, n, out);
    fclose(in);
    fclose(out);
    return must(text);
}

char *drawing_read(const char *path)
{
    char *whole = read_all(path), *text = NULL;
    size_t size;
    if (!whole) return NULL;
    char *shorter = shorten(whole);
    FILE *out = must(open_memstream(&text, &size));
    put_url(out, shorter);
    fclose(out);
    free(whole);
    free(shorter);
    return must(text);
}
