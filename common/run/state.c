/* state.c: see state.h. */
#include "state.h"
#include <math.h>
#include <stdlib.h>

static int state_own(const State *s)
{
    int k = 0;
    while (s->own_name && s->own_name[k]) k++;
    return k;
}

static bool state_new(State *s, int n, const char *const *own_name, bool two, Fault *fault)
{
    *s = (State){.n = n, .own_name = own_name};
    const size_t own = (size_t)state_own(s);
    const size_t row = (12 + 18 + 4 + own) * sizeof(double) + 2, room = (size_t)n + 1;
    char *at = s->memory = calloc(room, row);
    if (!at) {
        fault_set(fault, FAULT_MACHINE, "out of memory for %d rows of output", n);
        return false;
    }
    s->X = (void *)at, at += room * sizeof *s->X;
    s->x = (void *)at, at += room * sizeof *s->x;
    s->u = (void *)at, at += room * sizeof *s->u;
    s->v = (void *)at, at += room * sizeof *s->v;
    s->F = (void *)at, at += room * sizeof *s->F;
    s->sigma = (void *)at, at += room * sizeof *s->sigma;
    s->von_mises = (void *)at, at += room * sizeof *s->von_mises;
    s->energy = (void *)at, at += room * sizeof *s->energy;
    s->m = (void *)at, at += room * sizeof *s->m;
    s->id = (void *)at, at += room * sizeof *s->id;
    s->own = (void *)at, at += own * room * sizeof *s->own;
    s->surface = (void *)at, at += room;
    s->body = two ? (void *)at : NULL;
    return true;
}

void state_free(State *s)
{
    free(s->memory);
    *s = (State){0};
}

/* sqrt(3/2 s:s) of the Cauchy stress, plane strain in 2D, uniaxial in 1D. */
static double von_mises(const double s[9])
{
    const double a = s[0] - s[4], b = s[4] - s[8], c = s[8] - s[0];
    if (DIM == 1) return fabs(s[0]);
    const double out_of_plane = DIM > 2 ? s[2] * s[2] + s[5] * s[5] : 0;
    return sqrt(0.5 * (a * a + b * b + c * c) + 3 * s[1] * s[1] + 3 * out_of_plane);
}

/* F, sigma and what follows from them, for row r. */
static void set_strain(State *s, const Scene *scene, int r, const Mat F, const Mat sigma,
                       bool broken)
{
    Mat T;
    const double *f[NMAT];
    for (int a = 0; a < 3; a++) s->F[r][4 * a] = 1;
    for (int k = 0; k < NMAT; k++) {
        s->F[r][k / DIM * 3 + k % DIM] = F[k];
        s->sigma[r][k / DIM * 3 + k % DIM] = sigma[k];
        f[k] = &F[k];
    }
    if (DIM == 2) s->sigma[r][8] = material_out_of_plane_stress(&scene->mat, F);
    s->von_mises[r] = von_mises(s->sigma[r]);
    material_stored_energy(&scene->mat, 1, f, &s->energy[r]);
    if (broken) s->energy[r] = material_without_tension(&scene->mat, F, T);
}

static void set_point(State *s, const Scene *scene, const Points *p, double *const F[NMAT],
                      double *const sigma[NMAT], int k, bool broken)
{
    const int r = p->id[k];
    Mat f, t;
    for (int c = 0; c < NMAT; c++) f[c] = F[c][k], t[c] = sigma[c][k];
    for (int d = 0; d < DIM; d++) {
        s->X[r][d] = p->X[d][k];
        s->x[r][d] = p->x[d][k];
        s->u[r][d] = s->x[r][d] - s->X[r][d];
        s->v[r][d] = p->v[d][k];
    }
    for (int own = 0; p->own_name && p->own_name[own]; own++)
        s->own[(size_t)own * ((size_t)s->n + 1) + (size_t)r] = p->own[own][k];
    s->id[r] = r;
    s->m[r] = p->m[k];
    s->surface[r] = (uint8_t) !(p->m[k] > 0);
    if (s->body) s->body[r] = r >= p->second;
    set_strain(s, scene, r, f, t, broken);
}

int state_of_points(State *out, const Scene *scene, const Solver *solver, const void *self,
                    Fault *fault)
{
    Points p;
    Samples q;
    double *M[2 * NMAT];
    int count = 0;
    solver->view(self, &p, &q);
    for (int k = 0; k < p.n; k++) count += p.id[k] >= 0;
    double *room = malloc(sizeof(double) * 2 * NMAT * (size_t)(p.n + 1));
    if (!room) return fault_set(fault, FAULT_MACHINE, "out of memory for %d rows of output", p.n);
    const bool ok = state_new(out, count, p.own_name, p.second > 0, fault);
    for (int k = 0; k < 2 * NMAT; k++) M[k] = room + (size_t)k * (size_t)p.n;
    if (ok) solver->point_stress(self, M, M + NMAT);
    for (int k = 0; ok && k < p.n; k++)
        if (p.id[k] >= 0)
            set_point(out, scene, &p, M, M + NMAT, k, q.strength && !(q.strength[k] > 0));
    free(room);
    return ok ? 0 : FAULT_MACHINE;
}

static void count_patch(void *own, const Patch *patch)
{
    *(int *)own += patch->face == 0;
}

typedef struct Filling {
    State *state;
    const Scene *scene;
    int n;
} Filling;

static void fill_patch(void *own, const Patch *patch)
{
    Filling *f = own;
    if (patch->face > 0) return;
    State *s = f->state;
    const int r = f->n++;
    Field F[NMAT], T[NMAT];
    const double *now[NMAT];
    Mat sigma;
    for (int k = 0; k < NMAT; k++) {
        for (int p = 0; p < CHUNK; p++) F[k][p] = patch->F[k];
        now[k] = F[k];
    }
    material_kirchhoff(&f->scene->mat, now, T);
    for (int k = 0; k < NMAT; k++) sigma[k] = T[k][0] / determinant(patch->F);
    for (int d = 0; d < DIM; d++) {
        s->X[r][d] = patch->X[d];
        s->x[r][d] = patch->x[d];
        s->u[r][d] = s->x[r][d] - s->X[r][d];
        s->v[r][d] = patch->v[d];
    }
    s->id[r] = r;
    s->m[r] = patch->V0 * f->scene->mat.rho;
    set_strain(s, f->scene, r, patch->F, sigma, false);
}

int state_of_elements(State *out, const Scene *scene, const Solver *solver, const void *self,
                      Fault *fault)
{
    int n = 0;
    solver->patches(self, count_patch, &n);
    if (!state_new(out, n, NULL, false, fault)) return FAULT_MACHINE;
    solver->patches(self, fill_patch, &(Filling){out, scene, 0});
    return 0;
}
