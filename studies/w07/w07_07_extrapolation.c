/* w07_07_extrapolation.c: what gradient enhancement does, drawn. Wallstedt and Guilkey (2007),
 * fig. 7.
 *
 * v = (1 + x)^2 on five particles in three cells. The plain projection carries each particle's v_p
 * straight to the nodes (eq. 2.1); the enhanced one follows its tangent there, v_p + L_p (x_i -
 * x_p) (eqs 4.1, 4.2). Tents, so that each particle contributes to two nodes. */
#include <math.h>
#include "studies/tables/curves.h"

enum { CELLS = 3, PARTICLES = 5 };

static void add(Cases *list, const char *kind, const char *part, const char *method)
{
    case_add_with(list, kind, part,
                  "run squeeze --method %s --cells %d --set field=quadratic --set particles=%d",
                  method, CELLS, PARTICLES);
}

static void cases(Cases *list, bool quick)
{
    (void)quick;
    add(list, "particles", "particles", "gimp"); /* the same for all */
    add(list, "nodes", "mpm", "mpm");
    add(list, "nodes", "ge_mpm", "ge_mpm");
}

/* A line from a particle to both nodes it contributes to, with the weight it has there. */
static void write_lines(FILE *f, const Table *particles, int p)
{
    double x = select_number(particles, p, "x"), v = select_number(particles, p, "vx");
    double L = 2 * (1 + x); /* of the prescribed field */
    for (int i = 0; i <= CELLS; i++) {
        double S = 0, G, node = i / (double)CELLS;
        engine_1d.weight("mpm", (double)CELLS * x - i, 0.5, &S, &G);
        if (S > 0)
            results_print(f, "%d,%.17g,%.17g,%.17g,%.17g,%.17g\n", p, x, v, node,
                          v + L * (node - x), S);
    }
}

static void tables(const Results *r)
{
    const Table *particles = results_ended(r, "particles");
    FILE *f = results_write(r, "lines", "id,x,v,node_x,extrapolated,weight");
    for (int p = 0; p < particles->nrow; p++) write_lines(f, particles, p);
}

/* Momentum of the nodes over that of the particles, less 1. */
static Measure momentum_error(const Results *r)
{
    static const char *const parts[] = {"ge_mpm", "particles"};
    double sum[2] = {0, 0};
    int rows = 0;
    for (int k = 0; k < 2; k++) {
        const Table *t = results_run(r, "%s", parts[k]);
        if (!t->nrow) return measure(NAN, 0, 1);
        for (int row = 0; row < t->nrow; row++, rows++)
            sum[k] += select_number(t, row, "mass") * select_number(t, row, "vx");
    }
    return measure(fabs(sum[0] / sum[1] - 1), rows, CELLS + 1 + PARTICLES);
}

static void check(Check *c, const Results *r)
{
    const Measure plain = select_value(r->rows, "error_linf", "method=mpm");
    const Measure enhanced = select_value(r->rows, "error_linf", "method=ge_mpm");
    claim_note(c, "mpm", plain.value);
    claim_note(c, "ge_mpm", enhanced.value);
    claim(c, "W07-7.momentum",
          "Quadratic field from five particles in three cells, GE-MPM: the enhanced projection "
          "conserves momentum: nodes' total over particles', less 1",
          momentum_error(r), 0, 1e-14);
    claim(c, "W07-7.better",
          "Quadratic field from five particles in three cells: extrapolated values lower the "
          "error: GE-MPM's over MPM's",
          measure_ratio(enhanced, plain), 0, 0.8);
}

const StudyPage study_w07_07_extrapolation = {
    .cases = cases, .tables = tables, .check = check, .claims = 2};
