/* take_over.c: a run goes on with another method on the same particles (sim.h).
 *
 * Particles keep x, v, F, m, V0, so that momentum and energy stay. A gradient L that the next
 * method keeps is that of the method before or, if it kept none, that of its grid velocities. Where
 * L is part of the deposit (m L_ad D_d, D_d = sum_i S r_d^2), its rotation is such that every
 * particle keeps the angular momentum that its deposit had: about the axis across a, b
 *   M_ab = m (D_a L_ba - D_b L_ab),
 * 0 if the method before had no affine part. If the next one has none, the body's sum of M_ab goes
 * to its particles as a rigid rotation; not in a scene with symmetry lines, whose mirrored body has
 * the opposite sum. Surface points that the first method did not have are moved with the mean
 * motion of the particles within two cells. */
#include <math.h>
#include <stdlib.h>
#include "passes.h"
#include "skin.h"
#include "step.h"

/* A particle's gradient, its spreads D [m^2], and M/m of the planes (0, 1), (0, 2), (1, 2). */
typedef struct Affine {
    Mat L;
    Vec D;
    double M[3];
} Affine;

static bool is_affine(const Sim *sim)
{
    return (sim->method.affine || sim->method.modes) && !sim->method.assemble;
}

/* The slots of particles with mass (surface: of surface points) by ascending id. Returns their
 * number. */
static int slots_by_id(const Sim *sim, bool surface, int slot[])
{
    const Particles *p = &sim->p;
    int n = 0;
    for (int id = 0; id < p->count; id++) slot[id] = -1;
    for (int k = 0; k < p->n; k++)
        if (p->id[k] >= 0 && !(p->field[AT_M][k] > 0) == surface) slot[p->id[k]] = k;
    for (int id = 0; id < p->count; id++)
        if (slot[id] >= 0) slot[n++] = slot[id];
    return n;
}

/* M_ab/m of L: the particle's angular momentum in the plane (a, b) over its mass. */
static double turn_of(const Affine *s, int a, int b)
{
    return s->D[a] * s->L[b * DIM + a] - s->D[b] * s->L[a * DIM + b];
}

static void find_turns(Affine *s)
{
    for (int a = 0, k = 0; a < DIM; a++)
        for (int b = a + 1; b < DIM; b++) s->M[k++] = turn_of(s, a, b);
}

/* The rotation of L, with its stretching as it is, for which turn_of gives M. */
static void keep_turns(Affine *s)
{
    for (int a = 0, k = 0; a < DIM; a++)
        for (int b = a + 1; b < DIM; b++, k++) {
            double *ba = &s->L[b * DIM + a], *ab = &s->L[a * DIM + b];
            const double e = 0.5 * (*ba + *ab), sum = s->D[a] + s->D[b];
            const double w = sum > 0 ? (s->M[k] - e * (s->D[a] - s->D[b])) / sum : 0;
            *ba = e + w;
            *ab = e - w;
        }
}

/* L and turns of all slots of the method before. False: out of memory. */
static bool read_affine(Sim *sim, Affine out[])
{
    const int n = sim->p.n;
    double *room = malloc(sizeof(double) * (NMAT + DIM) * (size_t)n), *L[NMAT], *D[DIM];
    if (!room) return false;
    for (int k = 0; k < NMAT; k++) L[k] = room + (size_t)k * (size_t)n;
    for (int d = 0; d < DIM; d++) D[d] = room + (size_t)(NMAT + d) * (size_t)n;
    gather_gradient(sim, L, D);
    for (int s = 0; s < n; s++) {
        for (int d = 0; d < DIM; d++) out[s].D[d] = D[d][s];
        for (int k = 0; k < NMAT; k++) {
            const double part = sim->method.moments ? 1 / D[k % DIM][s] : 1;
            out[s].L[k] = sim->method.keeps_L ? sim->p.field[AT_L + k][s] * part : L[k][s];
        }
        find_turns(&out[s]);
        for (int k = 0; k < 3 && !is_affine(sim); k++) out[s].M[k] = 0;
    }
    free(room);
    return true;
}

