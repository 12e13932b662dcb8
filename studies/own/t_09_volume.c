/* t_09_volume.c: marching cubes (W11 3.4): the fifteen cases as polyhedra, and how far the cells of
 * a shell at rest are from its volume, by distance rule (W11 eqs 15-17 and ours). The volume is
 * that of the polyhedra whose faces a run writes (--patches), curved ones by the triangles of their
 * fans: not the mass of the nodes, which is an integral of a fitted density. */
#include <math.h>
#include <string.h>
#include "common/base/solid.h"
#include "studies/tables/curves.h"
#include "studies/tables/patches.h"

static const char *const rules[] = {"weighted_mean", "normals", "curved", "exact"};
static const int cells[] = {8, 12, 16, 24};
enum { RULES = 4, MESHES = 4, MASKS = 256, SYMMETRIES = 24, SHAPES = 15 };

static void cases(Cases *list, bool quick)
{
    for (int rule = 0; rule < RULES; rule++)
        for (int k = 0; k < (quick ? 2 : MESHES); k++)
            case_add_with(list, "patches", phrase("%s.%d", rules[rule], cells[k]),
                          "run shell --method wls2 --cells %d --set steps=1 --set A=0 --set "
                          "distance=%s",
                          cells[k], rules[rule]);
}

/* Six times the volume that a triangle and the origin enclose. */
static double triple(const double a[3], const double b[3], const double c[3])
{
    double sum = 0;
    for (int d = 0; d < 3; d++) {
        const int e = (d + 1) % 3, f = (d + 2) % 3;
        sum += a[d] * (b[e] * c[f] - b[f] * c[e]);
    }
    return sum;
}

/* Relative error of the polyhedra's volume, by the fans of their faces, whose corners are numbered
 * k = 0, 1, ... in a file of patches; NAN if it cannot be read. */
static double volume_error(const Results *r, int rule, int n)
{
    Patches p = patches_open(results_path(r, phrase("%s.%d", rules[rule], n)));
    double sum = 0, first[3] = {0}, last[3] = {0};
    while (patches_next(&p)) {
        if (p.k == 0) memcpy(first, p.x, sizeof first);
        if (p.k > 1) sum += triple(first, last, p.x) / 6;
        memcpy(last, p.x, sizeof last);
    }
    return p.corners ? fabs(sum / (M_PI / 6 * (1 - 0.125)) - 1) : NAN;
}

/* Corner k of a cube turned by one of 24 rotations: an order of the axes, and which are reversed.
 */
