/* sphere.h: points on spheres by the equiangular cubed sphere: the faces of a cube, each cut by
 * planes at equal angles, seen from the centre. A quarter of a face belongs to each octant. Equal
 * under exchange of axes; with mid angles no point lies on a symmetry plane. */
#ifndef MPMLAB_SPHERE_H
#define MPMLAB_SPHERE_H

#include "layout.h"

/* Rotation by `angle` [rad] about `axis` (any length), row-major; the identity but in 3D. */
void sphere_turn(const double axis[3], double angle, Mat turn);

/* Adds points at mid angles of the sphere of radius R about the scene's body [m], about `spacing`
 * apart, n = ceil(sqrt(pi/6) R/spacing) rows of n on the quarter of a face; each has its exact
 * solid angle's share of a shell of thickness dr. dr = 0: surface points as in layout_add_arc.
 * One octant (scene->octant) or the whole sphere, turned by scene->turn. */
void sphere_add(Layout *out, const Scene *scene, double R, double dr, double spacing, int side);

/* Spheres at the mid radii of layers of equal thickness, at most `spacing`, from inner to outer. */
void sphere_fill(Layout *out, const Scene *scene, double inner, double outer, double spacing);

#endif
