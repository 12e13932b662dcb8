/* t_11_scan.c: bodies from images (W11 3.3). The ring of W11 5.1 from images of 64 to 1024 pixels,
 * with surface points halfway between samples in and out, as the paper places them, or where the
 * grey between samples says, against the exact geometry at N = 32; and a porous sample from an
 * image, pressed between moving platens by four methods. */
#include <math.h>
#include "studies/tables/curves.h"

static const int pixels[] = {64, 128, 256, 512, 1024};
static const char *const edges[] = {"halfway", "grey"};
static const char *const pressed[] = {"gimp", "ge_gimp", "wls2", "ge_wls"};
enum { IMAGES = 5, METHODS = 4, POINTS = 40 /* of the stress curves */, SURFACE = 140 };

#define RING                                                                                       \
    "run scan --set load=radial --set width=1.1 --set edge=%s --set pixels=%d --cells %d "         \
    "--method %s"

static void cases(Cases *list, bool quick)
{
    const int cells = quick ? 16 : 32, fine = quick ? 24 : 64, images = quick ? 2 : IMAGES;
    static const char *const exact[] = {"wls --set layout=radial", "wls2", "gimp"};
    for (int m = 0; m < 3; m++) case_add(list, "run ring --cells %d --method %s", cells, exact[m]);
    for (int e = 0; e < 2; e++) {
        for (int k = 0; k < images; k++) case_add(list, RING, edges[e], pixels[k], cells, "wls2");
        for (int k = 0; k < images; k++)
            case_add_with(list, "particles", phrase("%s_%d", edges[e], pixels[k]),
                          RING " --set steps=1", edges[e], pixels[k], cells, "wls2");
    }
    for (int k = 0; k < images; k++) case_add(list, RING, "halfway", pixels[k], cells, "gimp");
    case_add(list, RING, "grey", pixels[images - 1], cells, "wls");
    for (int m = 0; m < METHODS; m++) {
        const char *run =
            phrase("run scan --cells %d --set pixels=256 --method %s", fine, pressed[m]);
        case_add_with(list, "history", phrase("history_%s", pressed[m]), "%s", run);
        case_add_with(list, "particles", phrase("body_%s", pressed[m]), "%s", run);
    }
}

/* Distance of a run's surface points from the circles, root mean square [m]. */
static void write_surface(FILE *f, const Results *r, const char *edge, int side)
{
    const Table *t = results_run(r, "%s_%d", edge, side);
    double sum = 0;
    int n = 0;
    for (int k = 0; k < t->nrow; k++) {
        if (!(select_number(t, k, "surface") > 0)) continue;
        const double R = hypot(select_number(t, k, "X"), select_number(t, k, "Y"));
        const double away = fmin(fabs(R - 0.5), fabs(R - 1));
        sum += away * away;
        n++;
    }
    if (n > 0) results_print(f, "%s,%d,%d,%.17g\n", edge, side, n, sqrt(sum / n));
}

/* Nominal stress of the sample, which is 1 m wide: the platens' work over their way, each interval
 * of it a 40th of the run. Energies of K + S - W beside it. */
static void write_stress(FILE *f, const Results *r, const char *method)
{
    const Table *t = results_run(r, "history_%s", method);
    const double t_end = select_last(t, "t");
    int last = 0;
    for (int k = 1; k < t->nrow; k++) {
        const double from = select_number(t, last, "t"), to = select_number(t, k, "t");
        if (to - from < t_end / (double)POINTS * (1 - 1e-9)) continue;
        const double work =
            select_number(t, k, "external_work") - select_number(t, last, "external_work");
        const double way = 0.1 * (to - from) / t_end; /* both platens, of a height of 1 m */
        results_print(f, "%s,%.17g,%.17g,%.17g\n", method, 0.05 * (from + to) / t_end, work / way,
                      select_number(t, k, "total") - select_number(t, k, "external_work"));
        last = k;
    }
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "surface", "edge,pixels,points,away");
    for (int e = 0; e < 2; e++)
        for (int k = 0; k < IMAGES; k++) write_surface(f, r, edges[e], pixels[k]);
    f = results_write(r, "stress", "method,strain,stress,energy");
    for (int m = 0; m < METHODS; m++) write_stress(f, r, pressed[m]);
}

