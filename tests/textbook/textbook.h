/* textbook.h: the textbook material point step, as plain as it can be written: arrays of structs,
 * loops over particles and their nodes, weights recomputed in both passes, a dense grid, symmetry
 * by truly mirrored copies of the particles. Shares placement and scenes with the testbed, no
 * numerics: it is what the fast core is compared with, in tests and in the bench. */
#ifndef MPMLAB_TEXTBOOK_H
#define MPMLAB_TEXTBOOK_H

#include "common/contract/solver.h"

/* State that few schemes keep: all others would only carry it through their loops. */
typedef struct TwinMore {
    double corner[1 << DIM][DIM]; /* [m] of its domain (CPDI2) */
    double mode[3][3][3][DIM];    /* [m/s] by degree along each axis (PolyPIC) */
} TwinMore;

typedef struct TwinParticle {
    int id;                        /* placement order */
    double m, V0;                  /* [kg] [m^DIM] */
    double X[DIM], x[DIM], v[DIM]; /* [m] [m] [m/s] */
    double w[DIM];                 /* [m/s] velocity in a filter's round */
    double u[DIM];                 /* [m] displacement to be made after a re-projection (musl) */
    double b[DIM];                 /* [m/s^2] body force per mass */
    double F[DIM][DIM];            /* [-] */
    double L[DIM][DIM];            /* [1/s] grad v of the last gather; or moments [m^2/s] */
    TwinMore *more;                /* or NULL */
} TwinParticle;

typedef struct TwinNode {
    double m, p[DIM], f[DIM]; /* [kg] [kg m/s] [N] */
    double v[DIM], a[DIM];    /* [m/s] [m/s^2] */
    double r[DIM], rest[DIM]; /* [m/s] of a filter's round; what its terms leave */
    double weight;            /* [kg] m, known before the forces where a particle is on a node */
    unsigned held;            /* bit a: v_a = a_a = 0 */
} TwinNode;

typedef enum {
    TWIN_TENT,
    TWIN_BOX,
    TWIN_SPLINE,
    TWIN_CUBIC,
    TWIN_CPDI,
    TWIN_CPDI2
} TwinShape; /* box: GIMP's exact convolution */
typedef enum { TWIN_NONE, TWIN_PARTICLES, TWIN_NODES } TwinFilter; /* XPIC, FMPM */

typedef struct TwinMethod {
    const char *name;
    TwinShape shape;
    bool gradient; /* gradient-enhanced projection (W07 section 4) */
    double pic;    /* share of S v in v, the rest is v + dt S a; a gradient is taken with it */
    bool moments;  /* keeps sum_i S v (x_i - x)^T in the place of L (APIC) */
    bool fitted;   /* slopes of moving least squares instead of derivatives */
    bool modes;    /* keeps modes up to degree 2 (textbook_modes.h) */
    bool cells;    /* planes fitted at nodes and in the middle of cells (textbook_cells.c) */
    TwinFilter filter;
    double least; /* a node with less than this part of a particle's mass is empty */
} TwinMethod;

typedef struct Twin {
    const Setup *setup;
    TwinMethod method;
    int order; /* of its filter */
    int n;
    TwinParticle *p;
    TwinMore *more;                    /* [particles], or NULL */
    double h;                          /* [m] */
    double half;                       /* l0/h of an undeformed particle */
    int origin[DIM], size[DIM];        /* first node index and nodes per axis, ghosts included */
    double wall_lo[DIM], wall_hi[DIM]; /* nodes at which splines fold, or +-infinity */
    long nodes;
    TwinNode *node;
    struct TwinFit *fit; /* [nodes] planes, moved by `shift` cells */
    double shift;
} Twin;

/* NULL if it does not have the method, or out of memory. `setup` must outlive it. */
Twin *twin_new(const Setup *setup);
void twin_free(Twin *twin);

/* One step from t to t + dt [s]; `first` takes the half first step where the integrator has one. */
void twin_step(Twin *twin, double t, double dt, bool first);

/* Parts of a step in files of their own. The particle and its images in all symmetry lines, and
 * their images, from wall k on, each given to the grid. */
typedef void TwinDeposit(Twin *w, const TwinParticle *p, bool force);
void twin_images(Twin *w, const TwinParticle *p, TwinDeposit *give, bool force, int k);
double twin_det(const double F[DIM][DIM]);
void twin_refer_gradient(TwinParticle *p); /* L: dv/dx becomes dv/dX = dv/dx F */
void twin_filter_particles(Twin *w);       /* p->w: V without what its filter keeps */
void twin_filter_nodes(Twin *w);           /* node->v: filtered */
bool twin_make_fits(Twin *w);
void twin_fit_velocities(Twin *w);  /* node->p: m times those of the planes */
void twin_add_cell_forces(Twin *w); /* node->f */
void twin_cauchy(const Material *m, const double F[DIM][DIM], double sigma[DIM][DIM]); /* [Pa] */

/* CPU time [ns] per particle and step of `steps` steps from the start; NAN if it is not known. */
double twin_ns(const Setup *setup, double dt, int steps);

#endif
