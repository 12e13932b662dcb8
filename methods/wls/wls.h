/* wls.h: what the files of the weighted-least-squares methods share (W11 sections 3, 4).
 *
 *   wls/moments.c   moments and loads of every node (eqs 7-9), with kernel.h; in 3D with space.h
 *   wls/fold.c      symmetry lines
 *   wls/fit.c       planes from them (eqs 10-12)
 *   wls/condition.c which nodes are spurious (3.5)
 *   wls/surface.c   signed distance of nodes from flagged surface points (eqs 13-17)
 *   wls/bend.c      distance and curvature of curved surfaces
 *   wls/points.c    integration points of a cut cell, whose shape (eq 18) is found by marching
 *                   squares and cubes: common/base/polygon.c, polyhedron.c, solid.c
 *   wls/cells.c     integrals over full and cut cells (eqs 19-24)
 *   wls/inertia.c   accelerations towards the consistent mass matrix
 *   wls/velocity.c  velocities corrected for what fit and return to particles smooth out
 *   wls/spread.c    forces of spurious nodes to their neighbours
 *   wls/nodes.c     spurious nodes and nodes without mass (3.5, 4.5)
 *   wls/patches.c   cells as polygons, for output
 *   wls/step.c      their order, workspace
 *   wls/centres.c   IMPM: planes of cells, integrals by one point
 *
 * Momentum. Forces are integrals over cells, with sum_i G_i = 0 at every point: on the grid
 * internal forces and the reactions at walls sum to zero. Particles receive dt sum_i M_i a_i with
 * M_i = sum_p S_ip m_p, but m_i is integrated over cells: the return adds dt sum_i (M_i - m_i) a_i,
 * a quadrature error near surfaces and walls. A spurious node moves with a mean a' of its
 * neighbours, which adds dt m_i (a' - a_i). The fit adds nothing, since particles keep their v and
 * are given a. The sum of these terms is the drift that the ledger reports; wls_record_change keeps
 * it out of the walls' impulse.
 *
 * Lengths are in cells; r = x_p - x_i. A node's function is f(r) = c0 + c . r of each quantity. */
#ifndef MPMLAB_WLS_H
#define MPMLAB_WLS_H

#include "common/base/polyhedron.h"
#include "common/core/sim.h"

/* Parameters of wls, wls2 and ge_wls, in the order of their lists. */
enum {
    P_STRESS,
    P_QUADRATURE,
    P_DISTANCE,
    P_SPURIOUS,
    P_RETURN,
    P_AVERAGE,
    P_MASS,
    P_VELOCITY,
    P_MOTION,
    P_HERMITE,
    P_TRIGGER,
    P_SURFACE_PER_CELL,
    P_CONDITION
};
enum { STRESS_LINEAR, STRESS_C0 };
enum { QUADRATURE_CENTROID, QUADRATURE_EXACT, QUADRATURE_GAUSS16, QUADRATURE_SAMPLES16 };
enum { CONDITION_WEIGHT, CONDITION_DETERMINANT, CONDITION_COUNT };
enum { DISTANCE_WEIGHTED_MEAN, DISTANCE_NORMALS, DISTANCE_CURVED, DISTANCE_EXACT };
enum { SPURIOUS_CONSTANT, SPURIOUS_EXTRAPOLATE };
enum { RETURN_LINEAR, RETURN_SPLINE };
enum { AVERAGE_WEIGHTED, AVERAGE_LITERAL, AVERAGE_FOLDED };
enum { MASS_LUMPED, MASS_CORRECTED };
enum { VELOCITY_PLAIN, VELOCITY_CORRECTED };
enum { MOTION_LAGGED, MOTION_CONSISTENT };

enum {
    CORNERS = 1 << DIM,
    PAIRS = DIM * (DIM + 1) / 2,
    NEIGHBOURS = IN_THIS_DIM(3, 9, 27),
    CORNER_PAIRS = CORNERS * (CORNERS + 1) / 2
};

