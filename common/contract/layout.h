/* layout.h: where the points of a scene start: the plain lattice, or the scene's own arrangement.
 */
#ifndef MPMLAB_LAYOUT_H
#define MPMLAB_LAYOUT_H

#include <stdbool.h>
#include "common/base/fault.h"
#include "dim.h"

typedef struct Scene Scene; /* problem.h */
typedef struct Layout Layout;

/* Points in placement order. Owns its arrays; grows by doubling. */
struct Layout {
    double dense; /* surface points per particle spacing; 0: 1 */
    double fit;   /* spacing of a lattice that was fitted to a box, over the one asked for; 0: 1 */
    int n, room;
    int lost;            /* points that did not fit into memory: > 0 means failure */
    char why[128];       /* why the scene could not place its points; "": it did */
    double *X[DIM];      /* [m] */
    double *volume;      /* [m^DIM]; 0 for surface particles */
    double *normal[DIM]; /* outward unit normal of surface particles, else 0 */
};

/* Adds a point; normal may be NULL (an interior point). */
void layout_add(Layout *out, const Vec X, double volume, const double *normal);
void layout_free(Layout *out);

/* Adds points at mid angles of the arc of radius R about the scene's body [m], at most `spacing`
 * apart; the volume of each is its share of a ring of thickness dr. dr = 0: massless surface points
 * at layout_surface_spacing(), whose normals point outwards (side 1) or inwards (-1). */
void layout_add_arc(Layout *out, const Scene *scene, double R, double dr, double spacing, int side);

/* Arcs at the mid radii of rings of equal thickness, at most `spacing`, from inner to outer. */
void layout_fill_arcs(Layout *out, const Scene *scene, double inner, double outer, double spacing);

/* Surface points at mid spacing, at most `spacing` wide, on the face of the body's box across
 * `axis`, on the far side (1) or the near one (-1); `areas`: their volumes are shares of its area.
 */
void layout_add_face(Layout *out, const Scene *scene, int axis, int side, double spacing,
                     bool areas);

/* Spacing of surface points where particles have the given one [m]. */
double layout_surface_spacing(const Layout *out, double spacing);

/* Particles per cell of width `cell` [m] as placed: their number over the cells that their volume
 * would fill; `asked` where that differs by round-off only. NAN if there are none. */
double layout_ppc(const Layout *out, double asked, double cell);

/* Fills an empty layout for spacing s = 1/(cells n) with the first of these that applies: the
 * scene's own arrangement (Problem.place); `count` > 0 points evenly over the body (1D); the points
 * (i + 1/2) s of a lattice from the origin that lie inside, volume s^DIM. In a box that lattice is
 * shifted and compressed until it fills the box. With `fitted` a box also has surface points on all
 * faces that are no symmetry lines. 0, or a fault: 2 if `fitted` and the scene has no such
 * arrangement, 1 if memory runs out. */
int layout_make(Layout *out, const Scene *scene, double spacing, int count, bool fitted,
                Fault *fault);

#endif
