/* modes.h: modes of a particle (Fu, Guo, Gast, Jiang & Teran 2017): products over the axes of
 * polynomials in the distance z = i - x of its three nodes from it [cells] that are orthogonal
 * under the weights w of these nodes,
 *   1,  z,  z^2 - (T/D) z - D,   D = sum w z^2, T = sum w z^3.
 * The quadratic B-spline has D = 1/4. Digit d of a mode's or a node's number, to the base 3, is its
 * degree or its place along axis d. */
#ifndef MPMLAB_MODES_H
#define MPMLAB_MODES_H

#include "common/contract/method.h"

/* Modes beyond v itself: first of degree 1, kept as L, then of degree 2 (xx, xy, yy, xz, yz, zz),
 * kept as own fields. */
enum { MODES = IN_THIS_DIM(2, 5, 9), NODES = IN_THIS_DIM(3, 9, 27) };

#define MODE_X(m)   "vx_" #m
#define MODE_XY(m)  "vx_" #m, "vy_" #m
#define MODE_XYZ(m) "vx_" #m, "vy_" #m, "vz_" #m
#define MODES_2(OF) OF(xx), OF(xy), OF(yy)
#define MODES_3(OF) MODES_2(OF), OF(xz), OF(yz), OF(zz)
#define MODE_NAMES  IN_THIS_DIM(MODE_X(xx), MODES_2(MODE_XY), MODES_3(MODE_XYZ))

static inline int mode_number(int k)
{
    static const int slopes[] = {1, 3, 9}, second[] = {2, 4, 6, 10, 12, 18};
    return k < DIM ? slopes[k] : second[k - DIM];
}

static inline int mode_digit(int number, int axis)
{
    return axis == 0 ? number % 3 : axis == 1 ? number / 3 % 3 : number / 9;
}

/* Component a of mode k [m/s], but for a factor: slopes are kept per metre. */
static inline double *mode_field(const Chunk *c, int k, int a)
{
    return k < DIM ? c->L[a * DIM + k] : own_field(c, (k - DIM) * DIM + a);
}

/* The three nodes are those about the particle's nearest one. */
static inline void reach_of_modes(const Chunk *c, const Place *grid, Field out)
{
    (void)c, (void)grid;
    for (int p = 0; p < CHUNK; p++) out[p] = 0.5;
}

/* At the start modes of degree 2 are 0; those of degree 1 are the initial gradient. */
static inline void start_modes(const Chunk *c, const Place *grid)
{
    (void)grid;
    for (int k = 0; k < (MODES - DIM) * DIM; k++)
        for (int p = 0; p < CHUNK; p++) own_field(c, k)[p] = 0;
}

/* The polynomials of one axis at its nodes, and 1 / sum w value^2. Where a wall folds weights they
 * are those of two nodes (on the wall: of one), and the others are 0. */
typedef struct AxisModes {
    double value[3][3], inverse[3];
} AxisModes;

static inline AxisModes axis_modes(const double w[3])
{
    AxisModes m = {0};
    const double x = w[1] + 2 * w[2];
    double D = 0, T = 0;
    for (int k = 0; k < 3; k++) {
        const double z = k - x;
        D += w[k] * z * z, T += w[k] * z * z * z;
    }
    const double tilt = D > 1e-9 ? T / D : 0;
    for (int k = 0; k < 3; k++) {
        const double z = k - x;
        m.value[0][k] = 1, m.value[1][k] = z, m.value[2][k] = z * z - tilt * z - D;
    }
    for (int r = 0; r < 3; r++) {
        double norm = 0;
        for (int k = 0; k < 3; k++) norm += w[k] * m.value[r][k] * m.value[r][k];
        m.inverse[r] = norm > 1e-9 ? 1 / norm : 0;
    }
    return m;
}

/* Those of particle p, whose nodes are the parts of the list. */
static inline void modes_of(const NodeList *list, int p, AxisModes m[DIM])
{
    for (int d = 0; d < DIM; d++) {
        double w[3] = {0};
        for (int n = 0; n < NODES; n++) w[mode_digit(n, d)] += list->S[n][p];
        m[d] = axis_modes(w);
    }
}

/* Value of mode k at node n. */
static inline double mode_value(const AxisModes m[DIM], int k, int n)
{
    double value = 1;
    for (int d = 0; d < DIM; d++)
        value *= m[d].value[mode_digit(mode_number(k), d)][mode_digit(n, d)];
    return value;
}

/* The nodes of stencils of width 3, by number, as parts. */
static inline void list_nodes(const Place *grid, const Stencil s[DIM], NodeList *out)
{
    out->points = NODES, out->part = 1, out->cells = grid->cells;
    for (int n = 0; n < NODES; n++)
        for (int p = 0; p < CHUNK; p++) {
            out->at[n][p] = 0, out->N[n][p] = out->S[n][p] = 1;
            for (int e = 0; e < DIM; e++) out->G[e][n][p] = 1;
            for (int d = 0; d < DIM; d++) {
                const int k = mode_digit(n, d);
                out->at[n][p] += (s[d].base[p] + k) * grid->stride[d];
                out->S[n][p] *= s[d].table[T_S][k][p];
                for (int e = 0; e < DIM; e++)
                    out->G[e][n][p] *= s[d].table[e == d ? T_G : T_S][k][p];
            }
        }
}

/* Velocities of the modes at the nodes. */
static inline void list_modes(const Chunk *c, NodeList *list)
{
    for (int p = 0; p < CHUNK; p++) {
        AxisModes m[DIM];
        modes_of(list, p, m);
        for (int n = 0; n < NODES; n++)
            for (int a = 0; a < DIM; a++) {
                double v = 0;
                for (int k = 0; k < MODES; k++)
                    v += mode_field(c, k, a)[p] * mode_value(m, k, n) *
                         (k < DIM ? 1.0 / list->cells : 1);
                list->v[a][n][p] = v;
            }
    }
}

/* The modes of the nodes' velocities. */
static inline void take_modes(const Chunk *c, const Field sums[])
{
    for (int p = 0; p < CHUNK; p++) {
        AxisModes m[DIM];
        modes_of(c->list, p, m);
        for (int k = 0; k < MODES; k++) {
            double scale = k < DIM ? c->list->cells : 1;
            for (int d = 0; d < DIM; d++) scale *= m[d].inverse[mode_digit(mode_number(k), d)];
            for (int a = 0; a < DIM; a++) {
                double sum = 0;
                for (int n = 0; n < NODES; n++)
                    sum +=
                        c->list->S[n][p] * mode_value(m, k, n) * sums[POINT_SUMS + n * DIM + a][p];
                mode_field(c, k, a)[p] = scale * sum;
            }
        }
    }
}

#endif
