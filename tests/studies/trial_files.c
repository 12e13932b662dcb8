/* trial_files.c: the files that the runs of a trial would have left; see trial.h. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/check.h"
#include "trial.h"
#include "trial_case.h"

static bool is(const Case *c, const char *problem)
{
    return strcmp(c->spec.problem, problem) == 0;
}

static double setting(const Case *c, const char *name, double usual)
{
    const char *text = spec_get(&c->spec, name);
    return text ? strtod(text, NULL) : usual;
}

static void history(FILE *f, const Case *c)
{
    const int n = is(c, "block") || is(c, "disk_impact") ? 1500 : 300; /* as its page asks for */
    fputs("t,kinetic,strain,external_work,total,px,py,error_linf,dt,volume,angular_z\n", f);
    for (int k = 0; k <= n; k++) {
        const double t = c->spec.t_end * k / n, half = 0.5 + 0.5 * cos(3.4 * t) * cos(3.4 * t);
        const double work = is(c, "scan") ? 1e-6 * k : 0;
        fprintf(f, "%.10g,%.8g,%.8g,%.8g,%.8g,1,%.8g,%.8g,%.10g,1,%.8g\n", t, half,
                1 - half + 1e-6 * k, work, 1 + 1e-6 * k, half, 1e-6 * k, c->spec.t_end / n,
                1 - 1e-5 * k);
    }
}

/* One point of a file of particles or samples, moved to and fro as a wave is. */
static void point(FILE *f, const Case *c, double X, double Y)
{
    const double u = 0.01 * sin(2 * M_PI * c->spec.t_end / 0.035 - 1e-4) * (0.1 + X);
    fprintf(f, "%.8g,%.8g,%.8g,%.8g,", X, Y, X + u, Y - 0.5 * u);
    if (c->spec.samples)
        fprintf(f, "%g,%g,0,%g,1,0\n", 2 + X, 1 + Y, 1e9 * (1 + X));
    else
        fprintf(f, "%g,%g,1,0,0,1.001,%g,%g,%g,1,%d,%g\n", 0.6 + Y, 0.5 - X, 2 + X, 1 + Y,
                1e9 * (1 + X), is(c, "scan"), 1 + X);
}

static void points(FILE *f, const Case *c)
{
    const bool samples = c->spec.samples != NULL;
    const int many = is(c, "patch")                          ? 80
                     : is(c, "hole_plate")                   ? 60
                     : is(c, "ring") || is(c, "disk_impact") ? 50
                                                             : 16;
    const int side = samples ? 8 : many;
    const double reach = is(c, "cantilever") ? 5 : is(c, "hanging_bar") ? 2 : 1.25;
    int n = 0;
    fputs(samples ? "X,Y,x,y,sxx,syy,szz,von_mises,mass,surface\n"
                  : "X,Y,x,y,vx,vy,Fxx,Fxy,Fyx,Fyy,sxx,syy,von_mises,mass,surface,energy\n",
          f);
    for (int k = 0; samples && k < 40; k++) { /* along the hole */
        const double a = M_PI / 2 * (k + 0.5) / 40, r = 0.5 + 0.1 / c->spec.cells;
        n++, point(f, c, r * cos(a), r * sin(a));
    }
    for (int j = 0; j < side; j++)
        for (int i = 0; i < side; i++)
            n++, point(f, c, reach * (i + 0.5) / side, reach * (j + 0.5) / side);
    /* as many as FEM has elements: hole.h */
    const int quads = (int)ceil(0.6 * c->spec.cells - 1e-9) * 2 *
                      (int)ceil(M_PI / 4 * 0.7 * c->spec.cells - 1e-9);
    const bool reference = samples && is(c, "hole_plate") && is_fem(c) && c->spec.cells > 100;
    for (; reference && n < 2 * quads; n++) point(f, c, 0.7, 0.7);
}

/* In space: points of the section z = 0 of a shell; of a cube, in fives, on a small part of its
 * cavity. F = 1 and a little, so that directions are those of the reference. */
