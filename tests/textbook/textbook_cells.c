/* textbook_cells.c: planes fitted at nodes and in the middle of cells, and the internal force by
 * one point per cell (Sulsky & Gong 2016, read as methods/impm.c says). */
#include <math.h>
#include <stdlib.h>
#include "textbook_sight.h"

enum { V = 0, SIGMA = DIM, SAMPLES = DIM + DIM * DIM };

/* Sums over the samples of W (1, r) (1, r)^T and W (1, r) f, r [cells]; the largest W; the volumes
 * times the tent [cells]. */
typedef struct TwinFit {
    double M[DIM + 1][DIM + 1], load[DIM + 1][SAMPLES], most, volume;
} TwinFit;

bool twin_make_fits(Twin *w)
{
    w->fit = calloc((size_t)w->nodes, sizeof *w->fit);
    return w->fit;
}

/* W11 eq 4 */
static double weight(double r)
{
    const double q = fabs(r);
    return q < 0.5 ? 0.75 - q * q : q < 1.5 ? 0.5 * (1.5 - q) * (1.5 - q) : 0;
}

static void add_to(TwinFit *fit, const double r[DIM], const double f[SAMPLES], double volume)
{
    double W = 1, one[DIM + 1] = {1};
    for (int d = 0; d < DIM; d++) {
        W *= weight(r[d]);
        volume *= fmax(1 - fabs(r[d]), 0);
        one[1 + d] = r[d];
    }
    for (int i = 0; i <= DIM; i++) {
        for (int j = 0; j <= DIM; j++) fit->M[i][j] += W * one[i] * one[j];
        for (int k = 0; k < SAMPLES; k++) fit->load[i][k] += W * one[i] * f[k];
    }
    fit->most = fmax(fit->most, W);
    fit->volume += volume;
}

/* A sample to all places within two cells. */
static void add_sample(Twin *w, const TwinParticle *p, bool force)
{
    double sigma[DIM][DIM] = {{0}}, f[SAMPLES];
    if (force) twin_cauchy(&w->setup->scene->mat, p->F, sigma);
    for (int a = 0; a < DIM; a++) {
        f[V + a] = p->v[a];
        for (int b = 0; b < DIM; b++) f[SIGMA + a * DIM + b] = 0.5 * (sigma[a][b] + sigma[b][a]);
    }
    const double volume = p->V0 * twin_det(p->F) / pow(w->h, DIM);
    for (int k = 0; k < (int)pow(4, DIM); k++) {
        long at = 0;
        double r[DIM];
        bool inside = true; /* the grid, that a lost particle may have left */
        for (int d = DIM - 1; d >= 0; d--) {
            const double x = p->x[d] / w->h - w->shift;
            const int index = (int)floor(x) - 1 + k / (int)pow(4, d) % 4;
            r[d] = x - index;
            inside &= index >= w->origin[d] && index < w->origin[d] + w->size[d];
            at = at * w->size[d] + index - w->origin[d];
        }
        if (inside) add_to(&w->fit[at], r, f, volume);
    }
}

/* Planes about all nodes (shift 0) or cells (.5) from the particles and their images. */
static void fit_all(Twin *w, double shift, bool force)
{
    w->shift = shift;
    for (long i = 0; i < w->nodes; i++) w->fit[i] = (TwinFit){.most = 0};
    for (int k = 0; k < w->n; k++) twin_images(w, &w->p[k], add_sample, force, 0);
}

/* Gauss' elimination; the solution takes the place of the loads. Returns the determinant. */
static double eliminate(TwinFit *fit)
{
    double det = 1;
    for (int k = 0; k <= DIM; k++) {
        det *= fit->M[k][k];
        for (int i = 0; i <= DIM; i++) {
            const double factor = fit->M[i][k] / fit->M[k][k];
            for (int j = 0; j <= DIM && i != k; j++) fit->M[i][j] -= factor * fit->M[k][j];
            for (int s = 0; s < SAMPLES && i != k; s++) fit->load[i][s] -= factor * fit->load[k][s];
        }
    }
    for (int k = 0; k <= DIM; k++)
        for (int s = 0; s < SAMPLES; s++) fit->load[k][s] /= fit->M[k][k];
    return det;
}

/* Values in the middle: the plane's, or the mean where there is none. */
static void values(const Twin *w, const TwinFit *fit, double out[SAMPLES])
{
    TwinFit plane = *fit;
    const double total = fit->M[0][0];
    const bool whole =
        fit->most > w->setup->method_par[0] && eliminate(&plane) > 1e-10 * pow(total, DIM + 1);
    for (int s = 0; s < SAMPLES; s++)
        out[s] = whole ? plane.load[0][s] : total > 0 ? fit->load[0][s] / total : 0;
}

void twin_fit_velocities(Twin *w)
{
    double value[SAMPLES];
    fit_all(w, 0, false);
    for (long i = 0; i < w->nodes; i++) {
        if (!(w->node[i].m > 0)) continue;
        values(w, &w->fit[i], value);
        for (int a = 0; a < DIM; a++) w->node[i].p[a] = w->node[i].m * value[V + a];
    }
}

/* How full the cell above node i is; 0 beyond walls. */
static double share(const Twin *w, long i)
{
    long rest = i;
    for (int d = 0; d < DIM; rest /= w->size[d++]) {
        const double index = (double)(rest % w->size[d] + w->origin[d]);
        if (index < w->wall_lo[d] || index >= w->wall_hi[d]) return 0;
    }
    return fmin(1, w->fit[i].volume / pow(0.875, DIM));
}

void twin_add_cell_forces(Twin *w)
{
    double value[SAMPLES];
    fit_all(w, 0.5, true);
    for (long i = 0; i < w->nodes; i++) {
        const double volume = share(w, i) * pow(w->h, DIM);
        if (!(volume > 0)) continue;
        values(w, &w->fit[i], value);
        for (int k = 0; k < 1 << DIM; k++) {
            long at = i, stride = 1;
            for (int d = 0; d < DIM; stride *= w->size[d++]) at += (k >> d & 1) * stride;
            for (int a = 0; a < DIM; a++)
                for (int b = 0; b < DIM; b++)
                    w->node[at].f[a] -= volume * value[SIGMA + a * DIM + b] *
                                        (k >> b & 1 ? 1 : -1) / (w->h * (1 << (DIM - 1)));
        }
    }
}
