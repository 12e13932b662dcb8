/* h_04_locking.c: hard case H-4: near incompressibility, nu = .3 to .499, for every method and FEM.
 *
 * Plate: the shear mode of plate_vibration, free of dilatation, N = 16, A = .1 mm (so that the
 * pressure of finite strain is small beside lambda times anything numerical), at a sixth of a
 * period: the mode's amplitude, by projection, over the exact A cos(pi/3); a mode that is too stiff
 * runs ahead. Cantilever, N = 4: the mean sinking of the last quarter metre over that of FEM at h/8
 * with the same nu (which at nu = .499 is itself 1.7 % from its value at h/4).
 *
 * Checkerboard: root mean square of p - mean p, the mean over all points within one and a half
 * spacings along each axis (3 x 3 particles; FEM: elements of some 3 x 3 quads), over a shear
 * stress of the scene, pi mu A or .01 E. */
#include <math.h>
#include <stdlib.h>
#include "studies/tables/grades.h"
#include "studies/runs/must.h"

enum { RATIOS = 4, SCENES = 2, PLATE = 0, BEAM = 1, COARSE = 4, FINE = 32 };
static const char *const nus[RATIOS] = {"0.3", "0.45", "0.49", "0.499"};
static const char *const scenes[SCENES] = {"plate_vibration", "cantilever"};
static const int reaching[SCENES] = {13, 9}; /* particle methods that reach the end at nu = .499 */
static const double amplitude = 1e-4, plate_E = 1000, beam_E = 1e4; /* [m] [Pa] [Pa] */

/* [Pa] of the plate, rho = 1. */
static double shear_modulus(const char *nu)
{
    return plate_E / (2 * (1 + strtod(nu, NULL)));
}

static const char *part_name(int scene, const char *method, int cells, const char *nu)
{
    return phrase("%s.%s.%d.%s", scenes[scene], method, cells, nu);
}

static void add(Cases *list, int scene, const char *method, int cells, const char *nu)
{
    const char *plate = scene != PLATE ? ""
                                       : phrase(" --set A=%g --t-end %.17g", amplitude,
                                                sqrt(2) / sqrt(shear_modulus(nu)) / 6);
    case_add_with(list, "samples", part_name(scene, method, cells, nu),
                  "run %s --method %s --cells %d --set nu=%s%s", scenes[scene], method, cells, nu,
                  plate);
}

static void cases(Cases *list, bool quick)
{
    const int fine = quick ? FINE / 4 : FINE;
    for (int k = 0; k < RATIOS; k++) {
        EACH_METHOD(m, &engine_2d) {
            add(list, PLATE, m->name, 16, nus[k]);
            add(list, BEAM, m->name, COARSE, nus[k]);
        }
        add(list, BEAM, "fem", fine, nus[k]);
    }
}

/* Samples with mass: reference positions, displacements [m], masses [kg], pressures [Pa]. */
typedef struct Cloud {
    int n;
    double *X, *Y, *u, *v, *m, *p;
} Cloud;

static Cloud cloud_read(const Results *r, int scene, const char *method, int cells, const char *nu)
{
    const Table *t = results_run(r, "%s", part_name(scene, method, cells, nu));
    const size_t room = (size_t)t->nrow + 1;
    Cloud c = {.X = must(calloc(6 * room, sizeof(double)))};
    c.Y = c.X + room, c.u = c.Y + room, c.v = c.u + room, c.m = c.v + room, c.p = c.m + room;
    for (int k = 0; k < t->nrow; k++) {
        if (!(select_number(t, k, "mass") > 0)) continue;
        c.X[c.n] = select_number(t, k, "X");
        c.Y[c.n] = select_number(t, k, "Y");
        c.u[c.n] = select_number(t, k, "x") - c.X[c.n];
        c.v[c.n] = select_number(t, k, "y") - c.Y[c.n];
        c.m[c.n] = select_number(t, k, "mass");
        c.p[c.n] = -(select_number(t, k, "sxx") + select_number(t, k, "syy") +
                     select_number(t, k, "szz")) /
                   3;
        c.n++;
    }
    return c;
}

