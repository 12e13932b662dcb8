/* sim.h: the particles and the grid of one run. Layout and bounds: see scheme.h.
 *
 * Particles are arrays per component, sorted by grid cell (rows last), in chunks of 64 that never
 * span two blocks of rows; a block is filled up with massless copies (id -1). Nodes are lines of
 * LANES doubles; only the live span of each row is ever touched. */
#ifndef MPMLAB_SIM_H
#define MPMLAB_SIM_H

#include <stddef.h>
#include "common/base/stash.h"
#include "common/contract/method.h"
#include "common/contract/solver.h"

/* Particle fields; each is an array over slots, or NULL where the run does not need it. */
enum {
    AT_X0 = 0,          /* reference position [m], DIM of them */
    AT_X = AT_X0 + DIM, /* position [m] */
    AT_V = AT_X + DIM,  /* velocity [m/s] */
    AT_F = AT_V + DIM,  /* deformation gradient [-], NMAT of them */
    AT_M = AT_F + NMAT, /* mass [kg] */
    AT_VOL = AT_M + 1,  /* reference volume [m^DIM] */
    AT_L = AT_VOL + 1,  /* velocity gradient [1/s], NMAT: if the method keeps it */
    AT_U = AT_L + NMAT, /* displacement of this step [m], DIM: if the integrator keeps it */
    AT_W = AT_U + DIM,  /* velocity in a filter's round [m/s], DIM: if the method has a filter */
    AT_N = AT_W + DIM,  /* outward normal in the reference state, DIM: of surface points */
    AT_STRENGTH = AT_N + DIM,  /* largest tension [Pa], 0: broken; in scenes whose matter breaks */
    AT_LOST = AT_STRENGTH + 1, /* stored energy that went when it broke [J], likewise */
    AT_OWN = AT_LOST + 1,      /* the method's own, MAX_OWN */
    FIELDS = AT_OWN + MAX_OWN
};

typedef struct Particles {
    int count;   /* real ones, surface points included */
    int n, room; /* slots in use and allocated, multiples of CHUNK */
    double *field[FIELDS];
    double *spare;                  /* [room] for sorting */
    double *arena;                  /* owns all fields and the spare one */
    int *id;                        /* [room] placement order; -1: padding */
    int *order, *source, *key[DIM]; /* [room] for sorting */
} Particles;

/* Chunks [first, last) of one block of grid rows. Blocks of equal parity never touch a common node.
 */
typedef struct Block {
    int first, last;
} Block;

/* A symmetry line: index `at` of `axis`; ghosts lie on `side` (-1 or +1). */
typedef struct Mirror {
    int axis, at, side;
} Mirror;

/* A wall that holds its nodes (index `at` and beyond, on `side`) only while they push against it.
 */
typedef struct Stop {
    int axis, at, side;
    unsigned hold; /* bit a: component a */
} Stop;

typedef struct Grid {
    int cells;           /* per unit length; h = 1/cells [m] */
    int origin[DIM];     /* node index 0 lies at x = origin/cells */
    int n[DIM];          /* nodes per axis, ghosts included */
    int rows;            /* n[1] n[2] ...: lines of nodes along axis 0 */
    Line *node;          /* [rows * n[0]] lanes: dim.h */
    Line *keep;          /* [rows * n[0]] what a velocity filter puts aside, or NULL */
    Line zero;           /* an empty node */
    double *force;       /* [rows * n[0]][DIM] body force [N], or NULL */
    double *outward;     /* [rows * n[0]][DIM] sum of V dS/dx over the cells, which is the integral
                          * of S n over their outer boundary [m^(DIM-1)]; or NULL */
    double *mass;        /* [rows * n[0]] [kg] of the last solve, 0: empty; NULL: not kept */
    unsigned char *body; /* [rows * n[0]] the node is the body's, for particles on nodes */
    Axis axis[DIM];      /* where walls stand, for shapes that fold their weights there */
    unsigned char *hold[DIM]; /* [n[d]] bit a: component a is held at this index of axis d */
    double *drive[DIM]; /* [n[d]] velocity of held nodes along axis d [m/s]; NULL: no wall moves */
    double *work;       /* [rows] [J] that moving walls do in this step; or NULL */
    Mirror mirror[2 * DIM]; /* by axis */
    int nmirror;
    Stop stop[2 * DIM]; /* unilateral walls; not in hold */
    int nstop;
    int *lo, *hi; /* [rows] live span: nodes lo <= i < hi of each row */
    int *count;   /* [longest axis + 1] for sorting */
    Vec *impulse; /* [rows] [kg m/s] momentum ledger of this step */
    int *live;    /* [rows] nodes with mass */
} Grid;

