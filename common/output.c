/* output.c: see output.h. Columns are the same in every dimension; absent ones stay empty. */
#include <math.h>
#include <stdlib.h>
#include "output.h"
#include "table.h"

static void number(FILE *out, double x, const char *after)
{
    if (!isnan(x)) fprintf(out, "%.17g", x);
    fputs(after, out);
}

/* Component (a, b) of a matrix of point k, empty beyond DIM. */
static double entry(double *const M[NMAT], int a, int b, int k)
{
    return a < DIM && b < DIM ? M[(a * DIM + b) % NMAT][k] : NAN;
}

static double axis(const double *const v[DIM], int a, int k)
{
    return a < DIM ? v[a % DIM][k] : NAN;
}

void history_header(FILE *out)
{
    fputs("t,kinetic,strain,external_work,total,px,py,error_linf,dt\n", out);
}

void history_line(FILE *out, const Moment *m)
{
    const double columns[] = {m->t,
                              m->kinetic,
                              m->strain,
                              m->work,
                              m->kinetic + m->strain,
                              m->momentum[0],
                              DIM > 1 ? m->momentum[DIM > 1] : NAN,
                              m->error_linf,
                              m->dt};
    const int n = sizeof columns / sizeof *columns;
    for (int k = 0; k < n; k++) number(out, columns[k], k + 1 < n ? "," : "\n");
}

/* sqrt(3/2 s:s) of the Cauchy stress, plane strain in 2D, uniaxial in 1D. */
static double von_mises(double xx, double yy, double xy, double zz)
{
    const double a = xx - yy, b = yy - zz, c = zz - xx;
    return sqrt(0.5 * (a * a + b * b + c * c) + 3 * xy * xy);
}

static void particle_line(FILE *out, const Scene *scene, const Points *p, double *const F[NMAT],
                          double *const sigma[NMAT], int k)
{
    Mat f;
    for (int c = 0; c < NMAT; c++) f[c] = F[c][k];
    const double xx = sigma[0][k], yy = entry(sigma, 1, 1, k), xy = entry(sigma, 0, 1, k);
    const double zz = DIM == 2 ? out_of_plane_stress(&scene->mat, f) : entry(sigma, 2, 2, k);
    fprintf(out, "%d,", p->id[k]);
    for (int a = 0; a < 2; a++) number(out, axis(p->X, a, k), ",");
    for (int a = 0; a < 2; a++) number(out, axis(p->x, a, k), ",");
    for (int a = 0; a < 2; a++) number(out, axis(p->v, a, k), ",");
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++) number(out, entry(F, a, b, k), ",");
    number(out, xx, ",");
    number(out, yy, ",");
    number(out, xy, ",");
    number(out, zz, ",");
    number(out, DIM == 1 ? fabs(xx) : von_mises(xx, yy, xy, zz), ",");
    number(out, p->m[k], p->m[k] > 0 ? ",0\n" : ",1\n");
}

/* slot[id], so that rows come in placement order. */
static int *slots_by_id(const Points *p, int *count)
{
    int *slot = malloc(sizeof(int) * (size_t)(p->n + 1));
    *count = 0;
    for (int k = 0; slot && k < p->n; k++)
        if (p->id[k] >= 0) {
            slot[p->id[k]] = k;
            *count += 1;
        }
    return slot;
}

int write_particles(const char *path, const Scene *scene, const Solver *solver, const void *self,
                    Fault *fault)
{
    Points p;
    Samples q;
    int count;
    solver->view(self, &p, &q);
    int *slot = slots_by_id(&p, &count);
    double *room = malloc(sizeof(double) * 2 * NMAT * (size_t)(p.n + 1)), *M[2 * NMAT];
    FILE *out = slot && room ? file_begin(path, fault) : NULL;
    if (!slot || !room) fault_set(fault, FAULT_MACHINE, "out of memory writing %s", path);
    if (!out) {
        free(room), free(slot);
        return FAULT_MACHINE;
    }
    for (int k = 0; k < 2 * NMAT; k++) M[k] = room + (size_t)k * (size_t)p.n;
    solver->point_stress(self, M, M + NMAT);
    fputs("id,X,Y,x,y,vx,vy,Fxx,Fxy,Fyx,Fyy,sxx,syy,sxy,szz,von_mises,mass,surface\n", out);
    for (int k = 0; k < count; k++) particle_line(out, scene, &p, M, M + NMAT, slot[k]);
    free(room), free(slot);
    return file_commit(out, path, fault);
}

int write_nodes(const char *path, const Solver *solver, const void *self, Fault *fault)
{
    Nodes n;
    if (!solver->nodes) return fault_set(fault, FAULT_USAGE, "--nodes: this method has no grid");
    FILE *out = file_begin(path, fault);
    if (!out) return FAULT_MACHINE;
    solver->nodes(self, &n);
    fputs("id,x,y,mass,vx,vy\n", out);
    for (int k = 0; k < n.n; k++) {
        fprintf(out, "%d,", k);
        for (int a = 0; a < 2; a++) number(out, axis(n.x, a, k), ",");
        number(out, n.m[k], ",");
        number(out, n.v[0][k], ",");
        number(out, axis(n.v, 1, k), "\n");
    }
    return file_commit(out, path, fault);
}
