/* scan.c: a body from an image (W11 3.3): a file, or a drawing with as many pixels as asked for.
 *
 * load=squeeze: two bonded platens press the sample along axis 1. Whatever lies below the line
 * grip height + V t, or above its mirror image, moves with a platen's velocity +-V; between them
 * velocity is linear at the start, so that no shock runs in.
 *
 * load=radial: the manufactured oscillation of the ring (W11 5.1), in 3D of the shell, about the
 * image's lower left corner; its low sides are planes of symmetry (radial.h). */
#include <stdio.h>
#include <string.h>
#include "common/contract/layout.h"
#include "common/contract/raster.h"
enum { RADIAL_AXES = DIM };
#include "radial.h"

enum { AMPLITUDE, LOAD, FILE_NAME, CHECKSUM, PIXELS, WIDTH, THRESHOLD, EDGE, STRAIN, SPEED, GRIP };
enum { SQUEEZE, RADIAL };
enum { K_PIXEL = RADIAL_OMEGA + 1, K_CHECKSUM, K_SPEED };
enum { MOST_PIXELS = IN_THIS_DIM(4096, 4096, 256), USUAL_PIXELS = IN_THIS_DIM(128, 128, 64) };

static const Param params[] = {
    {"A", 0.1, -0.15, 0.15, "m", "radial: displacement at the outer radius", "W11 5.1", NULL},
    {"load", SQUEEZE, 0, 1, "",
     "two platens press the sample, or the ring's manufactured oscillation, in 3D the shell's", "",
     "squeeze|radial"},
    {"file", 0, 0, 0, "",
     "PGM or PBM image, dark is in; in 3D a stack: FILE%04d.pgm; without one the program draws a "
     "porous sample, or the ring",
     "W11 3.3", PARAM_PATH},
    {"checksum", 0, 0, 4294967295, "", "CRC-32 of the file, another one is refused; 0: any", "",
     NULL},
    {"pixels", USUAL_PIXELS, 8, MOST_PIXELS, "", "without a file: pixels along each side", "",
     NULL},
    {"width", 1, 1e-6, 1e6, "m", "of the image", "", NULL},
    {"threshold", 0.5, 0.001, 0.999, "", "what is darker is in; 0 is black, 1 white", "", NULL},
    {"edge", 0, 0, 1, "",
     "surface halfway between samples in and out, or where the grey between them is the threshold",
     "W11 3.3", "halfway|grey"},
    {"strain", 0.1, 0, 0.9, "", "squeeze: how much shorter the sample is at the end", "", NULL},
    {"speed", 0.02, 1e-6, 0.5, "c", "squeeze: of each platen", "", NULL},
    {"grip", 0.06, 0, 0.45, "", "squeeze: part of the height that is bonded to each platen", "",
     NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

/* x, y, z, radius over the sample's width. */
static const double pores[][4] = {{.28, .30, .35, .10},
                                  {.68, .27, .60, .12},
                                  {.50, .55, .40, .09},
                                  {.22, .68, .65, .11},
                                  {.76, .70, .35, .13}};

/* Distance of x inside the drawn body, over its width. */
static double drawn_depth(const Scene *s, const double x[3])
{
    double depth = 1, square = 0;
    if (s->par[LOAD] > 0) {
        for (int d = 0; d < DIM; d++) square += x[d] * x[d];
        const double R = sqrt(square) * s->par[WIDTH];
        return fmin(R - radial_inner, radial_outer - R) / s->par[WIDTH];
    }
    for (size_t k = 0; k < sizeof pores / sizeof *pores; k++) {
        square = 0;
        for (int d = 0; d < DIM; d++) square += pow(x[d] - pores[k][d], 2);
        depth = fmin(depth, sqrt(square) - pores[k][3]);
    }
    return depth;
}

/* Draws the body: grey is linear across its edge, from two pixels inside (dark) to two outside. */
static bool draw(const Scene *s, Image *out)
{
    const int side = (int)s->par[PIXELS], n[3] = {side, side, DIM > 2 ? side : 1};
    if (!image_new(out, n)) return false;
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++) {
                const double x[] = {(i + 0.5) / side, (j + 0.5) / side, (k + 0.5) / side};
                const double light = fmin(fmax(0.5 - 0.25 * side * drawn_depth(s, x), 0), 1);
                out->grey[image_at(out, i, j, k)] = (uint16_t)lround((double)GREY_LIGHT * light);
            }
    return true;
}

/* The image, to be freed; false and one line in why[128] if it cannot be read or drawn. */
static bool get_image(const Scene *s, Image *out, char why[128])
{
    Fault fault;
    const bool drawn = !s->text;
    if (drawn && !draw(s, out)) strcpy(why, "out of memory for the image");
    if (drawn) return out->grey != NULL;
    if (image_read(out, s->text, DIM > 2, &fault)) {
        snprintf(why, 128, "file: %.120s", fault.text);
        return false;
    }
    if (!(s->par[CHECKSUM] > 0) || (unsigned long)s->par[CHECKSUM] == out->checksum) return true;
    snprintf(why, 128, "checksum: got %.0f, the file's is %lu", s->par[CHECKSUM], out->checksum);
    image_free(out);
    return false;
}

static Raster raster_of(const Scene *s, const Image *image)
{
    return (Raster){.image = image,
                    .pixel = s->par[WIDTH] / image->n[0],
                    .threshold = s->par[THRESHOLD],
                    .halfway = (int)s->par[EDGE] == 0,
                    .mirrors = s->par[LOAD] > 0 ? (1u << DIM) - 1 : 0};
}

static bool has_dark(const Scene *s, const Image *image)
{
    const size_t n = image_at(image, 0, 0, image->n[2]);
    for (size_t k = 0; k < n; k++)
        if (image->grey[k] < s->par[THRESHOLD] * (double)GREY_LIGHT) return true;
    return false;
}

static void init_squeeze(Scene *s)
{
    const double height = s->body_hi[1], grip = s->par[GRIP] * height;
    s->mat = material_make(NEO_HOOKEAN, 1e4, 0.3, 1);
    s->c = material_wave_speed_bound(&s->mat);
    s->k[K_SPEED] = s->par[SPEED] * s->c;
    s->t_end = s->par[STRAIN] * height / (2 * s->k[K_SPEED]);
    s->error_scale = NAN;
    s->wall[s->nwall++] =
        (Wall){.axis = 1, .side = -1, .at = grip, .hold = (1u << DIM) - 1, .speed = s->k[K_SPEED]};
    s->wall[s->nwall++] = (Wall){.axis = 1,
                                 .side = 1,
                                 .at = height - grip,
                                 .hold = (1u << DIM) - 1,
                                 .speed = -s->k[K_SPEED]};
    for (int d = 0; d < DIM; d++) {
        const double margin = 0.25 * height + 2 * s->cell;
        s->lo[d] = -margin;
        s->hi[d] = s->body_hi[d] + margin;
    }
}

/* Parameters that the other motion reads, and those of a drawing and of a file. */
static bool check(const Scene *s, char why[128])
{
    const bool drawn = !s->text;
    if (s->par[PIXELS] != floor(s->par[PIXELS]))
        snprintf(why, 128, "pixels: got %g, takes a whole number", s->par[PIXELS]);
    else if (drawn && s->par[CHECKSUM] > 0)
        strcpy(why, "checksum takes a file, and a drawing has none");
    else if (drawn && s->par[LOAD] > 0 && s->par[WIDTH] < radial_outer)
        snprintf(why, 128, "width: got %g, takes %g or more, for the ring's outer radius",
                 s->par[WIDTH], radial_outer);
    else if (!(s->par[STRAIN] > 0))
        strcpy(why, "strain: got 0, takes more");
    return !*why;
}

static int init(Scene *s, char why[128])
{
    Image image;
    if (!check(s, why) || !get_image(s, &image, why)) return -1;
    const Raster raster = raster_of(s, &image);
    const bool dark = has_dark(s, &image);
    s->body = (Body){.kind = BODY_SCAN};
    s->k[K_PIXEL] = raster.pixel;
    s->k[K_CHECKSUM] = (double)image.checksum;
    for (int d = 0; d < DIM; d++) s->body_hi[d] = image.n[d] * raster.pixel;
    image_free(&image);
    if (!dark) {
        strcpy(why, "file: no sample is darker than the threshold");
        return -1;
    }
    if (s->par[LOAD] > 0) {
        Vec extent;
        for (int d = 0; d < DIM; d++) extent[d] = s->body_hi[d];
        radial_init(s);
        radial_bounds(s, false);
        for (int d = 0; d < DIM; d++) s->body_hi[d] = extent[d];
    } else
        init_squeeze(s);
    return 0;
}

/* A row carries the checksum of its file, so that it repeats with that file only. */
static void complete(const Scene *s, double par[])
{
    if (s->text) par[CHECKSUM] = s->k[K_CHECKSUM];
}

static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    Image image;
    char why[128] = "";
    if (!get_image(s, &image, why)) {
        snprintf(out->why, sizeof out->why, "%s", why);
        return true;
    }
    const Raster raster = raster_of(s, &image);
    raster_add_particles(&raster, spacing, out);
    if (fitted) raster_add_surface(&raster, spacing, out);
    image_free(&image);
    return true;
}

