/* t_16_schemes.c: one statement of its paper for each scheme that studies run on request.
 *
 * Quadrature (Steffen, Kirby & Berzins 2008): a smoother function is integrated better by particles
 * that do not fit its cells. A bar of N particles on 40 cells, m_i = sum_p m_p S_ip: off from rho h
 * by O(PPC^-(k+1)) for splines of degree k.
 *
 * Transfers (Hu et al. 2018): but for the stress MLS-MPM is APIC. 20 steps so short (CFL 1e-7) that
 * stress does nothing, in which velocities go to and fro between particles and grid. The more modes
 * PolyPIC's particles carry beyond APIC's, the less kinetic energy is lost (Fu et al. 2017).
 *
 * Tiling domains (Sadeghirad et al. 2011, 2013; de Vaucorbeil et al. 2020): a block, stretched and
 * turned by 30 degrees, in uniform stress. Convected domains tile it, and so do the reference
 * positions of particles: no force acts inside, at any place on the grid. Nor does it where cells
 * are integrated by a fitted stress (Sulsky & Gong 2016). (Forces as in h_01_translation.c, over E
 * times a cell's face.) The hanging bar of these papers: H-15. */
#include <math.h>
#include "studies/tables/grades.h"

enum { BAR_CELLS = 40, COUNTS = 5, BLOCK_CELLS = 16 };
static const int counts[COUNTS] = {100, 140, 180, 260, 340}; /* PPC 2.5 to 8.5, worst: halves */
static const char splines[] = "mpm bspline bspline3";        /* of degree 1, 2, 3 */
static const char transfers[] = "apic mls_mpm polypic";
static const char domains[] = "mpm gimp apic mls_mpm bspline3 tlmpm cpdi cpdi2 impm";

static void cases(Cases *list, bool quick)
{
    EACH_WORD(m, splines)
        for (int k = 0; k < (quick ? 2 : COUNTS); k++)
            case_add_with(list, "nodes", phrase("bar.%s.%d", m, counts[k]),
                          "run block --method %s --cells %d --integrator usl --set dim=1 --set "
                          "steps=1 --set particles=%d",
                          m, BAR_CELLS, counts[k]);
    case_add_each(list, "particles", "transfer", transfers,
                  "run free_block --cells %d --cfl 1e-7 --set steps=20", BLOCK_CELLS);
    case_add_each(list, "nodes", "block", domains,
                  "run block --cells %d --integrator usl --set dim=2 --set steps=1 --set "
                  "stretch=1.5 --set angle=30 --set offset_x=0.3 --set offset_y=0.2",
                  BLOCK_CELLS);
}

/* Is the node within so much of the middle of the scene along this axis? */
static bool is_inside(const Table *nodes, int row, const char *axis, double most)
{
    return fabs(select_number(nodes, row, axis) - 1.5) < most;
}

/* Largest error of the mass of a node inside the bar. NAN: no file. */
static double mass_error(const Results *r, const char *method, int count)
{
    const Table *nodes = results_run(r, "bar.%s.%d", method, count);
    double most = -INFINITY;
    for (int i = 0; i < nodes->nrow; i++)
        if (is_inside(nodes, i, "x", 0.3))
            most =
                measure_worse(most, fabs(select_number(nodes, i, "mass") * (double)BAR_CELLS - 1));
    return isinf(most) ? NAN : most;
}

/* Largest force inside the turned block, over E times a cell's face; E = 1e4. */
static double force_inside(const Results *r, const char *method)
{
    const Table *nodes = results_run(r, "block.%s", method);
    const double h = 1.0 / (double)BLOCK_CELLS, dt = BLOCK_CFL * h / BLOCK_SPEED;
    double most = -INFINITY;
    for (int i = 0; i < nodes->nrow; i++) {
        const double m = select_number(nodes, i, "mass") / (dt * 1e4 * h);
        if (!is_inside(nodes, i, "x", 0.2) || !is_inside(nodes, i, "y", 0.2)) continue;
        most = measure_worse(most, fabs(m * select_number(nodes, i, "vx")));
        most = measure_worse(most, fabs(m * select_number(nodes, i, "vy")));
    }
    return isinf(most) ? NAN : most;
}

