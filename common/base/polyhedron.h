/* polyhedron.h: marching cubes: the part of a unit cube where a distance is positive. polygon.h
 * in three dimensions. Corner k of a cube lies on the far side of axis a if bit a of k is set. */
#ifndef MPMLAB_POLYHEDRON_H
#define MPMLAB_POLYHEDRON_H

#include <stdbool.h>

enum {
    MAX_FACES = 16,      /* two of each side of the cube, and four of the surface */
    MAX_FACE_SIDES = 12, /* of one of the surface; six in the sides of the cube */
    MAX_FACE_SUM = 48,   /* sides of all faces: 36 and 12 */
    POLYHEDRON_VERTICES = 20
};

/* A face, counter-clockwise seen from outside: a fan of triangles about its apex. */
typedef struct Face {
    int piece, sides;
    int vertex[MAX_FACE_SIDES]; /* numbers in Polyhedron.x */
    bool cut;                   /* part of the surface, not of a side of the cube */
    double apex[3];             /* mean of its vertices; raised if the surface is curved */
} Face;

typedef struct Polyhedron {
    int pieces, faces;
    Face face[MAX_FACES];
    double x[POLYHEDRON_VERTICES]
            [3]; /* the cube's corners, then cuts of its edges, four along each axis */
    int piece[POLYHEDRON_VERTICES]; /* that a vertex belongs to, or -1 */
} Polyhedron;

/* Curvature tensor [1/side] of a curved surface near a corner, in the same order: positive along a
 * direction in which the shape is convex (xx, xy, xz, yy, yz, zz), 0 along the normal, or where
 * nothing is known. */
typedef double CurvatureTensor[6];

/* Index of the pair (a, b) of a symmetric tensor xx, xy, xz, yy, yz, zz. */
static inline int tensor_index(int a, int b)
{
    return a <= b ? a * (5 - a) / 2 + b : b * (5 - b) / 2 + a;
}

/* The shape from the distances at the cube's corners: in where > 0, edges cut by linear
 * interpolation (W11 eq 18), or with `curvature` of the corners (or NULL) where the curved surface
 * crosses them. Each side of the cube is cut as polygon.h cuts a square: a saddle is joined if the
 * mean of its four distances is positive, so that neighbouring cubes agree. Faces of the surface
 * close what the sides leave open. */
void polyhedron_make(const double distance[8], const CurvatureTensor *curvature, Polyhedron *out);

#endif
