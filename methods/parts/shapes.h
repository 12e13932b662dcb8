/* shapes.h: weights of the nodes of one axis: tent, GIMP, quadratic and cubic spline.
 *
 * All lengths in cells: x position, b = l/h half width, r = x - x_i. W07 section 2; Bardenhagen &
 * Kober 2004. GIMP is the exact convolution of the tent with a top hat of half width b, for any b:
 *   S(r) = (I(r + b) - I(r - b)) / 2b,  I(z) = z - z|z|/2 within |z| < 1, +-1/2 beyond,
 *   G(r) = (T(r + b) - T(r - b)) / 2b,  T the tent. */
#ifndef MPMLAB_SHAPES_H
#define MPMLAB_SHAPES_H

#include <math.h>
#include "common/contract/method.h"

static inline int tent_width(double b)
{
    (void)b;
    return 2;
}

/* The cell is floor(x), not the sign of r. Where f (1 - f) < ON_NODE the particle lies on a node,
 * where the slope jumps: common/core/on_node.c replaces it. */
static inline void tent_shape(const Axis *axis, int width, const Field x, const Field b,
                              Stencil *out)
{
    (void)axis, (void)width, (void)b;
    long long on_node = 0; /* as wide as a double: see gather.c */
    for (int p = 0; p < CHUNK; p++) {
        double c = floor(x[p]), f = x[p] - c;
        out->base[p] = (int)c;
        out->table[T_S][0][p] = 1 - f, out->table[T_S][1][p] = f;
        out->table[T_G][0][p] = -1, out->table[T_G][1][p] = 1;
        on_node |= f * (1 - f) < ON_NODE;
    }
    out->on_node = on_node != 0;
}

/* The tent of WLS: a point on an upper wall belongs to the cell inside, not to the one beyond. */
static inline void inner_tent_shape(const Axis *axis, int width, const Field x, const Field b,
                                    Stencil *out)
{
    (void)width, (void)b;
    const double wall = axis->wall_hi, above = wall + 1e-9;
    for (int p = 0; p < CHUNK; p++) {
        double c = floor(x[p]);
        c = c >= wall && x[p] < above ? wall - 1 : c;
        double f = x[p] - c;
        out->base[p] = (int)c;
        out->table[T_S][0][p] = 1 - f, out->table[T_S][1][p] = f;
        out->table[T_G][0][p] = -1, out->table[T_G][1][p] = 1;
    }
}

/* Nodes |k - r| < 1 + b about the nearest node, |r| <= 1/2. */
static inline int gimp_width(double b)
{
    return b <= 0.5 ? 3 : 2 * ((int)ceil(1.5 + b) - 1) + 1;
}

/* Comparisons that vectorize; NaN comes out as `limit`, and the position's check finds it. */
static inline double at_most(double x, double limit)
{
    return x < limit ? x : limit;
}

static inline double at_least(double x, double limit)
{
    return x > limit ? x : limit;
}

/* b <= 1/2, free of branches: a is r cut off at +-b, G+ = (b + a)/2b, G- = -(b - a)/2b, S+ = (b +
 * a) G+/2 + max(r - a, 0), S- = -(b - a) G-/2 + max(a - r, 0); S between them: the rest to 1. */
static inline void gimp_shape_3(const Field x, const Field b, Stencil *out)
{
    for (int p = 0; p < CHUNK; p++) {
        const double c = floor(x[p] + 0.5), r = x[p] - c;
        const double a = at_most(at_least(r, -b[p]), b[p]), q = 0.25 / b[p];
        const double above = b[p] + a, below = b[p] - a, rest = r - a, beyond = at_least(rest, 0);
        const double half_up = above * q, half_down = below * q;
        const double up = above * half_up + beyond, down = below * half_down + (beyond - rest);
        const double slope_up = half_up + half_up, slope_down = half_down + half_down;
        out->base[p] = (int)c - 1;
        out->table[T_S][0][p] = down, out->table[T_S][1][p] = 1 - up - down,
        out->table[T_S][2][p] = up;
        out->table[T_G][0][p] = -slope_down;
        out->table[T_G][1][p] = slope_down - slope_up;
        out->table[T_G][2][p] = slope_up;
    }
}

static inline double tent_integral(double z)
{
    double c = at_most(at_least(z, -1), 1);
    return c - 0.5 * c * fabs(c);
}

static inline double tent(double z)
{
    return at_least(1 - fabs(z), 0);
}

static inline void gimp_shape(const Axis *axis, int width, const Field x, const Field b,
                              Stencil *out)
{
    (void)axis;
    if (width == 3) {
        gimp_shape_3(x, b, out);
        return;
    }
    for (int p = 0; p < CHUNK; p++) out->base[p] = (int)floor(x[p] + 0.5) - width / 2;
    for (int k = 0; k < width; k++)
        for (int p = 0; p < CHUNK; p++) {
            double r = x[p] - (out->base[p] + k), q = 0.5 / b[p];
            out->table[T_S][k][p] = q * (tent_integral(r + b[p]) - tent_integral(r - b[p]));
            out->table[T_G][k][p] = q * (tent(r + b[p]) - tent(r - b[p]));
        }
}

/* Quadratic spline about the nearest node, W11 eq 4, the weight of WLS, too: |x - x_i| < 3/2. */
static inline int spline_width(double b)
{
    (void)b;
    return 3;
}

static inline void spline_shape(const Axis *axis, int width, const Field x, const Field b,
                                Stencil *out)
{
    (void)axis, (void)width, (void)b;
    for (int p = 0; p < CHUNK; p++) {
        double c = floor(x[p] + 0.5), r = x[p] - c;
        out->base[p] = (int)c - 1;
        out->table[T_S][0][p] = 0.5 * (0.5 - r) * (0.5 - r);
        out->table[T_S][1][p] = 0.75 - r * r;
        out->table[T_S][2][p] = 0.5 * (0.5 + r) * (0.5 + r);
        out->table[T_G][0][p] = r - 0.5, out->table[T_G][1][p] = -2 * r,
        out->table[T_G][2][p] = r + 0.5;
    }
}

