/* snapshot.c: see snapshot.h. */
#include "snapshot_list.h"
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "state.h"
#include "common/base/table.h"
#include "common/base/vtk_file.h"

static int no_memory(Fault *fault)
{
    return fault_set(fault, FAULT_MACHINE, "out of memory for a snapshot");
}

static int write_kind(Snapshots *s, int kind, long step, const VtkData *data, Fault *fault)
{
    char path[PATH_MAX];
    if (!snapshot_room(s, kind)) return no_memory(fault);
    snapshot_path(s, kind, step, path);
    s->step[kind][s->n[kind]] = step;
    s->t[kind][s->n[kind]++] = data->t;
    return vtk_file_write(path, data, fault);
}

static int write_points(Snapshots *s, const State *state, long step, double t, Fault *fault)
{
    VtkArray arrays[12 + MAX_OWN] = {
        {"id", VTK_I64, 1, state->id},
        {"X", VTK_F64, 3, state->X},
        {"displacement", VTK_F64, 3, state->u},
        {"v", VTK_F64, 3, state->v},
        {"F", VTK_F64, 9, state->F},
        {"stress", VTK_F64, 9, state->sigma},
        {"von_mises", VTK_F64, 1, state->von_mises},
        {"energy", VTK_F64, 1, state->energy},
        {"mass", VTK_F64, 1, state->m},
        {"surface", VTK_U8, 1, state->surface},
    };
    int n = 10;
    if (state->body) arrays[n++] = (VtkArray){"body", VTK_U8, 1, state->body};
    for (int f = 0; state->own_name && state->own_name[f]; f++)
        arrays[n++] = (VtkArray){state->own_name[f], VTK_F64, 1,
                                 state->own + (size_t)f * ((size_t)state->n + 1)};
    return write_kind(
        s, SHOT_PARTICLES, step,
        &(VtkData){
            .t = t, .points = state->n, .x = &state->x[0][0], .cells = -1, .on_point = arrays},
        fault);
}

static int shoot_points(Snapshots *s, const Scene *scene, const Solver *solver, const void *self,
                        long step, double t, Fault *fault)
{
    State state;
    if (state_of_points(&state, scene, solver, self, fault)) return FAULT_MACHINE;
    const int code = write_points(s, &state, step, t, fault);
    state_free(&state);
    return code;
}

static int shoot_nodes(Snapshots *s, const Solver *solver, const void *self, long step, double t,
                       Fault *fault)
{
    Nodes n;
    solver->nodes(self, &n);
    double(*x)[3] = calloc((size_t)n.n + 1, 2 * sizeof *x);
    if (!x) return no_memory(fault);
    double(*v)[3] = x + n.n;
    for (int k = 0; k < n.n; k++)
        for (int d = 0; d < DIM; d++) x[k][d] = n.x[d][k], v[k][d] = n.v[d][k];
    const VtkArray arrays[] = {{"v", VTK_F64, 3, v}, {"mass", VTK_F64, 1, n.m}, {0}};
    const int code = write_kind(
        s, SHOT_NODES, step,
        &(VtkData){.t = t, .points = n.n, .x = &x[0][0], .cells = -1, .on_point = arrays}, fault);
    free(x);
    return code;
}

/* Polygons as they come by; first counted, then filled in. */
typedef struct Patches {
    int64_t cells, corners;
    double (*x)[3];
    int64_t *corner, *end, *element; /* element: of a mesh, or cell, whose face it is */
    int64_t elements;
    uint8_t *cut;
} Patches;

static void see_patch(void *own, const Patch *patch)
{
    Patches *p = own;
    for (int k = 0; k < patch->sides; k++, p->corners++) {
        if (!p->x) continue;
        for (int d = 0; d < DIM; d++) p->x[p->corners][d] = patch->corner[k][d];
        p->corner[p->corners] = p->corners;
    }
    p->elements += patch->face == 0;
    if (p->x) {
        p->cut[p->cells] = patch->cut;
        p->end[p->cells] = p->corners;
        p->element[p->cells] = p->elements - 1;
    }
    p->cells++;
}

/* The rows of elements for each of their faces: [cells][components], to be freed. */
static double *for_faces(const double *row, int components, const Patches *p)
{
    const size_t n = (size_t)components;
    double *out = row ? malloc(sizeof(double) * n * (size_t)(p->cells + 1)) : NULL;
    for (int64_t k = 0; out && k < p->cells; k++)
        memcpy(out + (size_t)k * n, row + (size_t)p->element[k] * n, sizeof(double) * n);
    return out;
}

