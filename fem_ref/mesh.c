/* mesh.c: structured triangles in the plane for the bodies a scene can name.
 *
 * Box, ring, hole plate: ni x nj quads, the image of a square lattice (s, t) in [0,1]^2, each quad
 * cut along alternating diagonals. s runs across (x, radius), t along (y, angle):
 *
 *   box         x = lo + (s, t) (hi - lo)              ni = Lx N, nj = Ly N
 *   ring        R = Ri + s (Ro - Ri)                   ni = (Ro - Ri) N, nj = angle (Ri + Ro)/2 N
 *   hole plate  R = Ri + s (edge(angle) - Ri), the blend of circle and square; in units of the
 *               plate's width ni = .6 N, nj = 2 ceil(pi/4 .7 N), even so that the diagonal
 *               meets the corner
 *   disk        a centre and rings k = 1 .. Ro N of 6 k nodes: nearly equal triangles
 *
 * (all rounded up). */
#include <limits.h>
#include <math.h>
#include "mesh.h"

/* Distance from the centre of a quarter plate to its outer edge. */
static double to_edge(const Scene *s, double cosine, double sine)
{
    return fmin((s->body_hi[0] - s->body.centre[0]) / fmax(cosine, 1e-12),
                (s->body_hi[1] - s->body.centre[1]) / fmax(sine, 1e-12));
}

/* Quads across and along, as doubles: they may be beyond int. */
static void lattice_size(const Scene *s, double cells, double *ni, double *nj)
{
    const Body *b = &s->body;
    double angle = b->angle_hi - b->angle_lo, width = s->body_hi[0] - b->centre[0];
    switch (b->kind) {
    case BODY_RING:
        *ni = mesh_cells_along(b->outer - b->inner, cells);
        *nj = mesh_cells_along(angle * 0.5 * (b->inner + b->outer), cells);
        if (mesh_is_full_turn(b))
            *nj = 2 * ceil(*nj / 2); /* diagonals alternate across the seam, too */
        break;
    case BODY_HOLE_PLATE:
        *ni = mesh_cells_along(0.6 * width, cells);
        *nj = 2 * mesh_cells_along(M_PI / 4 * 0.7 * width, cells);
        break;
    case BODY_DISK:
        *ni = mesh_cells_along(b->outer, cells);
        *nj = 6;
        break;
    default:
        *ni = mesh_cells_along(s->body_hi[0] - s->body_lo[0], cells);
        *nj = mesh_cells_along(s->body_hi[1] - s->body_lo[1], cells);
    }
}

int mesh_takes(const Scene *scene, Fault *fault)
{
    if (scene->body.kind <= BODY_HOLE_PLATE) return 0;
    return fault_set(fault, FAULT_USAGE,
                     "--method: got 'fem', which has no mesh for the body of %s",
                     scene->problem->info.name);
}

int mesh_plan(Mesh *mesh, const Scene *scene, int cells, Fault *fault)
{
    double ni, nj, nodes, elements;
    bool disk = scene->body.kind == BODY_DISK;
    bool closed = scene->body.kind == BODY_RING && mesh_is_full_turn(&scene->body);
    lattice_size(scene, cells, &ni, &nj);
    nodes = disk ? 1 + 3 * ni * (ni + 1) : (ni + 1) * (nj + !closed);
    elements = disk ? 6 * ni * ni : 2 * ni * nj;
    if (elements > INT_MAX / 8.0)
        return fault_set(fault, FAULT_MACHINE, "fem: %.3g elements at %d cells are too many",
                         elements, cells);
    *mesh = (Mesh){.scene = scene,
                   .ni = (int)ni,
                   .nj = (int)nj,
                   .closed = closed,
                   .nodes = (int)nodes,
                   .elements = (int)elements};
    return 0;
}

/* Image of the lattice point (s, t). */
static void place_node(const Scene *scene, double s, double t, Vec X)
{
    const Body *b = &scene->body;
    if (b->kind == BODY_BOX) {
        X[0] = scene->body_lo[0] + s * (scene->body_hi[0] - scene->body_lo[0]);
        X[1] = scene->body_lo[1] + t * (scene->body_hi[1] - scene->body_lo[1]);
        return;
    }
    double angle = b->angle_lo + t * (b->angle_hi - b->angle_lo);
    double cosine = cos(angle), sine = sin(angle);
    double outer = b->kind == BODY_RING ? b->outer : to_edge(scene, cosine, sine);
    double R = b->inner + s * (outer - b->inner);
    X[0] = b->centre[0] + R * cosine;
    X[1] = b->centre[1] + R * sine;
}

static void set(int *const corner[3], int e, int a, int b, int c)
{
    corner[0][e] = a;
    corner[1][e] = b;
    corner[2][e] = c;
}

static void fill_lattice(const Mesh *m, Fields X, int *const corner[3])
{
    int row = m->ni + 1, columns = m->nj + !m->closed, e = 0;
    for (int j = 0; j < columns; j++)
        for (int i = 0; i < row; i++) {
            Vec at;
            place_node(m->scene, (double)i / m->ni, (double)j / m->nj, at);
            for (int d = 0; d < DIM; d++) X[d][j * row + i] = at[d];
        }
    for (int j = 0; j < m->nj; j++)
        for (int i = 0; i < m->ni; i++, e += 2) {
            int a = j * row + i, b = a + 1, d = (j + 1) % columns * row + i, c = d + 1;
            int odd = (i + j) % 2; /* the diagonal runs a-c, or b-d */
            set(corner, e, a, b, odd ? d : c);
            set(corner, e + 1, odd ? b : a, c, d);
        }
}

/* Number of the node at step q of ring k; rings wrap around. */
static int disk_node(int k, int q)
{
    return k == 0 ? 0 : 1 + 3 * k * (k - 1) + q % (6 * k);
}

/* A sector of ring k has k triangles on the outer circle and k - 1 on the inner one. */
static void fill_disk(const Mesh *m, Fields X, int *const corner[3])
{
    const Body *b = &m->scene->body;
    int e = 0;
    for (int d = 0; d < DIM; d++) X[d][0] = b->centre[d];
    for (int k = 1; k <= m->ni; k++)
        for (int q = 0; q < 6 * k; q++) {
            int i = disk_node(k, q), sector = q / k, inner = q - sector;
            double R = b->outer * k / m->ni, angle = M_PI / 3 * q / k;
            X[0][i] = b->centre[0] + R * cos(angle);
            X[1][i] = b->centre[1] + R * sin(angle);
            set(corner, e++, i, disk_node(k, q + 1), disk_node(k - 1, inner));
            if (q % k != k - 1)
                set(corner, e++, disk_node(k - 1, inner), disk_node(k, q + 1),
                    disk_node(k - 1, inner + 1));
        }
}

void mesh_fill(const Mesh *mesh, Fields X, int *const corner[])
{
    if (mesh->scene->body.kind == BODY_DISK)
        fill_disk(mesh, X, corner);
    else
        fill_lattice(mesh, X, corner);
}
