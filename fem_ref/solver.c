/* solver.c: explicit FEM with linear triangles (3D: tetrahedra) as a Solver: the reference of W11
 * (Appendix A).
 *
 * One Gauss point, lumped mass, updated Lagrangian, central difference with the half first step.
 * Points are nodes (id = node), samples are elements. Shares no loop with the particle methods, so
 * that they cannot share a fault. element.c has the forces, node.c the motion, build.c, mesh.c and
 * mesh_space.c the mesh. */
#include <math.h>
#include "fem.h"
#include "mesh.h"

static const Param params[] = {{"body", 0, 0, 1, "",
                                "body force taken at the nodes, or integrated over the elements",
                                "W11 A1", "nodes|elements"},
                               {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static void *make(const Setup *setup, Fault *fault)
{
    if (setup->integrator != CD) {
        fault_set(fault, FAULT_USAGE, "fem takes --integrator cd");
        return NULL;
    }
    return fem_new(setup, fault);
}

static double unit_dt(const void *self)
{
    const Fem *f = self;
    return f->edge / f->scene->c;
}

/* The strain is that of the new positions, so that a status names the step in which it arose. */
static Status step(void *self, double t, double dt, bool first)
{
    Fem *f = self;
    const Problem *problem = f->scene->problem;
    f->moved = f->status.code == OK;
    if (!f->moved) return f->status;
    if (problem->impose) problem->impose(f->scene, f->nodes, (const double *const *)f->x, t, f->v);
    fem_move(f, t, dt, first);
    fem_strain(f);
    return f->status;
}

static void view(const void *self, Points *points, Samples *samples)
{
    const Fem *f = self;
    *points = (Points){.n = f->nodes, .id = f->id, .m = f->m, .V0 = f->V0};
    for (int d = 0; d < DIM; d++) {
        points->X[d] = f->X[d];
        points->x[d] = f->x[d];
        points->v[d] = f->v[d];
    }
    *samples = (Samples){.n = f->slots, .V0 = f->A0};
    for (int k = 0; k < NMAT; k++) samples->F[k] = f->F[k];
}

static void counts(const void *self, Counts *out)
{
    const Fem *f = self;
    *out = (Counts){.ppc = NAN,
                    .particles = f->nodes,
                    .surface = 0,
                    .moved = f->moved,
                    .elements = f->elements,
                    .nodes = -1,
                    .fallbacks = -1};
}

static void impulse(const void *self, Vec out)
{
    const Fem *f = self;
    for (int d = 0; d < DIM; d++) {
        out[d] = 0;
        for (int i = 0; i < f->nodes; i++) out[d] += f->given[d][i];
    }
}

static double work(const void *self)
{
    return fem_work(self);
}

static void outside(const void *self, Vec out)
{
    for (int d = 0; d < DIM; d++) out[d] = ((const Fem *)self)->outside[d];
}

/* Adds the F and sigma of element e, of a chunk with Kirchhoff stress T, to its nodes. */
static void share(const Fem *f, int e, const Field T[NMAT], Fields F, Fields sigma)
{
    const double J = fem_jacobian(f, e);
    for (int c = 0; c < CORNERS; c++) {
        int i = f->corner[c][e];
        double weight = f->A0[e] / ((double)CORNERS * f->V0[i]);
        for (int k = 0; k < NMAT; k++) {
            F[k][i] += weight * f->F[k][e];
            sigma[k][i] += weight * T[k][e % CHUNK] / J;
        }
    }
}

/* Means of the elements around a node, weighted with their reference volumes. */
static void point_stress(const void *self, Fields F, Fields sigma)
{
    const Fem *f = self;
    for (int k = 0; k < NMAT; k++)
        for (int i = 0; i < f->nodes; i++) F[k][i] = sigma[k][i] = 0;
    for (int start = 0; start < f->slots; start += CHUNK) {
        Field T[NMAT];
        const double *now[NMAT];
        for (int k = 0; k < NMAT; k++) now[k] = f->F[k] + start;
        material_kirchhoff(&f->scene->mat, now, T);
        for (int e = start; e < start + CHUNK && e < f->elements; e++)
            share(f, e, (const Field *)T, F, sigma);
    }
}

/* Faces of an element, each seen from outside; in 2D the triangle itself. */
enum { FACES = IN_THIS_DIM(1, 1, 4) };
static const int faces[4][3] = {
    {0, DIM > 2 ? 2 : 1, DIM > 2 ? 1 : 2}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

static void patches(const void *self, PatchVisit *visit, void *own)
{
    const Fem *f = self;
    for (int e = 0; e < f->elements; e++) {
        Patch patch = {.sides = 3, .V0 = f->A0[e]};
        for (int k = 0; k < NMAT; k++) patch.F[k] = f->F[k][e];
        for (int c = 0; c < CORNERS; c++)
            for (int d = 0; d < DIM; d++) {
                const int i = f->corner[c][e];
                patch.X[d] += f->X[d][i] / (double)CORNERS;
                patch.x[d] += f->x[d][i] / (double)CORNERS;
                patch.v[d] += f->v[d][i] / (double)CORNERS;
            }
        for (; patch.face < FACES; patch.face++) {
            for (int c = 0; c < 3; c++)
                for (int d = 0; d < DIM; d++)
                    patch.corner[c][d] = f->x[d][f->corner[faces[patch.face][c]][e]];
            visit(own, &patch);
        }
    }
}

/* All arrays lie in one block, so the mesh is stored with the state. */
static void stash(void *self, Stash *s)
{
    Fem *f = self;
    if (stash_same(s, (long)f->bytes)) stash_bytes(s, f->memory, f->bytes);
    STASH(s, f->status);
    STASH(s, f->outside);
    STASH(s, f->dt_before);
    if (f->sides) fem_stash_work(f, s);
}

static void destroy(void *self)
{
    fem_free(self);
}

const Solver solver_fem = {
    .info = {.name = "fem",
             .label = "FEM",
             .about =
                 "explicit linear triangles or tetrahedra on a body-fitted mesh, the reference",
             .source = "W11 Appendix A",
             .formula = "m_i a_i = -sum_e sigma_e grad phi_i A_e + m_i b_i, lumped mass",
             .params = params},
    .takes = mesh_takes,
    .make = make,
    .unit_dt = unit_dt,
    .step = step,
    .view = view,
    .counts = counts,
    .impulse = impulse,
    .work = work,
    .outside = outside,
    .patches = patches,
    .elements = true,
    .point_stress = point_stress,
    .stash = stash,
    .free = destroy,
};
