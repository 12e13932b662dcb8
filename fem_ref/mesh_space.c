/* mesh_space.c: structured tetrahedra in 3D for the bodies a scene can name.
 *
 * Hexahedra, each cut into 5 tetrahedra: one in the middle on the four vertices whose lattice
 * indices have an even sum, and one at each of the others. Neighbours so meet in equal diagonals,
 * and the mesh has no direction of its own (six tetrahedra about one diagonal have 2.3 times the
 * error on the shell).
 *
 *   box      a lattice of cells, ni x nj x nk
 *   ring     the lattice of the plane (radius, angle), nk = thickness N cells along the axis
 *   shell    equiangular cubed sphere: the cells on the faces of a cube of m^3 cells (octant: of
 *            its three far faces), and layers of them along the radius: m = pi/4 Ro N per octant,
 *            layers = (Ro - Ri) N
 *   cavity   the same from the sphere to the cube: m = pi/4 .7 N, layers = .6 N per width
 *   ball     m^3 cells in the middle, blended between cube and sphere of half the radius, and
 *            layers from there to the surface */
#include <limits.h>
#include <math.h>
#include "common/contract/sphere.h"
#include "mesh.h"

/* Is it built on the faces of a cube? */
static bool is_round(const Scene *s)
{
    return s->body.kind >= BODY_SHELL;
}

/* Cells along each axis of a lattice; round bodies: {m, m, layers}. As doubles: they may be beyond
 * int. */
static void size(const Scene *s, double cells, double n[3])
{
    const Body *b = &s->body;
    const double quarters = s->octant ? 1 : 2;
    for (int d = 0; d < 3; d++) n[d] = mesh_cells_along(s->body_hi[d] - s->body_lo[d], cells);
    if (b->kind == BODY_RING) {
        n[0] = mesh_cells_along(b->outer - b->inner, cells);
        n[1] = mesh_cells_along((b->angle_hi - b->angle_lo) * 0.5 * (b->inner + b->outer), cells);
        if (mesh_is_full_turn(b)) n[1] = 2 * ceil(n[1] / 2);
    }
    if (!is_round(s)) return;
    const double width = s->body_hi[0] - b->centre[0];
    n[0] = n[1] = quarters * mesh_cells_along(M_PI / 4 * b->outer, cells);
    n[2] = mesh_cells_along(b->outer - b->inner, cells);
    if (b->kind == BODY_BALL) n[2] = mesh_cells_along(0.5 * b->outer, cells);
    if (b->kind != BODY_CAVITY) return;
    n[0] = n[1] = mesh_cells_along(M_PI / 4 * 0.7 * width, cells);
    n[2] = mesh_cells_along(0.6 * width, cells);
}

/* Nodes and cells of one layer of a round body. */
static double faces_nodes(const Scene *s, double m)
{
    return s->octant ? 3 * m * (m + 1) + 1 : 6 * m * m + 2;
}

int mesh_takes(const Scene *scene, Fault *fault)
{
    const BodyKind kind = scene->body.kind;
    if (kind == BODY_BOX || kind == BODY_RING || (kind >= BODY_SHELL && kind <= BODY_CAVITY))
        return 0;
    return fault_set(fault, FAULT_USAGE,
                     "--method: got 'fem', which has no mesh for the body of %s",
                     scene->problem->info.name);
}

int mesh_plan(Mesh *mesh, const Scene *scene, int cells, Fault *fault)
{
    const BodyKind kind = scene->body.kind;
    const bool closed = kind == BODY_RING && mesh_is_full_turn(&scene->body);
    double n[3], nodes, hexes;
    size(scene, cells, n);
    nodes = (n[0] + 1) * (n[1] + !closed) * (n[2] + 1);
    hexes = n[0] * n[1] * n[2];
    if (is_round(scene)) {
        const double core = kind == BODY_BALL ? n[0] : 0;
        nodes =
            faces_nodes(scene, n[0]) * (n[2] + (core > 0 ? 0 : 1)) + pow(core + 1, 3) * (core > 0);
        hexes = (scene->octant ? 3 : 6) * n[0] * n[0] * n[2] + pow(core, 3);
    }
    if (5 * hexes > INT_MAX / 8.0)
        return fault_set(fault, FAULT_MACHINE, "fem: %.3g elements at %d cells are too many",
                         5 * hexes, cells);
    *mesh = (Mesh){.scene = scene,
                   .ni = (int)n[0],
                   .nj = (int)n[1],
                   .nk = (int)n[2],
                   .closed = closed,
                   .nodes = (int)nodes,
                   .elements = (int)(5 * hexes)};
    return 0;
}

