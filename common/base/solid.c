/* solid.c: see solid.h. */
#include "solid.h"
#include <math.h>

/* The mean of a piece's vertices. */
static void middle_of(const Polyhedron *p, int piece, double o[3])
{
    int n = 0;
    for (int a = 0; a < 3; a++) o[a] = 0;
    for (int v = 0; v < POLYHEDRON_VERTICES; v++) {
        if (p->piece[v] != piece) continue;
        for (int a = 0; a < 3; a++) o[a] += p->x[v][a];
        n++;
    }
    for (int a = 0; a < 3 && n > 0; a++) o[a] /= n;
}

/* The tetrahedron over side k of a face, its corners relative to o, which is the fourth; its
 * volume. */
static double tetrahedron(const Polyhedron *p, const Face *f, int k, const double o[3],
                          double t[3][3])
{
    double n[3];
    for (int a = 0; a < 3; a++) {
        t[0][a] = f->apex[a] - o[a];
        t[1][a] = p->x[f->vertex[k]][a] - o[a];
        t[2][a] = p->x[f->vertex[(k + 1) % f->sides]][a] - o[a];
    }
    for (int a = 0; a < 3; a++)
        n[a] = t[1][(a + 1) % 3] * t[2][(a + 2) % 3] - t[1][(a + 2) % 3] * t[2][(a + 1) % 3];
    return (t[0][0] * n[0] + t[0][1] * n[1] + t[0][2] * n[2]) / 6;
}

void solid_measure(const Polyhedron *p, int piece, bool second, Solid *out)
{
    double o[3], t[3][3], sum[3];
    *out = (Solid){0};
    middle_of(p, piece, o);
    for (const Face *f = p->face; f < p->face + p->faces; f++)
        for (int k = 0; k < f->sides && f->piece == piece; k++) {
            const double V = tetrahedron(p, f, k, o, t);
            out->volume += V;
            for (int a = 0; a < 3; a++) sum[a] = t[0][a] + t[1][a] + t[2][a];
            for (int a = 0; a < 3; a++) {
                out->centroid[a] += V / 4 * sum[a];
                for (int b = a; second && b < 3; b++)
                    out->second[tensor_index(a, b)] += V / 20 *
                                                       (sum[a] * sum[b] + t[0][a] * t[0][b] +
                                                        t[1][a] * t[1][b] + t[2][a] * t[2][b]);
            }
        }
    for (int a = 0; a < 3 && out->volume > 0; a++) out->centroid[a] /= out->volume;
    for (int a = 0; a < 3; a++)
        for (int b = a; second && b < 3; b++)
            out->second[tensor_index(a, b)] -= out->volume * out->centroid[a] * out->centroid[b];
    for (int a = 0; a < 3; a++) out->centroid[a] += o[a];
}

/* Eight points centroid + L s, s = (+-1, +-1, +-1), L L^T = second moments over volume, by
 * Cholesky's method with the axes in the order first, second, third. False: some lie outside. */
static bool matched_points(const Solid *m, const int axis[3], double x[8][3])
{
    double L[3][3] = {{0}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j <= i; j++) {
            double sum = m->second[tensor_index(axis[i], axis[j])] / m->volume;
            for (int k = 0; k < j; k++) sum -= L[i][k] * L[j][k];
            if (i == j && !(sum > 0)) return false;
            L[i][j] = i == j ? sqrt(sum) : sum / L[j][j];
        }
    for (int q = 0; q < 8; q++)
        for (int i = 0; i < 3; i++) {
            double *own = &x[q][axis[i]];
            *own = m->centroid[axis[i]];
            for (int k = 0; k <= i; k++) *own += (q >> k & 1 ? 1 : -1) * L[i][k];
            if (!(*own >= 0 && *own <= 1)) return false;
        }
    return true;
}

static double within_cube(double x)
{
    return x < 0 ? 0 : x > 1 ? 1 : x;
}

double solid_centre(const Solid *s, double x[3])
{
    for (int a = 0; a < 3; a++) x[a] = within_cube(s->centroid[a]);
    return s->volume;
}

/* The four points of each tetrahedron of a piece. */
static int fan_points(const Polyhedron *p, int piece, double x[][3], double weight[])
{
    const double far = 0.1381966011250105, near = 1 - 3 * far; /* (5 - sqrt 5)/20 */
    double o[3], t[3][3];
    int n = 0;
    middle_of(p, piece, o);
    for (const Face *f = p->face; f < p->face + p->faces; f++)
        for (int k = 0; k < f->sides && f->piece == piece; k++) {
            const double V = tetrahedron(p, f, k, o, t);
            for (int q = 0; q < 4; q++, n++) {
                weight[n] = V / 4;
                for (int a = 0; a < 3; a++) {
                    double at = far * (t[0][a] + t[1][a] + t[2][a]);
                    if (q < 3) at += (near - far) * t[q][a];
                    x[n][a] = within_cube(o[a] + at);
                }
            }
        }
    return n;
}

int solid_points(const Polyhedron *p, int piece, const Solid *solid, double x[MAX_SOLID_POINTS][3],
                 double weight[MAX_SOLID_POINTS])
{
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                    {2, 1, 0}, {1, 0, 2}, {0, 2, 1}};
    for (int k = 0; k < 6; k++) {
        if (!matched_points(solid, order[k], x)) continue;
        for (int q = 0; q < 8; q++) weight[q] = solid->volume / 8;
        return 8;
    }
    return fan_points(p, piece, x, weight);
}