/* The quadratic spline with its weights folded at walls (Steffen et al. 2008): a node beyond a wall
 * gives its weight w to the two inside as 2w, -w, which is linear extrapolation: the sums of S, of
 * S x_i and of G x_i stay exact up to the wall. Nodes beyond are not touched; a particle that
 * slips past the wall keeps the weights' polynomials. */
static inline void folded_shape(const Axis *axis, int width, const Field x, const Field b,
                                Stencil *out)
{
    (void)width, (void)b;
    const double lo = axis->open_lo ? -INFINITY : axis->wall_lo;
    const double hi = axis->open_hi ? INFINITY : axis->wall_hi;
    for (int p = 0; p < CHUNK; p++) {
        const double at = floor(x[p] + 0.5), c = at + (at < lo) - (at > hi), r = x[p] - c;
        const double low = c - 1 < lo, high = c + 1 > hi;
        const double down = 0.5 * (0.5 - r) * (0.5 - r), up = 0.5 * (0.5 + r) * (0.5 + r);
        const double gdown = r - 0.5, gup = r + 0.5;
        out->base[p] = (int)c - 1;
        out->table[T_S][0][p] = (1 - low) * down - high * up;
        out->table[T_S][1][p] = 0.75 - r * r + 2 * (low * down + high * up);
        out->table[T_S][2][p] = (1 - high) * up - low * down;
        out->table[T_G][0][p] = (1 - low) * gdown - high * gup;
        out->table[T_G][1][p] = -2 * r + 2 * (low * gdown + high * gup);
        out->table[T_G][2][p] = (1 - high) * gup - low * gdown;
    }
}

/* Cubic spline: the four nodes of the particle's cell and of its two neighbours, |x - x_i| < 2. */
static inline int cubic_width(double b)
{
    (void)b;
    return 4;
}

/* Folded at walls as folded_shape: in the cell within a wall the node beyond gives its weight w to
 * the two next to it as 2w, -w. That is the natural spline, whose second derivative vanishes at the
 * wall (Steffen et al. 2008). */
static inline void cubic_shape(const Axis *axis, int width, const Field x, const Field b,
                               Stencil *out)
{
    (void)width, (void)b;
    const double lo = axis->open_lo ? -INFINITY : axis->wall_lo;
    const double hi = axis->open_hi ? INFINITY : axis->wall_hi;
    for (int p = 0; p < CHUNK; p++) {
        const double at = floor(x[p]), c = at + (at < lo) - (at >= hi);
        const double f = x[p] - c, g = 1 - f, low = c - 1 < lo, high = c + 2 > hi;
        const double first = g * g * g / 6, last = f * f * f / 6;
        const double dfirst = -0.5 * g * g, dlast = 0.5 * f * f;
        out->base[p] = (int)c - 1;
        out->table[T_S][0][p] = (1 - low) * first;
        out->table[T_S][1][p] = 2 / 3.0 - f * f * (1 - 0.5 * f) + 2 * low * first - high * last;
        out->table[T_S][2][p] = 2 / 3.0 - g * g * (1 - 0.5 * g) + 2 * high * last - low * first;
        out->table[T_S][3][p] = (1 - high) * last;
        out->table[T_G][0][p] = (1 - low) * dfirst;
        out->table[T_G][1][p] = f * (1.5 * f - 2) + 2 * low * dfirst - high * dlast;
        out->table[T_G][2][p] = g * (2 - 1.5 * g) + 2 * high * dlast - low * dfirst;
        out->table[T_G][3][p] = (1 - high) * dlast;
    }
}

/* Slopes of moving least squares: the plane through the nodes' values with weights S has the slope
 * sum_i v_i S (x_i - x)/D, D = sum_i S (x_i - x)^2, which takes the place of the derivative. D is
 * 1/4 cell^2 for the quadratic spline, 1/3 for the cubic one, less where a wall folds them; on the
 * wall it vanishes, and the derivative is the limit. */
static inline void fit_slopes(int width, const Field x, Stencil *s)
{
    Field D;
    for (int p = 0; p < CHUNK; p++) D[p] = 0;
    for (int k = 0; k < width; k++)
        for (int p = 0; p < CHUNK; p++) {
            const double r = s->base[p] + k - x[p];
            D[p] += s->table[T_S][k][p] * r * r;
        }
    for (int k = 0; k < width; k++)
        for (int p = 0; p < CHUNK; p++) {
            const double r = s->base[p] + k - x[p];
            const double slope = s->table[T_S][k][p] * r / D[p];
            s->table[T_G][k][p] = fabs(D[p]) > 1e-9 ? slope : s->table[T_G][k][p];
        }
}

/* `shape=spline|gimp|cubic`, the first parameter of methods that have several. */
enum { BY_SPLINE, BY_GIMP, BY_CUBIC };

#define SHAPE_PARAM(usual)                                                                         \
    {                                                                                              \
        "shape", usual, 0, 2, "", "weights: quadratic or cubic spline folded at walls, or GIMP",   \
            "", "spline|gimp|cubic"                                                                \
    }

static inline void choose_shape(const double par[], Method *own)
{
    static int (*const widths[])(double) = {spline_width, gimp_width, cubic_width};
    void (*const shapes[])(const Axis *, int, const Field, const Field,
                           Stencil *) = {folded_shape, gimp_shape, cubic_shape};
    own->width = widths[(int)par[0]];
    own->shape = shapes[(int)par[0]];
}

#endif
