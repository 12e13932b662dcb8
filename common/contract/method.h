/* method.h: the plug-in contract: how a method moves information between particles and grid.
 *
 * A method is a const struct of data and of small stages. Each stage is a plain loop over the 64
 * particles of a chunk, called once per chunk: the call is free and the compiler vectorizes the
 * loop. The shared core (scheme.h) scatters and gathers between chunk and grid:
 *
 *   deposit   node[lane] += w_ip[lane] (A_p[lane] + sum_d B_pd[lane] (x_i - x_p)_d)
 *   gather    sums_p[lane] = sum_i w_ip[lane] node[lane]
 *
 * with w_ip = S_ip for the lanes below FLUX and dS_ip/dx_b for the lane FLUX + b DIM + a. Lanes of
 * a deposit: dim.h. A gather finds v in lanes 0 .. DIM-1, a in DIM .. 2 DIM - 1 and v once more in
 * the lanes from FLUX on, which so become the velocity gradient. Slopes B exist on the momentum
 * lanes only (GE, TPIC and APIC need no more).  */
#ifndef MPMLAB_METHOD_H
#define MPMLAB_METHOD_H

#include <stdbool.h>
#include "dim.h"
#include "common/base/info.h"
#include "points.h"

enum {
    MAX_WIDTH = 33,                    /* nodes per axis that a stencil may span */
    MAX_ROUNDS = 16,                   /* rounds of a velocity filter */
    MAX_OWN = IN_THIS_DIM(2, 8, 24),   /* fields of a method's own per particle */
    MAX_PARTS = IN_THIS_DIM(3, 9, 27), /* parts whose velocities an update may read */
    MAX_LIST = IN_THIS_DIM(4, 16, 64), /* nodes that a particle may list */
    POINT_SUMS = 2 * LANES             /* in the sums of an update, DIM per point */
};

typedef enum { CD, UVF, MUSL, USL, USF, INTEGRATORS } Integrator; /* step.c */

/* What a particle's half width l follows: l0 |F_dd|, l0 U_dd, l0 (stretch.h); and how its F follows
 * L (strain.h). */
typedef enum { DOMAIN_FXX, DOMAIN_STRETCH, DOMAIN_UNDEFORMED } Domain;
typedef enum { STRAIN_LINEAR, STRAIN_EXPONENTIAL, STRAIN_SUBCYCLED } StrainUpdate;

/* Where stencils stand: at the particles, with sigma and the gradient in x; or at their reference
 * positions X, once for the whole run, with the first Piola stress P and the gradient in X. */
typedef enum { FRAME_CURRENT, FRAME_TOTAL } Frame;

/* What a gather updates; the integrator chooses. */
enum {
    TAKE_V = 1,     /* velocities from a */
    TAKE_X = 2,     /* positions from v */
    TAKE_F = 4,     /* L from v, and F from L */
    TAKE_L = 8,     /* L only: a refreshed gradient */
    STASH_X = 16,   /* remember the displacement dt v, move later */
    MOVE_STASH = 32 /* move by what was remembered */
};

/* 64 particles: pointers into the arrays of sim.h; L, u and w are NULL where not kept. */
typedef struct Chunk {
    const double *par; /* values of the method's parameters, in the order of Info.params */
    double *x[DIM], *v[DIM], *F[NMAT], *L[NMAT], *u[DIM], *w[DIM];
    const double *X[DIM], *m, *V0;
    const double *normal[DIM]; /* reference normals of surface points, or NULL */
    const int *id;
    double *const *own;          /* use own_field() */
    double *strength, *lost;     /* of scenes whose matter breaks, or NULL */
    const struct NodeList *list; /* in `update`: general weights as they were gathered, or NULL */
    size_t first;
} Chunk;

/* Field k of the method's own, of this chunk. */
static inline double *own_field(const Chunk *c, int k)
{
    return c->own[k] + c->first;
}

/* The tables of one axis of a chunk: for node base + k and particle p, at distance r = x_i - x_p.
 */