/* Lines of a node. Before the solution: moments, then loads of all quantities times 1, r_0, r_1,
 * ...; after it the coefficients c0, c_0, c_1, ... stand where the loads were. */
enum { FIT_MOMENTS, FIT_VALUE, FIT_SLOPE, FIT = FIT_SLOPE + DIM };

/* Lanes of the moments: sums of W, beta times the tent S (eq 13), W r_d, W r_d r_e (d <= e). */
enum { M_ONE, M_BETA, M_FIRST, M_SECOND = M_FIRST + DIM, MOMENTS = M_SECOND + PAIRS };

/* Lanes of the quantities: v, rho, f_ext = rho b, sigma (a <= b). */
enum {
    Q_V,
    Q_RHO = Q_V + DIM,
    Q_FORCE = Q_RHO + 1,
    Q_SIGMA = Q_FORCE + DIM,
    QUANTITIES = Q_SIGMA + PAIRS
};

/* In 3D the quantities leave DIM lanes free: these hold r, and of the line of moments M_ONE and
 * M_BETA alone are used (space.h). R_RIDES: is it so? */
enum { Q_R = LANES - DIM, R_RIDES = (int)Q_R >= (int)QUANTITIES };

/* Lanes of sums over surface points, all times the tent: 1, r_d, n_d, r . n in one line; r_d r_e
 * (d <= e) and r_d n_e in a second. */
enum { K_ONE, K_FIRST, K_NORMAL = K_FIRST + DIM, K_ALONG = K_NORMAL + DIM };
enum { K_RR, K_RN = K_RR + PAIRS };

/* The first half of a line, where the lanes of v are. */
typedef double Half __attribute__((vector_size(LANES / 2 * sizeof(double)), may_alias));

/* A node and the consistent mass matrix, M_ij = sum_q S_iq S_jq rho_q V_q [kg]. Lanes of `factor`
 * and of `product` = M times it: a0, v. Lanes of `row`: its sum D_i = sum_j M_ij, and its first
 * moments sum_j M_ij (x_j - x_i) [kg cell]. */
enum { I_A, I_V = I_A + DIM };
enum { I_SUM, I_FIRST };
typedef struct Inertia {
    Half factor, product, row;
} Inertia;

_Static_assert((int)MOMENTS <= (int)LANES && QUANTITIES <= (int)LANES && K_ALONG < (int)LANES &&
                   K_RN + NMAT <= (int)LANES && I_V + DIM <= LANES / 2 &&
                   I_FIRST + DIM <= LANES / 2 && Q_V + DIM <= LANES / 2,
               "lanes");

/* Number of the pair (d, e), d <= e, in row order. */
static inline int pair(int d, int e)
{
    return d <= e ? d * DIM - d * (d - 1) / 2 + e - d : pair(e, d);
}

/* The surface near a node: mean outward normal, and curvature [1/cell] (> 0: convex), 0 where the
 * surface points do not determine it; in 3D the curvature tensor. */
enum { BENDS = IN_THIS_DIM(1, 1, PAIRS) };
typedef struct Bend {
    double normal[DIM], kappa[BENDS];
} Bend;

typedef struct Wls {
    bool linear, extrapolate, literal, folded; /* choices: see the parameters */
    bool corrected, sharpened, lagged;         /* mass, velocity, motion */
    int distance_by, quadrature;
    double hermite; /* g^2: weight of gradients in the fit of v */
    double trigger;
    int condition;       /* the test for spurious nodes: CONDITION_* */
    int *count;          /* [nodes] particles whose W reaches the node; NULL: not counted */
    double inside;       /* nodes with more beta are inside, eq 14 */
    double surface_beta; /* beta of a surface point: 1, less where they are denser */
    bool centres;        /* planes are those of cells about their middle; cell k: above node k */
    Line (*fit)[FIT];    /* [nodes] */
    Line (*skin)[2];     /* [nodes] sums over surface points, set where `skinned` */
    bool *skinned;       /* [nodes] */
    Bend *bend;          /* [nodes] or NULL: all surfaces are straight */
    Inertia *inertia;    /* [nodes] of the corrections by the mass matrix, or NULL */
    double *cell_mass;   /* [nodes] of the full cell above a node [kg], with it */
    double (*cut)[CORNER_PAIRS]; /* [nodes] M_kj [kg], k >= j, of a node's cut cell, with it */
    double *most;                /* [nodes] largest W of any particle */
    double *distance;            /* [nodes] [cells] from the surface, > 0 inside */
    unsigned char *good;         /* [nodes] not 0: alpha of eqs 19-21; with SOUND: has mass, too */
    unsigned char *stops;        /* [nodes] components that a unilateral wall stops now, with it */
    bool body;                   /* some node has mass */
    long *fallbacks;             /* [rows] of this step */
} Wls;