/* A mesh being filled. */
typedef struct Filling {
    const Mesh *mesh;
    double *const *X;
    int *const *corner;
    int e;
} Filling;

/* Adds the tetrahedra of a hexahedron with nodes node[x + 2 y + 4 z]; `odd`: the index sum of its
 * node 0. */
static void add_hex(Filling *f, const int node[8], bool odd)
{
    static const int middle[2][4] = {{0, 5, 3, 6}, {1, 2, 4, 7}};
    for (int c = 0; c < 4; c++) f->corner[c][f->e] = node[middle[odd][c]];
    f->e++;
    for (int v = 0; v < 8; v++) {
        const bool is_odd = __builtin_popcount((unsigned)v) % 2;
        if (is_odd == odd) continue;
        f->corner[0][f->e] = node[v];
        f->corner[1][f->e] = node[v ^ (is_odd ? 2 : 1)]; /* counter-clockwise as seen from v */
        f->corner[2][f->e] = node[v ^ (is_odd ? 1 : 2)];
        f->corner[3][f->e++] = node[v ^ 4];
    }
}

static void set_node(const Filling *f, int node, const double x[3])
{
    for (int d = 0; d < DIM; d++) f->X[d][node] = x[d];
}

/* Box, ring: image of the lattice point at fractions f. */
static void place_lattice(const Scene *s, const double f[3], double x[3])
{
    const Body *b = &s->body;
    for (int d = 0; d < 3; d++) x[d] = s->body_lo[d] + f[d] * (s->body_hi[d] - s->body_lo[d]);
    if (b->kind != BODY_RING) return;
    const double angle = b->angle_lo + f[1] * (b->angle_hi - b->angle_lo);
    const double R = b->inner + f[0] * (b->outer - b->inner);
    x[0] = b->centre[0] + R * cos(angle);
    x[1] = b->centre[1] + R * sin(angle);
}

static void fill_lattice(Filling *f)
{
    const Mesh *m = f->mesh;
    const int row = m->ni + 1, columns = m->nj + !m->closed, floor = row * columns;
    for (int k = 0; k <= m->nk; k++)
        for (int j = 0; j < columns; j++)
            for (int i = 0; i < row; i++) {
                double x[3];
                place_lattice(m->scene,
                              (double[]){(double)i / m->ni, (double)j / m->nj, (double)k / m->nk},
                              x);
                set_node(f, k * floor + j * row + i, x);
            }
    for (int k = 0; k < m->nk; k++)
        for (int j = 0; j < m->nj; j++)
            for (int i = 0; i < m->ni; i++) {
                int node[8];
                for (int v = 0; v < 8; v++)
                    node[v] =
                        (k + (v >> 2)) * floor + (j + (v >> 1 & 1)) % columns * row + i + (v & 1);
                add_hex(f, node, (i + j + k) % 2);
            }
}

/* Number of a node of the cube's faces among those of one layer: floor by floor along axis 2. */
static int face_node(const Mesh *m, const int at[3])
{
    const int M = m->ni, i = at[0], j = at[1], k = at[2], plane = (M + 1) * (M + 1);
    if (m->scene->octant)
        return k == M ? M * (2 * M + 1) + i + j * (M + 1)
                      : k * (2 * M + 1) + (i == M ? j : M + 1 + i);
    if (k == 0 || k == M) return (k ? plane + (M - 1) * 4 * M : 0) + i + j * (M + 1);
    const int sides = plane + (k - 1) * 4 * M;
    if (j == 0 || j == M) return sides + (j ? M + 1 : 0) + i;
    return sides + 2 * M + 2 + (i ? M - 1 : 0) + j - 1;
}

/* Node of layer q; of a ball, layer 0 is the surface of the lattice in the middle. */
static int round_node(const Mesh *m, const int at[3], int q)
{
    const int M = m->ni, layer = (int)faces_nodes(m->scene, M), face = face_node(m, at);
    if (m->scene->body.kind != BODY_BALL) return q * layer + face;
    if (q == 0) return at[0] + (M + 1) * (at[1] + (M + 1) * at[2]);
    return (M + 1) * (M + 1) * (M + 1) + (q - 1) * layer + face;
}