/* Amplitude of the shear mode (cos pi X sin pi Y, -sin pi X cos pi Y), over A cos(pi/3). */
static double mode_ratio(const Cloud *c)
{
    double sum = 0, square = 0;
    for (int k = 0; k < c->n; k++) {
        const double X = M_PI * c->X[k], Y = M_PI * c->Y[k];
        const double a = cos(X) * sin(Y), b = -sin(X) * cos(Y);
        sum += c->m[k] * (a * c->u[k] + b * c->v[k]);
        square += c->m[k] * (a * a + b * b);
    }
    return sum / square / (0.5 * amplitude);
}

/* Mean displacement [m] of the last quarter metre. */
static double sinking(const Cloud *c)
{
    double sum = 0, mass = 0;
    for (int k = 0; k < c->n; k++)
        if (c->X[k] > 3.75) {
            sum += c->m[k] * c->v[k];
            mass += c->m[k];
        }
    return sum / mass;
}

/* RMS of p - local mean; rho = 1 in both scenes, `share` samples make a square of `spacing`. */
static double checkerboard(const Cloud *c, int share)
{
    double square = 0, mass = 0;
    for (int k = 0; k < c->n; k++) {
        const double reach = 1.5 * sqrt(share * c->m[k]);
        double sum = 0, weight = 0;
        for (int j = 0; j < c->n; j++) {
            if (fabs(c->X[j] - c->X[k]) > reach || fabs(c->Y[j] - c->Y[k]) > reach) continue;
            sum += c->m[j] * c->p[j];
            weight += c->m[j];
        }
        square += c->m[k] * pow(c->p[k] - sum / weight, 2);
        mass += c->m[k];
    }
    return sqrt(square / mass);
}

/* One line of NAME.locking.csv. */
static void write_line(FILE *f, const Results *r, int row)
{
    const Table *rows = r->rows;
    const char *method = select_text(rows, row, "method");
    const int scene = select_is(rows, row, "problem", scenes[BEAM]);
    const int cells = (int)select_number(rows, row, "cells");
    const char *nu = NULL;
    for (int k = 0; k < RATIOS; k++)
        if (fabs(select_number(rows, row, "nu") - strtod(nus[k], NULL)) < 1e-9) nu = nus[k];
    if (!nu || (scene == BEAM && cells != COARSE)) return;
    Cloud c = cloud_read(r, scene, method, cells, nu);
    Cloud fine = cloud_read(r, BEAM, "fem", FINE, nu);
    if (!fine.n) { /* a quick look has a coarser one */
        free(fine.X);
        fine = cloud_read(r, BEAM, "fem", FINE / 4, nu);
    }
    const bool gone = select_is_lost(rows, row);
    const double scale = scene == PLATE ? M_PI * shear_modulus(nu) * amplitude : 0.01 * beam_E;
    const int share = select_number(rows, row, "elements") > 0 ? 2 : 1;
    fprintf(f, "%s,%s,%s,", scenes[scene], method, nu);
    if (gone)
        fputs("lost,,\n", f);
    else
        fprintf(f, "ok,%.10g,%.10g\n",
                scene == PLATE ? mode_ratio(&c) : sinking(&c) / sinking(&fine),
                checkerboard(&c, share) / scale);
    free(c.X);
    free(fine.X);
}

/* The cantilever at nu = .499: how far it bends beside the reference, within a tenth or a half. */
static void write_marks(FILE *f, const Table *t)
{
    EACH_ROW(row, t, "problem=cantilever nu=0.499") {
        const char *method = select_text(t, row, "method");
        const double ratio = select_kept(t, row, "ratio");
        if (isnan(ratio))
            grade_add(f, "H-4", method, MARK_LOST, "cantilever, nu = .499: lost");
        else
            grade_add(f, "H-4", method, grade_mark_of(fabs(ratio - 1), 0.1, 0.5),
                      "cantilever, nu = .499: bends %.2g times as far as the reference", ratio);
    }
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "locking", "problem,method,nu,status,ratio,checkerboard");
    for (int row = 0; row < r->rows->nrow; row++) write_line(f, r, row);
    write_marks(grades_write(r), results_part(r, "locking"));
}

