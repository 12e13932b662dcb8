/* w07_07_extrapolation.c: what gradient enhancement does, drawn. Wallstedt and Guilkey (2007),
 * fig. 7.
 *
 * v = (1 + x)^2 on five particles in three cells. The plain projection carries each particle's v_p
 * straight to the nodes (eq. 2.1); the enhanced one follows its tangent there, v_p + L_p (x_i -
 * x_p) (eqs 4.1, 4.2). Tents, so that each particle sees two nodes. */
#include <math.h>
#include "studies/tables/curves.h"

static const char name[] = "w07_07_extrapolation";
enum { CELLS = 3, PARTICLES = 5 };

static void add(Cases *list, const char *kind, const char *file, const char *method)
{
    case_add_with(list, kind, file,
                  "run squeeze --method %s --cells %d --set field=quadratic --set particles=%d",
                  method, CELLS, PARTICLES);
}

static void cases(Cases *list, bool quick)
{
    (void)quick;
    add(list, "particles", "w07_07_extrapolation.particles.csv", "gimp"); /* the same for all */
    add(list, "nodes", "w07_07_extrapolation.mpm.csv", "mpm");
    add(list, "nodes", "w07_07_extrapolation.ge_mpm.csv", "ge_mpm");
}

/* A line from a particle to both nodes it sees, with the weight it has there. */
static void write_lines(FILE *f, const Table *particles, int p)
{
    double x = table_number(particles, p, "x"), v = table_number(particles, p, "vx");
    double L = 2 * (1 + x); /* of the prescribed field */
    for (int i = 0; i <= CELLS; i++) {
        double S = 0, G, node = i / (double)CELLS;
        engine_1d.weight("mpm", (double)CELLS * x - i, 0.5, &S, &G);
        if (S > 0)
            fprintf(f, "%d,%.17g,%.17g,%.17g,%.17g,%.17g\n", p, x, v, node, v + L * (node - x), S);
    }
}

static int tables(const char *dir, bool quick, Fault *fault)
{
    char path[PATH_TEXT];
    (void)quick;
    Table *particles =
        table_read_part(dir, name, "particles", NULL); /* not there if not asked for */
    table_part_path(path, dir, name, "lines");
    FILE *f = file_begin(path, fault);
    if (f) fputs("id,x,v,node_x,extrapolated,weight\n", f);
    for (int p = 0; f && particles && p < particles->nrow; p++) write_lines(f, particles, p);
    table_free(particles);
    return f ? file_commit(f, path, fault) : FAULT_MACHINE;
}

static void check(Check *c, const Table *rows, const char *dir)
{
    (void)dir;
    const Measure plain = select_value(rows, "error_linf", "method=mpm");
    const Measure enhanced = select_value(rows, "error_linf", "method=ge_mpm");
    claim_note(c, "mpm", plain.value);
    claim_note(c, "ge_mpm", enhanced.value);
    claim(c, "W07-7.better", "extrapolated values lower the error: enhanced over plain",
          over(enhanced, plain), 0, 0.8);
}

const Study study_w07_07_extrapolation = {
    .name = name,
    .figure = "W07-7",
    .about = "a quadratic field: plain and extrapolated contributions of particles to nodes",
    .cases = cases,
    .tables = tables,
    .check = check,
    .claims = 1,
};
