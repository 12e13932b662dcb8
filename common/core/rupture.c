/* rupture.c: stress of a chunk, and tension cut-off (problem.h): a particle whose largest principal
 * stress exceeds its strength has the strength 0 from then on, and bears no tension. The energy
 * that it stored in tension is recorded in `lost`, to be subtracted from external work. */
#include "sim.h"

static void load(const Chunk *c, int p, Mat F)
{
    for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p];
}

/* Removes the tension from the stress of broken particles. */
static void take_tension(const Material *mat, const Chunk *c, Field T[NMAT])
{
    for (int p = 0; p < CHUNK; p++) {
        Mat F, t;
        if (c->strength[p] > 0) continue;
        load(c, p, F);
        material_without_tension(mat, F, t);
        for (int k = 0; k < NMAT; k++) T[k][p] = t[k];
    }
}

static void break_particles(const Material *mat, const Chunk *c, Field T[NMAT])
{
    for (int p = 0; p < CHUNK; p++) {
        Mat F, t;
        double psi;
        const double *f[NMAT];
        load(c, p, F);
        for (int k = 0; k < NMAT; k++) t[k] = T[k][p], f[k] = &F[k];
        if (!(c->strength[p] > 0 && material_largest_stress(t) > c->strength[p] * determinant(F)))
            continue;
        material_stored_energy(mat, 1, f, &psi);
        c->strength[p] = 0;
        c->lost[p] = c->V0[p] * (psi - material_without_tension(mat, F, t));
    }
}

void sim_stress_now(const Sim *sim, const Chunk *c, Field T[NMAT])
{
    const Material *mat = &sim->setup->scene->mat;
    material_kirchhoff(mat, (const double *const *)c->F, T);
    if (c->strength) take_tension(mat, c, T);
}

void sim_stress(const Sim *sim, const Chunk *c, Field T[NMAT])
{
    const Material *mat = &sim->setup->scene->mat;
    material_kirchhoff(mat, (const double *const *)c->F, T);
    if (!c->strength) return;
    break_particles(mat, c, T);
    take_tension(mat, c, T);
}

void sim_start_strength(Sim *sim)
{
    const Scene *scene = sim->setup->scene;
    Particles *p = &sim->p;
    if (!scene->problem->strength) return;
    for (int s = 0; s < p->n; s++) p->field[AT_LOST][s] = 0;
    scene->problem->strength(scene, p->n, (const double *const *)(p->field + AT_X0),
                             p->field[AT_STRENGTH]);
}

double sim_lost(const Sim *sim)
{
    const double *lost = sim->p.field[AT_LOST];
    double sum = 0;
    for (int s = 0; lost && s < sim->p.n; s++)
        if (sim->p.id[s] >= 0) sum += lost[s];
    return sum;
}
