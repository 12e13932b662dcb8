/* probe.c: see probe.h. */
#include "probe.h"
#include <math.h>
#include <stdlib.h>
#include "common/base/table.h"

static bool is_inside(const Scene *s, const Vec X)
{
    for (int d = 0; d < DIM; d++)
        if (!(X[d] >= s->body_lo[d] && X[d] <= s->body_hi[d])) return false;
    return !s->problem->inside || s->problem->inside(s, X);
}

/* Inside, or so near that round-off may have put it outside: tries the corners of a tiny box. */
static bool is_in_part(const Scene *s, const double at[3])
{
    Vec X;
    for (int d = 0; d < DIM; d++) X[d] = at[d];
    bool inside = is_inside(s, X);
    for (int k = 0; k < 1 << DIM && !inside; k++) {
        for (int d = 0; d < DIM; d++)
            X[d] = at[d] + (k >> d & 1 ? 1e-9 : -1e-9) * (s->body_hi[d] - s->body_lo[d]);
        inside = is_inside(s, X);
    }
    return inside;
}

static bool is_in_body(const Scene *whole, const double at[3])
{
    if (!whole->problem->part) return is_in_part(whole, at);
    for (int b = 0; b < 2; b++) {
        Scene s = *whole;
        whole->problem->part(&s, b);
        if (is_in_part(&s, at)) return true;
    }
    return false;
}

int probe_check(const RunSpec *spec, const Scene *scene, Fault *fault)
{
    for (int k = 0; k < spec->nprobe; k++) {
        const Probe *p = &spec->probe[k];
        if (p->axes != DIM)
            return fault_set(fault, FAULT_USAGE,
                             "--probe: got '%.80s', takes %d coordinate%s in %dD", p->text, DIM,
                             DIM > 1 ? "s" : "", DIM);
        if (!is_in_body(scene, p->X))
            return fault_set(fault, FAULT_USAGE,
                             "--probe: got '%.80s', takes a point of the body of %s at rest",
                             p->text, spec->problem);
    }
    return 0;
}

static double distance(const Points *p, int slot, const double X[3])
{
    double square = 0;
    for (int d = 0; d < DIM; d++) square += pow(p->X[d][slot] - X[d], 2);
    return sqrt(square);
}

static int nearest_id(const Points *p, const double X[3])
{
    double least = INFINITY;
    int id = -1;
    for (int k = 0; k < p->n; k++)
        if (p->id[k] >= 0) least = fmin(least, distance(p, k, X));
    for (int k = 0; k < p->n; k++)
        if (p->id[k] >= 0 && distance(p, k, X) <= least * (1 + 1e-9) && (id < 0 || p->id[k] < id))
            id = p->id[k];
    return id;
}

void probe_find(Probes *p, const RunSpec *spec, const Solver *solver, const void *self)
{
    Points points;
    Samples samples;
    *p = (Probes){.n = spec->nprobe};
    if (!p->n) return;
    solver->view(self, &points, &samples);
    for (int k = 0; k < p->n; k++) p->id[k] = nearest_id(&points, spec->probe[k].X);
}

void probe_free(Probes *p)
{
    free(p->fields);
}

static void measure_slot(const Scene *scene, const Points *points, double *const M[], int slot,
                         double out[PROBE_COLUMNS])
{
    Mat F;
    double s[9];
    for (int k = 0; k < 9; k++) s[k] = NAN;
    for (int k = 0; k < NMAT; k++) {
        F[k] = M[k][slot];
        s[k / DIM * 3 + k % DIM] = M[NMAT + k][slot];
    }
    if (DIM == 2) s[8] = material_out_of_plane_stress(&scene->mat, F);
    for (int d = 0; d < 3; d++)
        out[d] = d < DIM ? points->x[d % DIM][slot] - points->X[d % DIM][slot] : NAN;
    const double stress[] = {s[0], s[4], s[8], s[1], s[2], s[5]};
    for (int k = 0; k < 6; k++) out[3 + k] = stress[k];
}

/* Slots may grow in number when particles are sorted. */
static bool make_room(Probes *p, int slots)
{
    if (slots <= p->room) return true;
    double *more = realloc(p->fields, sizeof(double) * 2 * NMAT * (size_t)slots);
    if (!more) return false;
    p->fields = more;
    p->room = slots;
    return true;
}

bool probe_measure(Probes *p, const Scene *scene, const Solver *solver, const void *self,
                   double out[][PROBE_COLUMNS])
{
    Points points;
    Samples samples;
    double *M[2 * NMAT];
    solver->view(self, &points, &samples);
    for (int k = 0; k < p->n; k++)
        for (int c = 0; c < PROBE_COLUMNS; c++) out[k][c] = NAN;
    if (!p->n) return true;
    if (!make_room(p, points.n)) return false;
    for (int k = 0; k < 2 * NMAT; k++) M[k] = p->fields + (size_t)k * (size_t)p->room;
    solver->point_stress(self, M, M + NMAT);
    for (int slot = 0; slot < points.n; slot++)
        for (int k = 0; k < p->n; k++)
            if (points.id[slot] == p->id[k]) measure_slot(scene, &points, M, slot, out[k]);
    return true;
}

static bool acts_along(const Wall *w, int axis)
{
    return w->mirror ? w->axis == axis : w->hold >> axis & 1;
}

void probe_reactions(Reactions *r, const Scene *scene, const Solver *solver, const void *self,
                     double dt, double out[][3])
{
    Vec all, outside;
    solver->impulse(self, all);
    solver->outside(self, outside);
    for (int a = 0; a < 3; a++) {
        int acting = 0;
        for (int w = 0; w < scene->nwall; w++) acting += acts_along(&scene->wall[w], a);
        for (int w = 0; w < scene->nwall; w++) {
            out[w][a] = NAN;
            if (a >= DIM) continue;
            const double now = all[a % DIM] - outside[a % DIM];
            out[w][a] = acts_along(&scene->wall[w], a) ? (now - r->walls[a % DIM]) / dt : 0;
            if (acts_along(&scene->wall[w], a) && acting > 1) out[w][a] = NAN;
        }
    }
    for (int d = 0; d < DIM; d++) r->walls[d] = all[d] - outside[d];
}
