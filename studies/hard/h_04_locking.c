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
#include "studies/tables/grades.h"
#include "studies/tables/masses.h"

enum { RATIOS = 4, SCENES = 2, PLATE = 0, BEAM = 1, COARSE = 4, FINE = 32 };
static const double nus[RATIOS] = {0.3, 0.45, 0.49, 0.499};
static const char *const scenes[SCENES] = {"plate_vibration", "cantilever"};
static const int reaching[SCENES] = {13, 9}; /* particle methods that reach the end at nu = .499 */
static const double amplitude = 1e-4, plate_E = 1000, beam_E = 1e4; /* [m] [Pa] [Pa] */

/* [Pa] of the plate, rho = 1. */
static double shear_modulus(double nu)
{
    return plate_E / (2 * (1 + nu));
}

static const char *part_name(int scene, const char *method, int cells, double nu)
{
    return phrase("%s.%s.%d.%g", scenes[scene], method, cells, nu);
}

static void add(Cases *list, int scene, const char *method, int cells, double nu)
{
    const char *plate = scene != PLATE ? ""
                                       : phrase(" --set A=%g --t-end %.17g", amplitude,
                                                sqrt(2) / sqrt(shear_modulus(nu)) / 6);
    case_add_with(list, "samples", part_name(scene, method, cells, nu),
                  "run %s --method %s --cells %d --set nu=%g%s", scenes[scene], method, cells, nu,
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

static Masses samples_of(const Results *r, int scene, const char *method, int cells, double nu)
{
    return masses_read(results_run(r, "%s", part_name(scene, method, cells, nu)));
}

/* Amplitude of the shear mode (cos pi X sin pi Y, -sin pi X cos pi Y), over A cos(pi/3). */
static double mode_ratio(const Masses *all)
{
    double sum = 0, square = 0;
    for (const MassPoint *p = all->list; p < all->list + all->n; p++) {
        const double X = M_PI * p->X[0], Y = M_PI * p->X[1];
        const double a = cos(X) * sin(Y), b = -sin(X) * cos(Y);
        sum += p->mass * (a * (p->x[0] - p->X[0]) + b * (p->x[1] - p->X[1]));
        square += p->mass * (a * a + b * b);
    }
    return sum / square / (0.5 * amplitude);
}

/* Mean displacement [m] of the last quarter metre. */
static double sinking(const Masses *all)
{
    double sum = 0, mass = 0;
    for (const MassPoint *p = all->list; p < all->list + all->n; p++) {
        if (p->X[0] <= 3.75) continue;
        sum += p->mass * (p->x[1] - p->X[1]);
        mass += p->mass;
    }
    return sum / mass;
}

/* One line of NAME.locking.csv; of FEM's fine meshes none. */
static void write_line(FILE *f, const Results *r, int row)
{
    const char *method = select_text(r->rows, row, "method");
    const int scene = select_is(r->rows, row, "problem", scenes[BEAM]);
    const int cells = (int)select_number(r->rows, row, "cells");
    const double nu = select_number(r->rows, row, "nu");
    const double scale = scene == PLATE ? M_PI * shear_modulus(nu) * amplitude : 0.01 * beam_E;
    const int share = select_number(r->rows, row, "elements") > 0 ? 2 : 1;
    if (scene == BEAM && cells != COARSE) return;
    results_print(f, "%s,%s,%g,", scenes[scene], method, nu);
    if (select_is_lost(r->rows, row)) {
        fputs("lost,,\n", f);
        return;
    }
    Masses all = samples_of(r, scene, method, cells, nu);
    Masses fine = samples_of(r, BEAM, "fem", r->quick ? FINE / 4 : FINE, nu);
    results_print(f, "ok,%.10g,%.10g\n",
                  scene == PLATE ? mode_ratio(&all) : sinking(&all) / sinking(&fine),
                  masses_checkerboard(&all, share, 1.5) / scale);
    masses_free(&all);
    masses_free(&fine);
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

static Measure value(const Table *t, int scene, const char *method, double nu, const char *what)
{
    return select_value(t, what, "problem=%s method=%s nu=%g", scenes[scene], method, nu);
}

static const char finished[] = "problem=%s nu=0.499 status=ok";

/* How many methods that reach the end at nu = .499 (so many must) neither move 5 % less than they
 * should, nor have a checkerboard as large as the scene's shear stress. */
static Measure escaping(const Table *t, int scene)
{
    Measure n = measure_sum_of(reaching[scene] + 1);
    EACH_ROW(row, t, finished, scenes[scene]) {
        const double ratio = select_number(t, row, "ratio");
        const double rough = select_number(t, row, "checkerboard");
        measure_add(&n, isnan(ratio + rough) ? NAN : ratio > 0.95 && rough < 1);
    }
    return n;
}

/* The smallest ratio and largest checkerboard of the particle methods at nu = .499, lost runs
 * aside. */
static void extremes(const Table *t, int scene, Measure *ratio, Measure *rough)
{
    *ratio = measure_min_of(reaching[scene]), *rough = measure_max_of(reaching[scene]);
    EACH_ROW(row, t, finished, scenes[scene]) {
        if (!engine_has_grid(&engine_2d, select_text(t, row, "method"))) continue;
        measure_add_min(ratio, select_number(t, row, "ratio"));
        measure_add_max(rough, select_number(t, row, "checkerboard"));
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
          measure_ratio(value(t, PLATE, "fem", 0.499, "checkerboard"), rough), 1, 100);
    extremes(t, BEAM, &ratio, &rough);
    claim(c, "H-4.beam-all",
          "Cantilever, nu = .499: every method that finishes locks or shows a checkerboard of "
          "pressure: how many do neither",
          escaping(t, BEAM), 0, 0);
    claim_differs(c, "H-4.beam-worst",
                  "Cantilever, nu = .499: linear triangles lock worst: FEM's displacement over the "
                  "least of the particle methods",
                  measure_ratio(value(t, BEAM, "fem", 0.499, "ratio"), ratio), 0, 1, 1.2, 100,
                  "triangles of alternating diagonals keep .83; tents over four particles per cell "
                  "keep least");
    claim(c, "H-4.beam-gimp",
          "Cantilever: GIMP locks: its displacement at nu = .499 over the reference's",
          value(t, BEAM, "gimp", 0.499, "ratio"), 0, 0.95);
    claim(c, "H-4.beam-gimp-pressure",
          "Cantilever: GIMP's checkerboard of pressure grows with nu: at nu = .499 over that at nu "
          "= .3",
          measure_ratio(value(t, BEAM, "gimp", 0.499, "checkerboard"),
                        value(t, BEAM, "gimp", 0.3, "checkerboard")),
          10, INFINITY);
}

const StudyPage study_h_04_locking = {
    .cases = cases, .tables = tables, .check = check, .claims = 6};