enum { BLOCK_ROWS = 8 };

/* Most blocks that an order of particles may have. */
static inline int grid_most_blocks(const Grid *g)
{
    return g->n[AXIS_LAST] / BLOCK_ROWS + 2;
}

typedef struct Sim {
    const Setup *setup;
    Method method; /* the run's own copy */
    bool total;    /* FRAME_TOTAL: stencils, walls and symmetry lines stand in the reference */
    Domain domain; /* undeformed in the reference */
    void *own;     /* the method's workspace, or NULL */
    Particles p;
    Grid g;
    Block *block;
    int nblock, block_rows; /* of the last axis; at least BLOCK_ROWS, in 1D 8 times that */
    double ppc;             /* particles per cell, as placed */
    double half;            /* l0/h: half width of an undeformed particle in cells */
    double half_max;        /* widest half width that the stencils allow for, in cells */
    double half_plan;       /* the one that the current order and spans were made for */
    double half_now;        /* widest now */
    double key_shift;       /* particles are sorted by floor(x + this), in cells */
    double travel;          /* farthest any particle may have moved since the last sort, in cells */
    double mass_cut;        /* nodes with less are empty [kg] */
    double mass_body;       /* nodes with less get no stress from particles on nodes [kg] */
    long nodes, live;       /* most live nodes so far; those of the last solve */
    Vec impulse;            /* [kg m/s] given by body forces and walls so far */
    Vec outside;            /* [kg m/s] by body forces and tractions alone, if setup->reactions */
    double dx;              /* 1/cells [m] */
    double dt_before;       /* [s] of the step before; 0: none */
    int surface;            /* surface particles, if the method has any */
    long fallbacks;    /* nodes that fell back from their method's own rule, summed over steps */
    struct Skin *skin; /* the surface under traction, or NULL */
    double driven;     /* [J] work of moving walls so far */
    bool moved;        /* the last step has moved the particles */
    Status status;     /* what ended the run: no step is taken after it */
} Sim;

/* Places and allocates everything; NULL and a fault (2: parameters, 1: memory, before it is taken).
 */
Sim *sim_new(const Setup *setup, Fault *fault);
void sim_free(Sim *sim);

/* Memory for n elements and one more, aligned for lines of nodes, not cleared; to be freed. NULL:
 * there is none. */
void *sim_array(size_t n, size_t size);

/* Memory [bytes] of a particle; of a live node, which is all that a grid takes: what no particle
 * has touched stays untouched pages. Setup and method must be set, and the scene where it has body
 * forces. */
double sim_particle_bytes(const Sim *sim);
double sim_node_bytes(const Sim *sim);

/* Are order, spans and sizes consistent? For assertions and tests; sort.c. */
bool sim_is_valid(const Sim *sim);

/* Fills the method's own fields from x and F, and finds the widest half width. */
void sim_start_own(Sim *sim);
int sim_own_count(const Method *method);

/* L: dv/dx becomes dv/dX = dv/dx F. */
void sim_refer_gradient(Particles *p);

/* The grid as general weights see it; and a chunk in the frame of the weights: in the total one at
 * its reference positions, undeformed. */
Place sim_place(const Sim *sim);
Chunk sim_weight_chunk(const Sim *sim, const Chunk *c);

/* Sorts particles by cell, rebuilds blocks, padding and live spans; sort.c. */
void sim_sort(Sim *sim);

/* The particles are new, and in no order: the next step checks and sorts them; sort.c. */
void sim_restart(Sim *sim);

/* Gives `to`, made for the same scene, the particles of `from`, whose method it follows;
 * take_over.c. 0 or a fault. */
int sim_take_over(Sim *to, Sim *from, Fault *fault);

/* Everything that steps change; steps after it was read have the bits of those after it was
 * written. stash.c. */
void sim_stash(Sim *sim, Stash *s);

/* G = 0 for particles on nodes, whose slope is not the tent's; on_node.c. */
void on_node_clear_slopes(Stencil *stencil);