/* Index of the lattice relative to the symmetry planes: of a whole body they are in its middle. */
static int from_plane(const Mesh *m, int at)
{
    return m->scene->octant ? at : at - m->ni / 2;
}

/* Point of lattice index at[] on a cube [-1, 1]^3, or [0, 1]^3 of an octant, at equal angles along
 * its faces; returns its length over that of its largest component. */
static double cube_point(const Mesh *m, const int at[3], double t[3])
{
    const double half = m->scene->octant ? m->ni : 0.5 * m->ni;
    double largest = 0, square = 0;
    for (int d = 0; d < 3; d++) {
        t[d] = tan(M_PI / 4 * from_plane(m, at[d]) / half);
        largest = fmax(largest, fabs(t[d]));
        square += t[d] * t[d];
    }
    return largest > 0 ? sqrt(square) / largest : 1;
}

/* Position of node (at, layer q): the cube's point t scaled by a factor that is linear in q. */
static void place_round(const Mesh *m, const int at[3], int q, double x[3])
{
    const Body *b = &m->scene->body;
    double t[3], own[3];
    const double length = cube_point(m, at, t), f = (double)q / m->nk;
    double from = b->inner / length, to = b->outer / length; /* spheres */
    if (b->kind == BODY_CAVITY) to = m->scene->body_hi[0] - b->centre[0];
    if (b->kind == BODY_BALL) from = 0.25 * b->outer * (1 + 1 / length);
    for (int d = 0; d < 3; d++) own[d] = (from + f * (to - from)) * t[d];
    for (int a = 0; a < DIM; a++) {
        x[a] = b->centre[a];
        for (int d = 0; d < DIM; d++) x[a] += m->scene->turn[a * DIM + d] * own[d];
    }
}

/* The cells of all layers on the face at `end` (0 or m) of an axis, axes in cyclic order. */
static void fill_face(Filling *f, int axis, int end)
{
    const Mesh *m = f->mesh;
    const int first = (axis + (end ? 1 : 2)) % 3, second = (axis + (end ? 2 : 1)) % 3;
    for (int q = 0; q < m->nk; q++)
        for (int j = 0; j < m->ni; j++)
            for (int i = 0; i < m->ni; i++) {
                int node[8], at[3];
                for (int v = 0; v < 8; v++) {
                    at[axis] = end;
                    at[first] = i + (v & 1);
                    at[second] = j + (v >> 1 & 1);
                    node[v] = round_node(m, at, q + (v >> 2));
                }
                const int sum = from_plane(m, end) + from_plane(m, i) + from_plane(m, j) + q;
                add_hex(f, node, sum & 1);
            }
}

/* The lattice in the middle of a ball. */
static void fill_core(Filling *f)
{
    const Mesh *m = f->mesh;
    for (int k = 0; k < m->ni; k++)
        for (int j = 0; j < m->ni; j++)
            for (int i = 0; i < m->ni; i++) {
                int node[8];
                for (int v = 0; v < 8; v++)
                    node[v] =
                        round_node(m, (int[]){i + (v & 1), j + (v >> 1 & 1), k + (v >> 2)}, 0);
                const int sum = from_plane(m, i) + from_plane(m, j) + from_plane(m, k);
                add_hex(f, node, sum & 1);
            }
}

static void fill_round(Filling *f)
{
    const Mesh *m = f->mesh;
    const bool core = m->scene->body.kind == BODY_BALL;
    const int M = m->ni;
    for (int k = 0; k <= M; k++)
        for (int j = 0; j <= M; j++)
            for (int i = 0; i <= M; i++) {
                const int at[3] = {i, j, k};
                const bool far = i == M || j == M || k == M, near = !i || !j || !k;
                const bool on_face = far || (near && !m->scene->octant);
                for (int q = 0; q <= (on_face ? m->nk : 0); q++) {
                    double x[3];
                    if (!on_face && !core) continue;
                    place_round(m, at, q, x);
                    set_node(f, round_node(m, at, q), x);
                }
            }
    if (core) fill_core(f);
    for (int axis = 0; axis < 3; axis++) {
        fill_face(f, axis, M);
        if (!m->scene->octant) fill_face(f, axis, 0);
    }
}

void mesh_fill(const Mesh *mesh, Fields X, int *const corner[])
{
    Filling f = {mesh, X, corner, 0};
    if (is_round(mesh->scene))
        fill_round(&f);
    else
        fill_lattice(&f);
}
