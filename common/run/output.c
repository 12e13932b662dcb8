/* output.c: see output.h. Columns are the same in every dimension; absent ones stay empty. */
#include <math.h>
#include <stdlib.h>
#include "output.h"
#include "state.h"
#include "common/base/table.h"

static void number(FILE *out, double x, const char *after)
{
    info_number_write(out, x);
    fputs(after, out);
}

static double axis(const double *const v[DIM], int a, int k)
{
    return a < DIM ? v[a % DIM][k] : NAN;
}

void output_history_header(FILE *out, int nprobe, int nwall)
{
    static const char *const columns[] = {"ux",  "uy",  "uz",  "sxx", "syy",
                                          "szz", "sxy", "sxz", "syz"};
    fputs(
        "t,kinetic,strain,external_work,total,px,py,error_linf,dt,volume,least_J,most_J,angular,pz,"
        "angular_x,angular_y,angular_z",
        out);
    for (int n = 1; n <= nprobe; n++)
        for (int k = 0; k < PROBE_COLUMNS; k++) fprintf(out, ",probe%d_%s", n, columns[k]);
    for (int n = 1; n <= nwall; n++)
        for (int k = 0; k < 3; k++) fprintf(out, ",wall%d_f%c", n, "xyz"[k]);
    fputs("\n", out);
}

/* With a comma before each. */
static void numbers(FILE *out, const double x[], int n)
{
    for (int k = 0; k < n; k++) {
        fputs(",", out);
        number(out, x[k], "");
    }
}

/* In 2D angular momentum is one number, in a column of its own. */
void output_history_line(FILE *out, const Moment *m)
{
    const double *const p = m->momentum, *const L = m->angular;
    const double columns[] = {m->t,
                              m->kinetic,
                              m->strain,
                              m->work,
                              m->kinetic + m->strain,
                              p[0],
                              DIM > 1 ? p[AXIS_Y] : NAN,
                              m->error_linf,
                              m->dt,
                              m->volume,
                              m->least_J,
                              m->most_J,
                              DIM == 2 ? L[2] : NAN,
                              DIM > 2 ? p[AXIS_LAST] : NAN,
                              DIM > 2 ? L[0] : NAN,
                              DIM > 2 ? L[1] : NAN,
                              DIM > 2 ? L[2] : NAN};
    const int n = sizeof columns / sizeof *columns;
    for (int k = 0; k < n; k++) number(out, columns[k], k + 1 < n ? "," : "");
    numbers(out, m->probe[0], m->nprobe * PROBE_COLUMNS);
    numbers(out, m->wall[0], m->nwall * 3);
    fputs("\n", out);
}

/* Component k of a row of three, empty beyond DIM. */
static double component(const double row[3], int k)
{
    return k < DIM ? row[k] : NAN;
}

static void state_line(FILE *out, const State *s, int k)
{
    const double *f = s->F[k], *t = s->sigma[k];
    const double tensors[] = {f[0], f[1], f[3], f[4], t[0], t[4], t[1], t[8]};
    const bool in_line[] = {1, 0, 0, 0, 1, 0, 0, 0}; /* what there is of them in 1D */
    const double *const vectors[] = {s->X[k], s->x[k], s->v[k]};
    fprintf(out, "%lld,", (long long)s->id[k]);
    for (int v = 0; v < 3; v++)
        for (int a = 0; a < 2; a++) number(out, component(vectors[v], a), ",");
    for (int c = 0; c < 8; c++) number(out, DIM > 1 || in_line[c] ? tensors[c] : NAN, ",");
    number(out, s->von_mises[k], ",");
    number(out, s->m[k], s->surface[k] ? ",1," : ",0,");
    number(out, s->energy[k], ",");
    const double in_space[] = {s->X[k][2], s->x[k][2], s->v[k][2], f[2], f[5],
                               f[6],       f[7],       f[8],       t[2], t[5]};
    for (int c = 0; c < 10; c++) number(out, DIM > 2 ? in_space[c] : NAN, c < 9 ? "," : "");
    if (s->body) fprintf(out, ",%d", s->body[k]);
    for (int own = 0; s->own_name && s->own_name[own]; own++) {
        fputs(",", out);
        number(out, s->own[(size_t)own * ((size_t)s->n + 1) + (size_t)k], "");
    }
    fputs("\n", out);
}