static void tables(const Results *r)
{
    FILE *mass = results_write(r, "mass", "method,ppc,error");
    FILE *force = results_write(r, "force", "method,place,force");
    int place = 0;
    EACH_WORD(m, splines)
        for (int k = 0; k < COUNTS; k++) {
            const double error = mass_error(r, m, counts[k]);
            if (!isnan(error))
                results_print(mass, "%s,%g,%.10g\n", m, (double)counts[k] / (double)BAR_CELLS,
                              error);
        }
    EACH_WORD(m, domains) {
        const double f = force_inside(r, m);
        if (!isnan(f)) results_print(force, "%s,%d,%.10g\n", m, place, f);
        place++;
    }
}

/* Exponent of PPC in the error of nodal masses. */
static Measure exponent(const Results *r, const char *method)
{
    Curve c;
    curve_pick(&c, results_part(r, "mass"), "ppc", "error", "method=%s", method);
    return curve_order(&c, 2, 9, COUNTS);
}

/* Largest difference of velocities after the transfers, over the largest velocity. */
static Measure transfer_gap(const Results *r)
{
    const Table *a = results_run(r, "transfer.apic"), *b = results_run(r, "transfer.mls_mpm");
    static const char *const columns[] = {"vx", "vy"};
    double gap = 0, size = 0;
    if (a->nrow < 1 || a->nrow != b->nrow) return measure(NAN, 0, 2);
    for (int p = 0; p < a->nrow; p++)
        for (int k = 0; k < 2; k++) {
            const double v = select_number(a, p, columns[k]);
            gap = measure_worse(gap, fabs(select_number(b, p, columns[k]) - v));
            size = measure_worse(size, fabs(v));
        }
    return measure(gap / size, 2, 2);
}

static Measure lost(const Results *r, const char *method)
{
    return select_value(r->rows, "energy_drift", "problem=free_block method=%s", method);
}

static Measure force(const Results *r, const char *method)
{
    return select_value(results_part(r, "force"), "force", "method=%s", method);
}

static void check_forces(Check *c, const Results *r)
{
    claim(c, "T-16.gimp",
          "Turned block in uniform stress: GIMP's boxes, which do not turn, leave forces inside, "
          "over E times a cell's face",
          force(r, "gimp"), 1e-4, 1);
    claim(c, "T-16.cpdi",
          "Turned block in uniform stress: CPDI's parallelograms tile it (Sadeghirad et al. 2011): "
          "force inside over E times a cell's face",
          force(r, "cpdi"), 0, 1e-13);
    claim(c, "T-16.cpdi2",
          "Turned block in uniform stress: CPDI2's quadrilaterals tile it (Sadeghirad et al. "
          "2013): force inside over E times a cell's face",
          force(r, "cpdi2"), 0, 1e-13);
    claim(c, "T-16.tlmpm",
          "Turned block in uniform stress: TLMPM has no error from particles that cross cells (de "
          "Vaucorbeil et al. 2020): force inside over E times a cell's face",
          force(r, "tlmpm"), 0, 1e-13);
    claim(c, "T-16.impm",
          "Turned block in uniform stress: IMPM integrates a fitted stress by one point per cell, "
          "whatever the particles' places (Sulsky & Gong 2016): force inside over E times a cell's "
          "face",
          force(r, "impm"), 0, 1e-13);
}

static void check(Check *c, const Results *r)
{
    claim(c, "T-16.tents",
          "Masses of nodes in a bar of N particles, tents: error against particles per cell, "
          "exponent (Steffen et al. 2008: degree 1)",
          exponent(r, "mpm"), -2.05, -1.95);
    claim(c, "T-16.bspline",
          "Masses of nodes in a bar of N particles, quadratic B-splines: exponent (degree 2)",
          exponent(r, "bspline"), -3.05, -2.95);
    claim(c, "T-16.bspline3",
          "Masses of nodes in a bar of N particles, cubic B-splines: exponent (degree 3)",
          exponent(r, "bspline3"), -4.05, -3.95);
    claim(c, "T-16.mls_mpm",
          "MLS-MPM without stress is APIC with quadratic splines (Hu et al. 2018): difference of "
          "particle velocities after 20 transfers over the largest",
          transfer_gap(r), 0, 1e-12);
    claim(c, "T-16.polypic",
          "PolyPIC with modes of degree 2 (Fu et al. 2017): kinetic energy lost in 20 transfers "
          "over APIC's loss",
          measure_ratio(lost(r, "polypic"), lost(r, "apic")), 0, 0.2);
    check_forces(c, r);
}

const StudyPage study_t_16_schemes = {.cases = cases,
                                      .tables = tables,
                                      .check = check,
                                      .claims = 10,
                                      .also = "mls_mpm,bspline3,tlmpm,cpdi,cpdi2,polypic,impm"};