enum { T_S, T_G, T_R, TABLES }; /* S [-], G = dS/dx_p [1/cell], R = S r [cell] */

typedef struct Stencil {
    _Alignas(CACHE_LINE) int base[CHUNK]; /* first node of each particle's stencil */
    Field table[TABLES][MAX_WIDTH];
    bool on_node; /* tents: some particle lies on a node of this axis (on_node.c) */
} Stencil;

/* A tent's particle closer to a node than this [cells] lies on it. */
#define ON_NODE 1e-10

/* What a shape may know of its axis: where walls stand, in cells from node 0 (or +-infinity). */
typedef struct Axis {
    double wall_lo, wall_hi;
    bool open_lo, open_hi; /* the wall leaves the motion across it free: the body may cross it */
} Axis;

/* What a chunk deposits. */
typedef struct Payload {
    _Alignas(CACHE_LINE) Field A[LANES];
    Field B[DIM][DIM]; /* [axis d][component a]: m L_ad of the momentum lanes, if affine; with
                        * `moments` m L_ad D_d, D_d = sum_i S (x_i - x_p)_d^2 [m^2] as it is now */
} Payload;

/* Weights that are not products over the axes: per particle a list of nodes, for all of a chunk of
 * the same length, in `points` parts of `part` nodes. at: node number; the same node may stand in
 * several places. Entry k of part c has the weight S_ip = S[c] N[k] and the gradient G[][c] N[k]
 * [1/cell]: parts of one node, N = 1, hold any weights; CPDI's parts are the nodes about a corner.
 */
typedef struct NodeList {
    int points, part;
    _Alignas(CACHE_LINE) long long at[MAX_LIST][CHUNK];
    Field N[MAX_LIST], S[MAX_LIST], G[DIM][MAX_LIST];
    Field v[DIM][MAX_PARTS]; /* [m/s] with `modes`: velocity that a part deposits beyond v_p */
    int cells;               /* per unit length, for an update that asks */
} NodeList;

/* The grid, as `list` and `reach` need it. Positions in cells count from node 0. */
typedef struct Place {
    int cells;             /* per unit length */
    int origin[DIM];       /* node 0 lies at x = origin/cells */
    long long stride[DIM]; /* nodes from one to the next along an axis */
    const Axis *axis;      /* [DIM] walls */
    double half;           /* l0/h: half width of an undeformed particle's box [cells] */
    double reach;          /* no node may lie farther from a particle than this and a cell */
} Place;

struct Sim;