static inline Wls *wls_of(const Sim *sim)
{
    return sim->own;
}

static inline double wls_cell_volume(const Sim *sim)
{
    double V = 1;
    for (int d = 0; d < DIM; d++) V *= sim->dx;
    return V;
}

/* Is node `at` good, with mass of its own? Set at the start of the repair, before
 * massless nodes get small masses, so that the result does not depend on the order of nodes. */
enum { SOUND = 2 };
static inline bool wls_is_sound(const Sim *sim, size_t at)
{
    return wls_of(sim)->good[at] & SOUND;
}

/* Moments, loads, largest weights and surface sums of all live nodes, symmetry included. Of cells:
 * W, r about the middle; in the place of beta the volume V0 J [cells], times the tent. */
void wls_deposit(Sim *sim, Wls *w, double t, bool force);

/* Adds what the mirrored body beyond symmetry lines would have deposited. */
void wls_fold(Sim *sim, Wls *w);

/* Coefficients of one node's functions in place of its loads. `hermite` = g^2 > 0: the loads of v
 * hold g^2 h L, too. Returns false if the node fell back to c0: it is not `near` enough to
 * particles, or the determinant of its moments is at most `least` M_00^(DIM + 1). */
bool wls_solve(Line fit[FIT], bool near, double hermite, double least);

/* Counts the particles whose W reaches each node (condition=count). */
void wls_count(Sim *sim);

/* Solves for the planes of a node and decides whether it is good; false: it fell back to c0. */
bool wls_solve_node(Wls *w, size_t at);

/* The surface sums of a node, set to 0 when they are first asked for in a step. */
Line *wls_skin_of(Wls *w, size_t at);

/* Adds surface point p of a chunk to the surface sums of the 2^DIM nodes of its cell. */
void wls_skin_point(Sim *sim, const Chunk *c, int p);

/* Signed distance of a node from a curved surface, and its curvature, by its surface sums. */
double wls_curved_distance(const Line skin[2], Bend *bend);

/* Signed distances, and bends, of the live nodes of one row. */
void wls_distances(Sim *sim, int row, double t);

/* Mass, body force and internal force of all cells, onto the nodes of the grid. */
void wls_integrate(Sim *sim);

/* Is the cell above node index i of the axis beyond a symmetry line? */
bool wls_mirrored_cell(const Grid *g, int axis, int i);

/* Points and weights (fractions of a cell) that integrate over the part of a cell where the
 * distance, given at its corners (bit d of the number: far side of axis d), is positive; `bend` of
 * the corners, or NULL: straight. Returns their number. */
enum { MAX_POINTS = IN_THIS_DIM(18, 18, 192) };
int wls_cell_points(const double distance[CORNERS], const Bend *bend, int quadrature,
                    double xi[MAX_POINTS][DIM], double weight[MAX_POINTS]);

/* The shape of that part in 3D. */
void wls_cell_shape(const double distance[CORNERS], const Bend *bend, Polyhedron *out);

/* Cells whose first node lies in a row and whose nodes are all live, lo <= i < hi - 1; offsets of
 * their corners from that node. False: there are none. */