static int write_state(const char *path, const State *s, Fault *fault)
{
    FILE *out = file_begin(path, fault);
    if (!out) return FAULT_MACHINE;
    fputs("id,X,Y,x,y,vx,vy,Fxx,Fxy,Fyx,Fyy,sxx,syy,sxy,szz,von_mises,mass,surface,energy,"
          "Z,z,vz,Fxz,Fyz,Fzx,Fzy,Fzz,sxz,syz",
          out);
    if (s->body) fputs(",body", out);
    for (int f = 0; s->own_name && s->own_name[f]; f++) fprintf(out, ",%s", s->own_name[f]);
    fputs("\n", out);
    for (int k = 0; k < s->n; k++) state_line(out, s, k);
    return file_commit(out, path, fault);
}

int output_particles(const char *path, const Scene *scene, const Solver *solver, const void *self,
                     Fault *fault)
{
    State s;
    if (state_of_points(&s, scene, solver, self, fault)) return FAULT_MACHINE;
    const int code = write_state(path, &s, fault);
    state_free(&s);
    return code;
}

int output_samples(const char *path, const Scene *scene, const Solver *solver, const void *self,
                   Fault *fault)
{
    State s;
    if (!solver->elements) return output_particles(path, scene, solver, self, fault);
    if (state_of_elements(&s, scene, solver, self, fault)) return FAULT_MACHINE;
    const int code = write_state(path, &s, fault);
    state_free(&s);
    return code;
}

int output_nodes(const char *path, const Solver *solver, const void *self, Fault *fault)
{
    Nodes n;
    FILE *out = file_begin(path, fault);
    if (!out) return FAULT_MACHINE;
    solver->nodes(self, &n);
    fputs("id,x,y,mass,vx,vy,z,vz\n", out);
    for (int k = 0; k < n.n; k++) {
        fprintf(out, "%d,", k);
        for (int a = 0; a < 2; a++) number(out, axis(n.x, a, k), ",");
        number(out, n.m[k], ",");
        number(out, n.v[0][k], ",");
        number(out, axis(n.v, 1, k), ",");
        number(out, axis(n.x, 2, k), ",");
        number(out, axis(n.v, 2, k), "\n");
    }
    return file_commit(out, path, fault);
}

typedef struct Polygons {
    FILE *out;
    int n, cells;
} Polygons;

static void patch_lines(void *own, const Patch *patch)
{
    Polygons *p = own;
    if (p->n++) fputs("\n", p->out);
    p->cells += patch->face == 0;
    for (int k = 0; k < patch->sides; k++) {
        fprintf(p->out, "%d,%d,", p->cells - 1, k);
        for (int d = 0; d < 2 && d < DIM; d++) number(p->out, patch->corner[k][d], ",");
        fputs(patch->cut ? "1" : "0", p->out);
        if (DIM > 2) fprintf(p->out, ",%.17g,%d", patch->corner[k][AXIS_LAST], patch->face);
        fputs("\n", p->out);
    }
}

int output_patches(const char *path, const Solver *solver, const void *self, Fault *fault)
{
    Polygons p = {.out = file_begin(path, fault)};
    if (!p.out) return FAULT_MACHINE;
    fputs(DIM > 2 ? "cell,k,x,y,cut,z,face\n" : "cell,k,x,y,cut\n", p.out);
    solver->patches(self, patch_lines, &p);
    return file_commit(p.out, path, fault);
}

/* slot[id] of points with mass, -1 for others, so that rows come in placement order. */
static int *slots_with_mass(const Points *p, int *count)
{
    int *slot = malloc(sizeof(int) * (size_t)(p->n + 1));
    *count = 0;
    for (int k = 0; slot && k < p->n; k++) slot[k] = -1;
    for (int k = 0; slot && k < p->n; k++) {
        if (p->id[k] < 0) continue;
        slot[p->id[k]] = p->m[k] > 0 ? k : -1;
        if (p->id[k] >= *count) *count = p->id[k] + 1;
    }
    return slot;
}

int output_errors(const char *path, const Scene *scene, const Points *p, double t, Scratch *s,
                  Fault *fault)
{
    int count, *slot = slots_with_mass(p, &count);
    if (!slot) return fault_set(fault, FAULT_MACHINE, "out of memory writing %s", path);
    FILE *out = file_begin(path, fault);
    norm_displacement(scene, p, t, 1, s);
    if (out) fputs("id,X,Y,error,weight,Z\n", out);
    for (int id = 0; out && id < count; id++) {
        const int k = slot[id];
        if (k < 0) continue;
        const double cells[] = {p->X[0][k], DIM > 1 ? p->X[AXIS_Y][k] : NAN, s->w[k], p->V0[k],
                                DIM > 2 ? p->X[AXIS_LAST][k] : NAN};
        fprintf(out, "%d,", id);
        for (int c = 0; c < 5; c++) number(out, cells[c], c < 4 ? "," : "\n");
    }
    free(slot);
    return out ? file_commit(out, path, fault) : FAULT_MACHINE;
}