typedef struct Method {
    Info info;
    unsigned valid;       /* bit i set: stable with Integrator i (published, or T-5) */
    unsigned valid_fresh; /* further ones, stable only with refresh=1 */
    int integrator[4];    /* default by dimension, [0] unused */
    bool keeps_L;         /* the particle carries its velocity gradient from step to step */
    bool affine;          /* payload fills B */
    bool moments;         /* update also reads, and B holds, moments of v about the particle */
    double pic; /* share of v_p that update replaces by sum_i S v_i: 0 FLIP, 1 PIC and filters */
    bool turns; /* keeps angular momentum, sum m (x x v) + its moments */
    bool linear_exact;       /* projects linear fields exactly from any particle set */
    bool surface;            /* needs surface particles: */
    double surface_per_cell; /* so many along a cell's length; 0: as dense as particles */
    bool scene_distance;     /* asks the scene for distances from its surface */
    bool about_node;         /* sorted by nearest node, though an odd stencil does not ask for it */
    bool wall_images;        /* gathers from images of nodes beyond walls, not from held nodes */
    bool slopes_fitted;      /* G = S (x_i - x_p)/D, no derivative of S */
    Frame frame;             /* default */
    bool smooth;             /* weights are C1: S ~ eps^2, dS/dx ~ eps at the edge of a support */

    /* Nodes per axis for half widths up to b [cells]; at most MAX_WIDTH. */
    int (*width)(double b);

    /* S, G and base of one axis: positions x and half widths b [cells]. */
    void (*shape)(const Axis *axis, int width, const Field x, const Field b, Stencil *out);

    /* General weights, instead of `shape`; then `width` is that of what `reach` finds: the farthest
     * that a point of each particle lies from it along any axis [cells]. x: as Place has it. In the
     * total frame a chunk's x is X, and F = I. They take neither slopes B nor moments. */
    void (*list)(const Chunk *c, const Place *g, const Field x[], NodeList *out);
    void (*reach)(const Chunk *c, const Place *g, Field out);

    /* Parts whose velocities an update reads, at most MAX_PARTS: component a of part c, sum_k N_k
     * v_a, is sums[POINT_SUMS + c DIM + a]. In the total frame these are 0, because there points
     * do not move; with `modes` they are gathered there, too. */
    int points;
    bool modes; /* each part deposits the velocity NodeList.v in addition to the particle's */

    /* Names of the method's own fields, at most MAX_OWN, ended by NULL; or NULL: none. They are
     * kept, sorted and written with the particle's others. `start` fills them. */
    const char *const *own;
    void (*start)(const Chunk *c, const Place *g);

    /* A (and B) from the particles; T is V0 J sigma / h [N] (G is per cell), or zero. */
    void (*payload)(const Chunk *c, const Field T[NMAT], Payload *out);

    /* Particles from the gathered sums, over dt [s]; `take`: TAKE_*. With `moments` a second line
     * follows: lane LANES + FLUX + b DIM + a is sum_i S v_a (x_i - x_p)_b [m^2/s]. */
    void (*update)(const Chunk *c, const Field sums[], double dt, unsigned take);

    /* Velocity filter, or NULL: coefficients c[0 .. rounds] of sum_l c_l (S+ S)^l v; returns
     * rounds, at most MAX_ROUNDS. `par`: the method's parameters. A gather then finds the filtered
     * velocity in the place of a. filter_first = true (XPIC): filters v - dt a, and only the
     * particle velocities use the result. false (FMPM): filters the accelerated v; velocities,
     * positions and L all use the result, in every projection. */
    int (*filter)(const double *par, double c[]);
    bool filter_first;

    /* Optional, for methods whose nodes do not come from the deposit above (WLS: least squares and
     * an integral over cells). `assemble` takes the place of the deposit and leaves every node as a
     * deposit would: lane 0 mass, momentum, spare lanes mass, internal force in the lanes from FLUX
     * on, body force in Grid.force; on the real side of symmetry lines only. `repair` comes after
     * symmetry has folded the nodes and before v = p/m + dt f/m. */
    void (*assemble)(struct Sim *sim, double t, bool force);
    void (*repair)(struct Sim *sim, double dt);

    /* Optional, for methods whose internal forces are an integral over cells and all else the
     * deposit above (IMPM). Comes after a deposit to which particles bring no stress, T = 0, and
     * adds to the lanes from FLUX on, on the real side of symmetry lines only. The integral is one
     * over the cells as they are now: frame=total is refused. */
    void (*integrate)(struct Sim *sim);

    /* Shows the polygons that the last `assemble` integrated over, for output; or NULL. */
    void (*patches)(const struct Sim *sim, PatchVisit *visit, void *own);

    /* Unit outward normal of the body's surface near a node, by the last `assemble`; false: no
     * surface is near. Contact uses it. NULL: the method reconstructs no surface. */
    bool (*normal)(const struct Sim *sim, size_t node, double n[DIM]);

    /* make: allocates the workspace Sim.own once per run, node_bytes per grid node; false: out of
     * memory. free: frees it. adapt: changes the run's own copy of this struct according to the
     * parameters; called before everything else. Any of them may be NULL. */
    size_t node_bytes;
    bool (*make)(struct Sim *sim);
    void (*free)(struct Sim *sim);
    void (*adapt)(const double par[], struct Method *own);
} Method;

/* The copy of a method that a run with these parameters uses. */
static inline Method method_adapted(const Method *m, const double par[])
{
    Method own = *m;
    if (own.adapt) own.adapt(par, &own);
    return own;
}

/* All methods in the order of methods/methods.def, ended by NULL. */
extern const Method *const methods[];

#endif