static bool inside(const Scene *s, const Vec X)
{
    Image image;
    char why[128] = "";
    if (!get_image(s, &image, why)) return false;
    const Raster raster = raster_of(s, &image);
    const bool in = raster_is_in(&raster, X);
    image_free(&image);
    return in;
}

/* At the start of a squeeze platens have +-V along axis 1; between them velocity is linear. */
static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    const double V = s->k[K_SPEED], height = s->body_hi[1], grip = s->par[GRIP] * height;
    if (s->par[LOAD] > 0) {
        radial_start(s, n, X, u, v, F, L);
        return;
    }
    for (int p = 0; p < n; p++) {
        const double part = (X[1][p] - grip) / (height - 2 * grip);
        v[1][p] = V * (1 - 2 * fmin(fmax(part, 0), 1));
        if (part > 0 && part < 1) L[DIM + 1][p] = -2 * V / (height - 2 * grip);
    }
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    if (s->par[LOAD] > 0) {
        radial_exact(s, n, X, t, u);
        return;
    }
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) u[d][p] = NAN;
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    if (s->par[LOAD] > 0) {
        radial_body(s, n, X, t, b);
        return;
    }
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) b[d][p] = 0;
}

const Problem problem_scan = {
    .info = {.name = "scan",
             .label = "Scanned body",
             .about = "a body from an image, squeezed between platens or in the ring's motion",
             .source = "W11 3.3",
             .formula = "radial: that of ring, in 3D of shell; squeeze: not known",
             .scale = "1 m",
             .params = params},
    .cells = IN_THIS_DIM(32, 32, 16),
    .ppc = IN_THIS_DIM(2, 4, 8),
    .cfl = 0.3,
    .init = init,
    .complete = complete,
    .inside = inside,
    .place = place,
    .start = start,
    .exact = exact,
    .body = body,
};