typedef struct CellRow {
    size_t offset[CORNERS];
    int lo, hi;
} CellRow;
bool wls_cell_row(const Grid *g, int row, CellRow *out);

/* Sets, in every node's `inertia`, product = M factor and the rows of M, by the same points. */
void wls_mass_times(Sim *sim);

/* Corrects accelerations towards the consistent mass matrix, a = 2 a0 - D^-1 M a0 at good nodes,
 * and velocities (wls/velocity.c), after symmetry. The result is written back as internal force. */
void wls_correct(Sim *sim, double dt);

/* motion=lagged: takes dt (a - a0) off v, so that the node moves particles with v + dt a0. */
void wls_hold_back(const Sim *sim, size_t at, const int index[DIM], double dt, double v[DIM]);

/* Components that a wall holds or a symmetry line cancels at node i of a row. */
unsigned wls_held(const Grid *g, int row, int i);

/* Velocity along axis a of a node that a moving wall holds; 0 if no wall there moves. */
double wls_drive(const Grid *g, int row, int i, int a);

/* Internal plus body force of a node along axis a [N]. */
double wls_whole_force(const Grid *g, size_t at, int a);

/* Call after a node's internal force was changed from that in the line `before`. The ledger has
 * recorded the force as integrated over cells. Of `held` components that is what the wall bears.
 * Of the others the change is momentum that no wall gives: it is subtracted from the impulse and
 * appears as drift, unless the changes of other nodes cancel it. */
void wls_record_change(Sim *sim, int row, size_t at, double dt, const Line before, unsigned held);

/* average=folded: passes forces of spurious nodes on to their good neighbours, as part of a0. */
void wls_spread(Sim *sim, double dt);

/* velocity=corrected, of node `at`: v becomes a factor of M; after the product the node's plane
 * gets the corrected v. */
void wls_velocity_start(Sim *sim, size_t at, int row, int i, unsigned held);
void wls_velocity_finish(Sim *sim, size_t at, int row, int i, unsigned held);

/* Are all neighbours of node i of a row live and good? A quick test, true of most nodes; ghosts
 * beyond symmetry lines count as they stand, without their images. */
bool wls_all_good(const Sim *sim, int row, int i);

/* v of a spurious node from the planes of its good neighbours; left alone if there are none. */
void wls_velocity_at(const Sim *sim, const int index[DIM], double v[DIM]);

/* Final velocities of a row, forces of its spurious and massless nodes; not beyond symmetry. */
void wls_repair_row(Sim *sim, int row, const void *dt);

/* What every fit needs; false: out of memory. */
bool wls_alloc(const Sim *sim, Wls *w);
void wls_release(Wls *w);

/* Stages of Method (method.h), shared by all settings. */
bool wls_make(Sim *sim);
void wls_free(Sim *sim);
void wls_adapt(const double par[], Method *own);
void wls_assemble(Sim *sim, double t, bool force);
void wls_repair(Sim *sim, double dt);
bool wls_normal(const Sim *sim, size_t node, double n[DIM]);
void wls_patches(const Sim *sim, PatchVisit *visit, void *own);

/* Those of impm. */
bool wls_make_centres(Sim *sim);
void wls_free_centres(Sim *sim);
void wls_integrate_centres(Sim *sim);
void wls_repair_centres(Sim *sim, double dt);
enum { CENTRES_BYTES = 2 * (sizeof(Line[FIT + 2]) + sizeof(double) + 2) + sizeof(double) };

/* Indices of the node of a row of nodes at i. */
static inline void wls_index_of(const Grid *g, int row, int i, int index[DIM])
{
    index[0] = i;
    for (int d = 1; d < DIM; d++) index[d] = row % g->n[d], row /= g->n[d];
}

/* Indices of neighbour k of NEIGHBOURS; the one in the middle is the node itself. */
static inline void wls_neighbour(const int index[DIM], int k, int next[DIM])
{
    for (int d = 0; d < DIM; d++, k /= 3) next[d] = index[d] + k % 3 - 1;
}

#endif
