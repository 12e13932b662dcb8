/* palette.c: see palette.h. */
#include "palette.h"

#include <math.h>
#include "studies/runs/engines.h"

static const char *const colours[] = {"#D55E00", "#0072B2", "#E69F00", "#56B4E9", "#332288",
                                      "#882255", "#CC6677", "#44AA99", "#999933", "#009E73",
                                      "#CC79A7", "#8C6D00", "#000000", "#7A5195"};
static const int markers[] = {4, 7, 6, 5, 15, 12, 8, 10, 14, 9, 11, 13, 2, 3};
enum { COLOURS = sizeof colours / sizeof *colours, MARKERS = sizeof markers / sizeof *markers };

void palette_colour(int k, char out[8])
{
    double rgb[3];
    const double hue = 6 * fmod(k * 0.6180339887, 1);
    for (int c = 0; c < 3; c++) /* full saturation, value .75 - .4 */
        rgb[c] = fmin(fmax(fabs(fmod(hue + 2 * c, 6) - 3) - 1, 0), 1) * (0.75 - 0.1 * (k % 4));
    if (k < COLOURS)
        snprintf(out, 8, "%s", colours[k]);
    else
        snprintf(out, 8, "#%02X%02X%02X", (unsigned)(255 * rgb[0]) & 255U,
                 (unsigned)(255 * rgb[1]) & 255U, (unsigned)(255 * rgb[2]) & 255U);
}

int palette_marker(int k)
{
    return markers[k % MARKERS];
}

/* A label as one word that gnuplot prints as it is: '_' begins no subscript. */
static void put_label(FILE *f, const char *label)
{
    for (; *label; label++) {
        if (*label == '_' || *label == '^') putc('\\', f);
        fputs(*label == ' ' ? "\u00a0" : (char[]){*label, '\0'}, f);
    }
}

/* Methods of all studies first, then those on request. */
static int sorted_names(const char *names[64], int *usual)
{
    const char *all[64];
    const int n = engine_method_names(all, 64);
    int at = 0;
    for (int request = 0; request < 2; request++) {
        for (int k = 0; k < n; k++)
            if (engine_method(all[k])->on_request == (request > 0)) names[at++] = all[k];
        if (!request) *usual = at;
    }
    return n;
}

void palette_put(FILE *f)
{
    static const char *const lists[] = {"METHODS", "REQUESTED", "LABELS", "COLOURS", "MARKERS"};
    const char *names[64];
    char colour[8];
    int usual;
    const int n = sorted_names(names, &usual);
    for (int list = 0; list < 5; list++) {
        fprintf(f, "%s='", lists[list]);
        for (int k = list == 1 ? usual : 0; k < (list ? n : usual); k++) {
            palette_colour(k, colour);
            if (k && k != (list == 1 ? usual : 0)) putc(' ', f);
            if (list < 2) fputs(names[k], f);
            if (list == 2) put_label(f, engine_method(names[k])->label);
            if (list == 3) fputs(colour, f);
            if (list == 4) fprintf(f, "%d", palette_marker(k));
        }
        fputs("'; ", f);
    }
}