/* What particles receive from a node of mass m in one pass: momentum m (a_share a + v_share v). */
typedef struct Given {
    double a_share, v_share; /* [s] dt (1 - pic), [-] pic */
} Given;

/* Symmetry: ghosts beyond each mirror line are added to their images (fold, after a deposit; body
 * force too) and filled from them (unfold, before a gather); mirror.c. Each component has its
 * parity, so that methods need no code for symmetry. unfold also adds the momentum that real
 * particles receive from ghost nodes to the ledger. */
void mirror_fold(Sim *sim);
void mirror_unfold(Sim *sim, Given given);

/* Calls `visit` for every ghost and its image, mirror by mirror; `back`: in the order in which
 * ghosts are filled from images. */
typedef void PairVisit(Sim *sim, const Mirror *m, size_t ghost, size_t image, int image_row,
                       void *own);
void mirror_visit_pairs(Sim *sim, bool back, PairVisit *visit, void *own);

/* Widens live spans until the image of every live ghost is live. */
void mirror_spans(Grid *g);

/* Is this row a ghost of a mirror across an axis beyond `above`? */
bool mirror_is_ghost_row(const Grid *g, int row, int above);

/* Turns the scene's walls into data of the grid: held components, mirrors, unilateral walls. Then
 * what moving walls hold at time t, and their velocity. */
void mirror_set_walls(Sim *sim);
void mirror_move_walls(Sim *sim, double t);

/* Fills nodes beyond a wall with images: odd ones of components that it holds, else even ones. */
void mirror_wall_images(Sim *sim);

/* Which components unilateral walls hold at node i of a row, whose p and f are those of the
 * equations of motion over dt [s]; solve.c. */
unsigned sim_stops(const Grid *g, int row, int i, double dt);

/* Node number of grid index `index`, or of its image if it lies beyond a symmetry line: then
 * sign[a] is the parity of component a, else 1. NOWHERE outside the live nodes. */
#define NOWHERE ((size_t)-1)
size_t mirror_image(const Grid *g, const int index[DIM], double sign[DIM]);

/* Does node i of a row lie on a symmetry plane across this axis? */
bool mirror_has_node(const Grid *g, int axis, int i, int row);

/* What a chunk's points carry at time t: T = J sigma [Pa], for a deposit: those break whose tension
 * passes their strength; and body force per mass b [m/s^2] (0 if the scene has none). Distance
 * [cells] of a node inside the body, from a scene that knows it; else NAN. deposit.c. */
void sim_stress(const Sim *sim, const Chunk *c, Field T[NMAT]);
void sim_stress_now(const Sim *sim, const Chunk *c, Field T[NMAT]); /* nothing breaks */
void sim_start_strength(Sim *sim);                                  /* as the scene says */
double sim_lost(const Sim *sim); /* [J] that broken particles stored */
void sim_body(const Sim *sim, const Chunk *c, double t, Field b[DIM]);
double sim_distance(const Sim *sim, const int index[DIM], double t);

/* The view of chunk k that a method's stages work on. */
static inline Chunk sim_chunk(const Sim *sim, int k)
{
    const Particles *p = &sim->p;
    const size_t at = (size_t)k * CHUNK;
    Chunk c = {.par = sim->setup->method_par,
               .m = p->field[AT_M] + at,
               .V0 = p->field[AT_VOL] + at,
               .id = p->id + at,
               .own = p->field + AT_OWN,
               .strength = p->field[AT_STRENGTH] ? p->field[AT_STRENGTH] + at : NULL,
               .lost = p->field[AT_LOST] ? p->field[AT_LOST] + at : NULL,
               .first = at};
    for (int d = 0; d < DIM; d++) {
        c.X[d] = p->field[AT_X0 + d] + at;
        c.x[d] = p->field[AT_X + d] + at;
        c.v[d] = p->field[AT_V + d] + at;
        c.u[d] = p->field[AT_U + d] ? p->field[AT_U + d] + at : NULL;
        c.w[d] = p->field[AT_W + d] ? p->field[AT_W + d] + at : NULL;
        c.normal[d] = p->field[AT_N + d] ? p->field[AT_N + d] + at : NULL;
    }
    for (int k2 = 0; k2 < NMAT; k2++) {
        c.F[k2] = p->field[AT_F + k2] + at;
        c.L[k2] = p->field[AT_L + k2] ? p->field[AT_L + k2] + at : NULL;
    }
    return c;
}

#endif