static void space_points(FILE *f, const Case *c)
{
    fputs("X,Y,Z,x,y,z,Fxx,Fxy,Fxz,Fyx,Fyy,Fyz,Fzx,Fzy,Fzz,sxx,sxy,sxz,syy,syz,szz,surface,mass\n",
          f);
    for (int k = 0; k < 250; k++) {
        const bool shell = is(c, "shell");
        const double a = shell ? M_PI / 2 * spread(k) : 0.7 + 0.05 * spread(k / 5);
        const double b = shell ? 0 : 0.7 + 0.05 * spread(k / 5 + 7);
        const double R = shell ? 0.5 + 0.5 * spread(k + 3) : 0.5 + 0.01 * spread(k / 5 + 3);
        const double X[3] = {R * cos(a), R * sin(a) * cos(b), R * sin(a) * sin(b)};
        for (int move = 0; move < 2; move++)
            for (int d = 0; d < 3; d++) fprintf(f, "%.8g,", X[d] * (1 + 0.1 * move));
        fprintf(f, "1.1,0,0,0,%g,0,0,0,1.1,%.8g,0,0,%.8g,0,%.8g,0,1\n", 1 + 0.1 * spread(k),
                5e8 + k, 4e8 - k, 3e8 + c->spec.cells);
    }
}

static void errors(FILE *f, const Case *c)
{
    const double h = 1 / c->spec.cells, apart = is_fem(c) ? h : h / 2, shift = is_fem(c) ? 0 : 0.5;
    fputs("X,Y,error,weight\n", f);
    for (int j = 0; j < 12; j++)
        for (int i = 0; i < 12; i++)
            fprintf(f, "%.10g,%.10g,%.10g,1\n", (i + shift) * apart, (j + shift) * apart,
                    h * h * (1 + spread(12 * j + i)));
}

static void nodes(FILE *f, const Case *c)
{
    const bool squeeze = is(c, "squeeze");
    const int dim = c->engine->dim;
    const double middle = setting(c, "box", 3) / 2, n = c->spec.cells;
    const int from = squeeze ? 0 : (int)(n * (middle - 0.2)),
              to = squeeze ? (int)n : from + (int)(0.4 * n);
    fputs("id,x,y,mass,vx,vy,z,vz\n", f);
    for (int k = from; k <= (dim < 3 ? from : to); k++)
        for (int j = from; j <= (dim < 2 ? from : to); j++)
            for (int i = from; i <= to; i++)
                fprintf(f, "%d,%.10g,%.10g,%g,%.10g,0,%.10g,0\n", i, i / n, dim < 2 ? 0 : j / n,
                        (1 + 1e-3 * spread(i)) / n, 1 + i / n + 1e-3 * spread(i + j), k / n);
}

static void patches(FILE *f, const Case *c)
{
    const double n = c->spec.cells;
    fputs("cell,k,x,y,cut,z,face\n", f);
    for (int k = 0; k < 240; k++) {
        const double x = floor(0.6 * n * spread(k)) / n;
        const double y = sqrt(0.625 * 0.625 - x * x) + 0.1 / (n * n) + 1e-3 * (k % 4 == 2);
        fprintf(f, "%d,%d,%.17g,%.17g,1,%.17g,0\n", k / 4, k % 4, x, y, 0.1 * spread(k + 1) / n);
    }
}

void trial_files(const Cases *cases)
{
    for (const Case *c = cases->list; c < cases->list + cases->n; c++) {
        if (!c->file || strstr(c->file, ".frame.")) continue;
        FILE *f = fopen(c->file, "w");
        CU_ASSERT_PTR_NOT_NULL_FATAL(f);
        if (c->spec.history) history(f, c);
        const bool in_space = c->engine->dim == 3;
        if (c->spec.particles || c->spec.samples) (in_space ? space_points : points)(f, c);
        if (c->spec.errors) errors(f, c);
        if (c->spec.nodes) nodes(f, c);
        if (c->spec.patches) patches(f, c);
        fclose(f);
    }
}