static void copy_slot(Sim *to, int at, const Sim *from, int slot)
{
    for (int f = AT_X; f <= AT_VOL; f++) to->p.field[f][at] = from->p.field[f][slot];
    for (int f = AT_STRENGTH; f <= AT_LOST && to->p.field[f]; f++)
        to->p.field[f][at] = from->p.field[f][slot];
}

static bool same_place(const Sim *a, int s, const Sim *b, int t)
{
    for (int d = 0; d < DIM; d++)
        if (!(fabs(a->p.field[AT_X0 + d][s] - b->p.field[AT_X0 + d][t]) <= 1e-12)) return false;
    return true;
}

/* ---- Rotation that the particles get */

/* v += w x r about the centre of mass, with w from I w = M. */
static void turn_body(Sim *sim, const double M[3])
{
    const Particles *p = &sim->p;
    double mass = 0, centre[3] = {0}, I[3][3] = {{0}}, w[3] = {0};
    for (int k = 0; k < p->n; k++) {
        mass += p->field[AT_M][k];
        for (int d = 0; d < DIM; d++) centre[d] += p->field[AT_M][k] * p->field[AT_X + d][k];
    }
    for (int k = 0; k < p->n; k++) {
        double r[3] = {0}, square = 0;
        for (int d = 0; d < DIM; d++) r[d] = p->field[AT_X + d][k] - centre[d] / mass;
        for (int d = 0; d < 3; d++) square += r[d] * r[d];
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                I[a][b] += p->field[AT_M][k] * ((a == b ? square : 0) - r[a] * r[b]);
    }
    const double about[3] = {M[2], -M[1], M[0]}; /* planes (1, 2), (0, 2), (0, 1) */
    const double det = I[0][0] * (I[1][1] * I[2][2] - I[1][2] * I[2][1]) -
                       I[0][1] * (I[1][0] * I[2][2] - I[1][2] * I[2][0]) +
                       I[0][2] * (I[1][0] * I[2][1] - I[1][1] * I[2][0]);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            const int c = (b + 1) % 3, d = (b + 2) % 3, e = (a + 1) % 3, f = (a + 2) % 3;
            if (det > 0) w[a] += (I[c][e] * I[d][f] - I[c][f] * I[d][e]) / det * about[b];
        }
    for (int k = 0; k < p->n; k++) {
        double r[3] = {0};
        for (int d = 0; d < DIM; d++) r[d] = p->field[AT_X + d][k] - centre[d] / mass;
        for (int a = 0; a < DIM; a++)
            p->field[AT_V + a][k] +=
                w[(a + 1) % 3] * r[(a + 2) % 3] - w[(a + 2) % 3] * r[(a + 1) % 3];
    }
}

/* ---- Surface points made again */

/* Surface point at slot s, from the particles within two cells in the reference state: the mean of
 * where their motions x_p + F_p (X - X_p) carry it. */
static void carry_point(Sim *sim, int s)
{
    Particles *p = &sim->p;
    const double near = 4 * sim->dx * sim->dx;
    double sum = 0, mean[AT_M] = {0};
    for (int k = 0; k < p->n; k++) {
        double r[DIM], square = 0.01 * sim->dx * sim->dx;
        if (!(p->field[AT_M][k] > 0)) continue;
        for (int d = 0; d < DIM; d++) {
            r[d] = p->field[AT_X0 + d][s] - p->field[AT_X0 + d][k];
            square += r[d] * r[d];
        }
        if (square > near) continue;
        const double w = 1 / (square * square);
        sum += w;
        for (int f = AT_X; f < AT_M; f++) mean[f] += w * p->field[f][k];
        for (int a = 0; a < DIM; a++)
            for (int b = 0; b < DIM; b++)
                mean[AT_X + a] += w * p->field[AT_F + a * DIM + b][k] * r[b];
    }
    for (int f = AT_X; f < AT_M && sum > 0; f++) p->field[f][s] = mean[f] / sum;
}