static Measure value(const Table *t, int scene, const char *method, const char *nu,
                     const char *what)
{
    return select_value(t, what, "problem=%s method=%s nu=%s", scenes[scene], method, nu);
}

/* A number at nu = .499 of a method that reaches the end there; false of one that does not. */
static bool reached(const Table *t, int scene, const char *method, const char *what, double *out)
{
    *out = value(t, scene, method, "0.499", what).value;
    return select_ended(t, "nu", "problem=%s method=%s nu=0.499 status=ok", scenes[scene], method)
               .rows > 0;
}

/* How many methods that reach the end at nu = .499 (so many must) neither move 5 % less than they
 * should, nor have a checkerboard as large as the scene's shear stress. */
static Measure escaping(const Table *t, int scene)
{
    Measure n = measure_sum_of(reaching[scene] + 1);
    double ratio, rough;
    EACH_METHOD(m, &engine_2d)
        if (reached(t, scene, m->name, "ratio", &ratio) &&
            reached(t, scene, m->name, "checkerboard", &rough))
            measure_add(&n, isnan(ratio + rough) ? NAN : ratio > 0.95 && rough < 1);
    return n;
}

/* The smallest ratio and largest checkerboard of the particle methods at nu = .499, lost runs
 * aside. */
static void extremes(const Table *t, int scene, Measure *ratio, Measure *rough)
{
    double x;
    *ratio = measure_min_of(reaching[scene]), *rough = measure_max_of(reaching[scene]);
    EACH_GRID_METHOD(m, &engine_2d) {
        if (reached(t, scene, m->name, "ratio", &x)) measure_add_min(ratio, x);
        if (reached(t, scene, m->name, "checkerboard", &x)) measure_add_max(rough, x);
    }
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "locking");
    Measure ratio, rough;
    extremes(t, PLATE, &ratio, &rough);
    claim_differs(c, "H-4.plate-all",
                  "Plate, nu = .499: every method locks or shows a checkerboard of pressure: how "
                  "many do neither",
                  escaping(t, PLATE), 0, 0, 1, 4,
                  "B-splines, APIC, TPIC and GE-WLS keep p within .15 of the shear stress in this "
                  "smooth mode");
    claim(c, "H-4.plate-worst",
          "Plate, nu = .499: linear triangles have the worst checkerboard: FEM's over the largest "
          "of the particle methods",
          measure_ratio(value(t, PLATE, "fem", "0.499", "checkerboard"), rough), 1, 100);
    extremes(t, BEAM, &ratio, &rough);
    claim(c, "H-4.beam-all",
          "Cantilever, nu = .499: every method that finishes locks or shows a checkerboard of "
          "pressure: how many "
          "do neither",
          escaping(t, BEAM), 0, 0);
    claim_differs(c, "H-4.beam-worst",
                  "Cantilever, nu = .499: linear triangles lock worst: FEM's displacement over the "
                  "least of the particle methods",
                  measure_ratio(value(t, BEAM, "fem", "0.499", "ratio"), ratio), 0, 1, 1.2, 100,
                  "triangles of alternating diagonals keep .83; tents over four particles per cell "
                  "keep least");
    claim(c, "H-4.beam-gimp",
          "Cantilever: GIMP locks: its displacement at nu = .499 over the reference's",
          value(t, BEAM, "gimp", "0.499", "ratio"), 0, 0.95);
    claim(c, "H-4.beam-gimp-pressure",
          "Cantilever: GIMP's checkerboard of pressure grows with nu: at nu = .499 over that at nu "
          "= .3",
          measure_ratio(value(t, BEAM, "gimp", "0.499", "checkerboard"),
                        value(t, BEAM, "gimp", "0.3", "checkerboard")),
          10, INFINITY);
}

const StudyPage study_h_04_locking = {
    .cases = cases, .tables = tables, .check = check, .claims = 6};