static Measure error_of(const Table *t, const char *scene, const char *method, const char *more)
{
    return select_value(t, "error_linf", "problem=%s method=%s%s", scene, method, more);
}

static void check_ring(Check *c, const Results *r)
{
    const Table *t = r->rows, *s = results_part(r, "surface");
    for (int e = 0; e < 2; e++) {
        Curve away;
        claim(c, phrase("T-11.ring-%s", edges[e]),
              phrase("Ring from an image of 1024 pixels, surface %s: largest error of WLS2 at "
                     "N = 32 over that of the exact geometry",
                     e ? "where the grey says" : "halfway between samples"),
              measure_ratio(
                  error_of(t, "scan", "wls2",
                           phrase(" load=radial edge=%s pixels=1024 set.steps=0", edges[e])),
                  error_of(t, "ring", "wls2", "")),
              0.8, 1.2);
        curve_pick(&away, s, "pixels", "away", "edge=%s", edges[e]);
        claim(c, phrase("T-11.order-%s", edges[e]),
              phrase("Surface points of the ring, %s: order of their distance from the circles in "
                     "the pixel, 64 to 1024",
                     e ? "where the grey says" : "halfway between samples"),
              measure_times(curve_order(&away, 64, 1024, IMAGES), -1), e ? 1.7 : 0.9,
              e ? 2.3 : 1.2);
    }
    claim(c, "T-11.gimp",
          "Ring from an image of 1024 pixels: largest error of GIMP at N = 32 over that of its "
          "usual lattice in the exact geometry, which has the same particles",
          measure_ratio(error_of(t, "scan", "gimp", " load=radial pixels=1024"),
                        error_of(t, "ring", "gimp", "")),
          1 - 1e-12, 1 + 1e-12);
    claim(c, "T-11.inside",
          "Published WLS on the ring with particles on the lattice and surface points on the "
          "circles: largest error at N = 32 over that with all particles fitted to the body",
          measure_ratio(error_of(t, "scan", "wls", " load=radial edge=grey pixels=1024"),
                        error_of(t, "ring", "wls", "")),
          0.8, 1.25);
}

/* Nominal stress at the end of the squeeze [Pa]. */
static Measure last_stress(const Table *t, const char *method)
{
    Curve c;
    curve_pick(&c, t, "strain", "stress", "method=%s", method);
    return measure(c.n > 0 ? c.y[c.n - 1] : NAN, c.n > 0, 1);
}

static void check_sample(Check *c, const Results *r)
{
    static const double low[METHODS] = {-0.01, -0.01, 0.01, -0.01};
    static const double high[METHODS] = {0.01, 0.01, 0.06, 0.01};
    const Table *t = results_part(r, "stress");
    Measure most = last_stress(t, pressed[0]), least = most;
    for (int m = 0; m < METHODS; m++) {
        most = measure_max(most, last_stress(t, pressed[m]));
        least = measure_min(least, last_stress(t, pressed[m]));
        claim(c, phrase("T-11.energy-%s", pressed[m]),
              phrase("Porous sample squeezed by 10 %%, N = 64, %s: change of K + S - W over the "
                     "largest K + S",
                     engine_label(pressed[m])),
              select_value(r->rows, "energy_drift", "problem=scan load=squeeze method=%s",
                           pressed[m]),
              low[m], high[m]);
    }
    claim(
        c, "T-11.stress",
        "Porous sample squeezed by 10 %, N = 64: largest over least nominal stress at the end, of "
        "GIMP, GE-GIMP, WLS2 and GE-WLS",
        measure_ratio(most, least), 1, 1.06);
}

static void check(Check *c, const Results *r)
{
    check_ring(c, r);
    check_sample(c, r);
}

const StudyPage study_t_11_scan = {.cases = cases, .tables = tables, .check = check, .claims = 11};