static void take_surface(Sim *to, const Sim *from, int mine[], int theirs[])
{
    const int n = slots_by_id(to, true, mine), m = slots_by_id(from, true, theirs);
    bool there = n == m;
    for (int k = 0; k < n && there; k++) there = same_place(to, mine[k], from, theirs[k]);
    for (int k = 0; k < n; k++)
        if (there)
            copy_slot(to, mine[k], from, theirs[k]);
        else
            carry_point(to, mine[k]);
}

/* ---- The particles */

/* Gives the particles of `to` what those of `from` are. Sums the turns that L does not carry. */
static bool take_particles(Sim *to, const Sim *from, const Affine state[], int mine[], int theirs[],
                           double lost[3])
{
    const int n = slots_by_id(to, false, mine), m = slots_by_id(from, false, theirs);
    bool same = n == m;
    for (int k = 0; k < n && same; k++) {
        const Affine *s = &state[theirs[k]];
        same = same_place(to, mine[k], from, theirs[k]);
        copy_slot(to, mine[k], from, theirs[k]);
        for (int c = 0; c < NMAT && to->p.field[AT_L]; c++)
            to->p.field[AT_L + c][mine[k]] = s->L[c];
        for (int c = 0; c < 3; c++) lost[c] += from->p.field[AT_M][theirs[k]] * s->M[c];
    }
    return same;
}

/* Particles that were never sorted fill no whole chunks. Returns the slots of those that they are
 * part of; what stands behind the last particle becomes its copy. */
static int whole_chunks(Particles *p)
{
    int n = p->n;
    for (; n % CHUNK; n++)
        for (int f = 0; f < FIELDS; f++)
            if (p->field[f]) p->field[f][n] = p->field[f][p->n - 1];
    return n;
}

/* L of the particles mine[k] with the turns of theirs[k]. False: out of memory. */
static bool turn_gradients(Sim *to, const Affine state[], const int mine[], const int theirs[],
                           int n)
{
    const size_t slots = (size_t)whole_chunks(&to->p);
    double *room = malloc(sizeof(double) * DIM * slots), *D[DIM];
    if (!room) return false;
    for (int d = 0; d < DIM; d++) D[d] = room + (size_t)d * slots;
    gather_gradient(to, NULL, D);
    for (int k = 0; k < n; k++) {
        Affine s = state[theirs[k]];
        for (int d = 0; d < DIM; d++) s.D[d] = D[d][mine[k]];
        keep_turns(&s);
        for (int c = 0; c < NMAT; c++) to->p.field[AT_L + c][mine[k]] = s.L[c];
    }
    free(room);
    return true;
}

int sim_take_over(Sim *to, Sim *from, Fault *fault)
{
    double lost[3] = {0};
    if (sim_project(from).code != OK) /* its state stays: the next step returns the reason */
        from->status = (Status){OK, -1, 0};
    Affine *state = calloc((size_t)from->p.n + 1, sizeof *state);
    int *mine = malloc(sizeof(int) * ((size_t)to->p.count + 1));
    int *theirs = malloc(sizeof(int) * ((size_t)from->p.count + 1));
    bool ok = state && mine && theirs && read_affine(from, state), same = false;
    if (ok) {
        same = take_particles(to, from, state, mine, theirs, lost);
        if (is_affine(to)) ok = turn_gradients(to, state, mine, theirs, to->p.count - to->surface);
        if (!is_affine(to) && DIM > 1 && is_affine(from) && !to->g.nmirror) turn_body(to, lost);
        if (to->surface) take_surface(to, from, mine, theirs);
        skin_take_over(to->skin, from->skin);
        to->driven = from->driven;
        sim_restart(to);
    }
    free(state), free(mine), free(theirs);
    if (!ok) return fault_set(fault, FAULT_MACHINE, "out of memory");
    if (same) return 0;
    return fault_set(fault, FAULT_USAGE, "--then: got '%s', which places its particles elsewhere",
                     to->setup->method->info.name);
}
