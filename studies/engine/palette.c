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

void palette_put(FILE *f)
{
    static const char *const lists[] = {"METHODS", "LABELS", "COLOURS", "MARKERS"};
    const char *names[64];
    char colour[8];
    const int n = engine_method_names(names, 64);
    for (int list = 0; list < 4; list++) {
        fprintf(f, "%s='", lists[list]);
        for (int k = 0; k < n; k++) {
            palette_colour(k, colour);
            if (k) putc(' ', f);
            if (list == 0) fputs(names[k], f);
            if (list == 1) put_label(f, engine_method(names[k])->label);
            if (list == 2) fputs(colour, f);
            if (list == 3) fprintf(f, "%d", palette_marker(k));
        }
        fputs("'; ", f);
    }
}