static int turned(int k, int turn)
{
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                    {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
    const int axes = turn / 4, pair = turn % 4, odd = axes > 2;
    const int flips[4] = {0, 3, 5, 6}; /* an even number of reversed axes, odd after an odd order */
    const int flip = odd ? flips[pair] ^ 7 : flips[pair];
    int image = 0;
    for (int d = 0; d < 3; d++) image |= ((k >> order[axes][d] ^ flip >> d) & 1) << d;
    return image;
}

/* The masks that no rotation, and no exchange of in and out, makes a smaller number. */
static int find_cases(int mask[MASKS])
{
    int count = 0;
    for (int m = 0; m < MASKS; m++) {
        int least = m;
        for (int turn = 0; turn < SYMMETRIES; turn++) {
            int image = 0;
            for (int k = 0; k < 8; k++) image |= (m >> k & 1) << turned(k, turn);
            const int other = MASKS - 1 - image;
            least = image < least ? image : least;
            least = other < least ? other : least;
        }
        if (least == m) mask[count++] = m;
    }
    return count;
}

/* Distances `in` and -`out`. */
static void shape_of(int mask, double in, double out, Polyhedron *p)
{
    double d[8];
    for (int k = 0; k < 8; k++) d[k] = mask >> k & 1 ? in : -out;
    polyhedron_make(d, NULL, p);
}

static double volume_of(int mask, double in, double out)
{
    double sum = 0;
    Polyhedron p;
    shape_of(mask, in, out, &p);
    for (int piece = 0; piece < p.pieces; piece++) {
        Solid s;
        solid_measure(&p, piece, false, &s);
        sum += s.volume;
    }
    return sum;
}

/* A viewer in front, on the right and above: across and up on the page, and towards the viewer. */
static void project(const double x[3], double out[3])
{
    out[0] = x[0] + 0.45 * x[1];
    out[1] = x[2] + 0.35 * x[1];
    out[2] = 0.25 * x[0] - x[1] + 0.3 * x[2];
}

/* The faces of one case from back to front: its corners on the page, 1 for a face of the surface.
 * Returns the number of the next face. */
static int write_shape(FILE *f, int shape, int mask, int number)
{
    Polyhedron p;
    double depth[MAX_FACES] = {0};
    bool done[MAX_FACES] = {false};
    shape_of(mask, 0.8, 1, &p);
    for (int k = 0; k < p.faces; k++) {
        double x[3];
        project(p.face[k].apex, x);
        depth[k] = x[2];
    }
    for (int k = 0; k < p.faces; k++, number++) {
        int next = 0;
        while (done[next]) next++;
        for (int j = next + 1; j < p.faces; j++)
            if (!done[j] && depth[j] < depth[next]) next = j;
        const Face *face = &p.face[next];
        done[next] = true;
        for (int c = 0; c <= face->sides; c++) {
            double x[3];
            project(p.x[face->vertex[c % face->sides]], x);
            results_print(f, "%d,%d,%d,%.6g,%.6g\n", shape, number, face->cut,
                          x[0] + 2 * (shape % 5), x[1] - 1.9 * (shape / 5));
        }
    }
    return number;
}

static void tables(const Results *r)
{
    int mask[MASKS], number = 0;
    FILE *errors = results_write(r, "volume", "rule,cells,error");
    FILE *shapes = results_write(r, "shapes", "shape,face,cut,x,y");
    for (int rule = 0; rule < RULES; rule++)
        for (int k = 0; k < (r->quick ? 2 : MESHES); k++)
            results_print(errors, "%s,%d,%.17g\n", rules[rule], cells[k],
                          volume_error(r, rule, cells[k]));
    const int found = find_cases(mask);
    for (int k = 0; k < found; k++) number = write_shape(shapes, k, mask[k], number);
}

static void check(Check *c, const Results *r)
{
    static const double low[RULES] = {1.9, 1.7, 3.8, 1.98}, high[RULES] = {2.1, 2.3, 4.2, 2.02};
    static const char *const names[RULES] = {
        "distance is the length of the mean of surface points, eqs 15-17",
        "distance along the points' normals", "distance and faces curved",
        "exact distances, flat faces"};
    int mask[MASKS];
    double worst = 0;
    const Table *t = results_part(r, "volume");
    for (int rule = 0; rule < RULES; rule++) {
        const Measure order = curve_order_in_h(t, "error", 8, 24, MESHES, "rule=%s", rules[rule]);
        claim(c, phrase("T-9.%s", rules[rule]),
              phrase("Volume of a shell's cells, order of its error, N = 8 to 24: %s", names[rule]),
              order, low[rule], high[rule]);
        claim_note(c, rules[rule], order.value);
    }
    claim(c, "T-9.constant",
          "Volume of a shell's cells with exact distances: error times N^2 at N = 24 over that of "
          "spheres cut flat, .597 (R - r)/(R^3 - r^3)",
          measure_times(select_value(t, "error", "rule=exact cells=24"), 24 * 24 / 0.341), 0.95,
          1.05);
    claim(c, "T-9.cases", "Marching cubes: masks that differ under rotations and complement",
          measure_formula(find_cases(mask)), SHAPES, SHAPES);
    for (int m = 0; m < MASKS; m++)
        worst =
            measure_worse(worst, fabs(volume_of(m, 0.8, 1) + volume_of(MASKS - 1 - m, 1, 0.8) - 1));
    claim(
        c, "T-9.complement",
        "Marching cubes: volume of a shape and of its complement against the cube's, all 256 masks",
        measure_formula(worst), 0, 1e-15);
}

const StudyPage study_t_09_volume = {.cases = cases, .tables = tables, .check = check, .claims = 7};