static int output_patches(Snapshots *s, const Scene *scene, const Solver *solver, const void *self,
                          const Patches *p, long step, double t, Fault *fault)
{
    State e = {0};
    if (solver->elements && state_of_elements(&e, scene, solver, self, fault)) return FAULT_MACHINE;
    double *const own[] = {for_faces(e.F ? &e.F[0][0] : NULL, 9, p),
                           for_faces(e.sigma ? &e.sigma[0][0] : NULL, 9, p),
                           for_faces(e.von_mises, 1, p), for_faces(e.energy, 1, p)};
    const bool whole = !solver->elements || (own[0] && own[1] && own[2] && own[3]);
    const VtkArray arrays[] = {{"cut", VTK_U8, 1, p->cut},
                               {"F", VTK_F64, 9, own[0]},
                               {"stress", VTK_F64, 9, own[1]},
                               {"von_mises", VTK_F64, 1, own[2]},
                               {"energy", VTK_F64, 1, own[3]},
                               {"element", VTK_I64, 1, DIM > 2 ? p->element : NULL},
                               {0}};
    const VtkData data = {.t = t,
                          .points = p->corners,
                          .x = &p->x[0][0],
                          .cells = p->cells,
                          .corner = p->corner,
                          .end = p->end,
                          .on_cell = arrays};
    const int code = whole ? write_kind(s, SHOT_CELLS, step, &data, fault) : no_memory(fault);
    for (int k = 0; k < 4; k++) free(own[k]);
    state_free(&e);
    return code;
}

static bool patches_new(Patches *p, const Patches *count)
{
    p->x = calloc((size_t)count->corners + 1, sizeof *p->x);
    p->corner = calloc((size_t)count->corners + 1, sizeof *p->corner);
    p->end = calloc((size_t)count->cells + 1, sizeof *p->end);
    p->element = calloc((size_t)count->cells + 1, sizeof *p->element);
    p->cut = calloc((size_t)count->cells + 1, 1);
    return p->x && p->corner && p->end && p->element && p->cut;
}

static int shoot_patches(Snapshots *s, const Scene *scene, const Solver *solver, const void *self,
                         long step, double t, Fault *fault)
{
    Patches count = {0}, p = {0};
    solver->patches(self, see_patch, &count);
    if (!count.cells) return 0;
    int code = FAULT_MACHINE;
    if (patches_new(&p, &count)) {
        solver->patches(self, see_patch, &p);
        code = output_patches(s, scene, solver, self, &p, step, t, fault);
    } else
        no_memory(fault);
    free(p.x), free(p.corner), free(p.end), free(p.element), free(p.cut);
    return code;
}

/* By steps or by time; a time belongs to the first step that reaches it. */
static bool is_due(Snapshots *s, long step, double t)
{
    if (s->every > 0 && step % s->every == 0) return true;
    if (!(s->every_s > 0)) return false;
    const long slot = (long)floor(t / s->every_s * (1 + 1e-12)), last = s->slot;
    s->slot = slot;
    return slot > last;
}

int snapshot_take(Snapshots *s, const Scene *scene, const Solver *solver, const void *self,
                  long step, double t, bool last, Fault *fault)
{
    const int n = s->n[SHOT_PARTICLES];
    const bool due = last || step == 0 || is_due(s, step, t);
    const bool taken = n > 0 && s->step[SHOT_PARTICLES][n - 1] == step;
    int code = 0;
    if (due && !taken) {
        code = shoot_points(s, scene, solver, self, step, t, fault);
        if (!code && solver->nodes) code = shoot_nodes(s, solver, self, step, t, fault);
        if (!code && solver->patches && DIM > 1)
            code = shoot_patches(s, scene, solver, self, step, t, fault);
    }
    for (int kind = 0; kind < SHOT_KINDS && !code; kind++)
        code = snapshot_list(s, kind, last, fault);
    return code;
}

int snapshot_start(Snapshots *s, const Setup *setup, const Solver *solver, const void *self,
                   Fault *fault)
{
    void *other = solver->project ? solver->make(setup, fault) : NULL;
    if (solver->project && !other) return fault->code;
    if (other) solver->project(other); /* a failure shows in the numbers */
    const int code =
        snapshot_take(s, setup->scene, solver, other ? other : self, 0, 0, false, fault);
    if (other) solver->free(other);
    return code;
}
