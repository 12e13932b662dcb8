/* problem.h: what a scene is: const data and a few functions; it knows no grid, no method, no
 * solver.
 *
 * All functions work on n points at a time. Positions X are reference coordinates [m], one array
 * per component; the shapes below are [component][point]. */
#ifndef MPMLAB_PROBLEM_H
#define MPMLAB_PROBLEM_H

#include <math.h>
#include <stdbool.h>
#include "dim.h"
#include "common/base/info.h"
#include "material.h"

typedef struct Scene Scene;
typedef const double *const ConstFields[]; /* read-only component arrays */
typedef double *const Fields[];            /* component arrays to fill */

/* A boundary condition on the grid nodes of the line (3D: plane) x[axis] = at and of all beyond. */
typedef struct Wall {
    int axis;
    int side;      /* -1: nodes at and below `at` are held, the body lies above; +1: the reverse */
    double at;     /* [m] on a grid line: a multiple of every cell size in use */
    unsigned hold; /* bit a set: v_a = a_a = 0 there */
    bool mirror;   /* symmetry: beyond lies the mirrored body; hold is unused */
    bool unilateral; /* hold only while the body pushes against it, then bring it to rest */
    double speed;    /* [m/s] if not 0: it moves along its axis, from `at` on, which may lie between
                      * grid lines; its nodes have this velocity, held components across it 0 */
} Wall;

enum { MAX_WALLS = 8, MAX_DERIVED = 16 };

/* What happens at grid nodes that two bodies share: Coulomb contact (Bardenhagen et al. 2001), or
 * one velocity for both, as plain MPM has it; contact.c. */
typedef enum { CONTACT_BARDENHAGEN, CONTACT_NONE } ContactLaw;

/* The body as data, for layouts and meshes that fit it. Box: body_lo to body_hi. Ring, disk: radii
 * [m] about centre, angles [rad]; a ring in 3D reaches from body_lo to body_hi along the last axis.
 * Hole plate: the box less a hole of radius inner about centre. Shell, ball: radii about centre.
 * Cavity: a cube less the ball of radius inner about centre. Scan: known by its points alone. */
typedef enum {
    BODY_BOX,
    BODY_RING,
    BODY_DISK,
    BODY_HOLE_PLATE,
    BODY_SHELL,
    BODY_BALL,
    BODY_CAVITY,
    BODY_SCAN
} BodyKind;

typedef struct Body {
    BodyKind kind;
    Vec centre;
    double inner, outer;
    double angle_lo, angle_hi;
} Body;

typedef struct Layout Layout; /* layout.h: a growing list of points */

typedef struct Problem {
    Info info;
    double cells, ppc, cfl; /* defaults */
    int steps;              /* default duration in steps, if the scene has no t_end of its own */
    bool projection;        /* no time: errors are those of the projected node velocities */

    /* Material, domain, walls, times and derived constants from the parameters. 0, or -1 with one
     * line in why[128] if they make no sense together. */
    int (*init)(Scene *s, char why[128]);

    /* Replaces parameters whose values init has found out, such as a file's checksum, so that the
     * row carries them. NULL: none. */
    void (*complete)(const Scene *s, double par[]);

    /* Is X inside the body? Bounded by body_lo, body_hi. NULL: the whole box is the body. */
    bool (*inside)(const Scene *s, const Vec X);

    /* Adds the scene's own arrangement of points of the given spacing [m] (layout_add), body-fitted
     * if asked for. Returns false to leave it to the plain lattice. NULL: always the lattice. */
    bool (*place)(const Scene *s, double spacing, bool fitted, Layout *out);

    /* Initial state, arrays preset to u = 0, v = 0, F = I, L = 0. NULL: at rest. L [1/s] is the
     * exact initial velocity gradient where the scene has one. */
    void (*start)(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L);

    /* Exact displacement at time t [s], or NULL. A projection gives the velocity field instead. */
    void (*exact)(const Scene *s, int n, ConstFields X, double t, Fields u);

    /* How far x (current, not reference) lies inside the moving body at time t, or NULL. */
    double (*distance)(const Scene *s, const Vec x, double t);

    /* Imposed motion: overwrites the velocities v of what is at x (current) at time t, before every
     * step; may leave them alone. NULL: always free. */
    void (*impose)(const Scene *s, int n, ConstFields x, double t, Fields v);

    /* Points that carry the traction: shares of the reference surface's area as volumes, outward
     * normals. NULL: no traction ever. */
    void (*surface)(const Scene *s, double spacing, Layout *out);

    /* Nominal traction P N [Pa], force per reference area, at X on a face of outward normal N. */
    void (*traction)(const Scene *s, int n, ConstFields X, ConstFields N, double t, Fields out);

    /* Body force per mass [m/s^2] at reference position X and time t, or NULL. */
    void (*body)(const Scene *s, int n, ConstFields X, double t, Fields b);

    /* The largest principal stress [Pa] that the matter at X bears: tension cut-off. A particle
     * that passes it carries no tension from then on. NULL: it bears any. Neo-Hookean law only. */
    void (*strength)(const Scene *s, int n, ConstFields X, double out[]);

    /* NULL: the scene has one body. Else it has two, on separate velocity fields: turns a copy of
     * the whole scene into the scene of body 0 or 1, with its box, shape and walls. The functions
     * above take points of both. */
    void (*part)(Scene *s, int body);
} Problem;

struct Scene {
    const Problem *problem;
    const double *par; /* values in the order of problem->info.params; owned by the run */
    const char *text;  /* value of its parameter that is the name of a file, or NULL; not owned */
    double cell;       /* [m] grid spacing, set before init; only for parameters given in cells */
    Material mat;
    Vec lo, hi;           /* domain of the grid [m]: particles that leave it are lost */
    Vec body_lo, body_hi; /* box around the body [m] */
    Body body;
    bool octant; /* only the octant of a shell, ball or cavity that lies along the positive axes */
    Mat turn;    /* rotation of a whole one's body-fitted points or mesh, row-major */
    Wall wall[MAX_WALLS];
    int nwall;
    ContactLaw contact;    /* of scenes with two bodies */
    double friction;       /* [-] coefficient of Coulomb friction between them */
    bool traction;         /* problem->traction acts on this scene's surface */
    double c;              /* [m/s] the speed in dt0 = CFL h/c */
    double t_end;          /* [s] default duration; 0: none */
    double error_scale;    /* errors are divided by it; NAN: no errors in this scene */
    double k[MAX_DERIVED]; /* constants derived by init, for the problem's own use */
};

/* The error scale of a scene whose exact motion has this amplitude; NAN without motion, which
 * leaves the error columns empty: an error of 0 of a body at rest would mean nothing, and relative
 * to the amplitude it is 0/0. */
static inline double scale_of_motion(double amplitude, double scale)
{
    return fabs(amplitude) > 0 ? fabs(scale) : NAN;
}

/* All problems in the order of problems/problems.def, ended by NULL. */
extern const Problem *const problems[];

#endif
