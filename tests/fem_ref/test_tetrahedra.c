/* test_tetrahedra.c: the FEM in 3D: meshes of every body, their faces for output, threads. */
#include <stdlib.h>
#include <string.h>
#include "fem_check.h"
#include "tests/fixture.h"

/* A body that a scene has, without the scene's motion. */
static const struct Shape {
    const char *problem, *set;
    double cells, volume;
    double deficit;  /* of the volume, of facets, times cells^2 over the volume */
    double altitude; /* least, in cells; 0: not known from elsewhere */
} shapes[] = {
    {"block", "stretch=1", 6, 1, 0, 0},
    {"ring", "A=.1", 8, 0.75 * M_PI / 4 * 0.25, 0.5, 0},
    {"ring", "A=.1;sector=full;angle=20;offset_x=.2", 8, 0.75 * M_PI * 0.25, 0.5, 0},
    {"shell", "A=.1", 8, 0.875 * M_PI / 6, 0.5, 0.196},
    {"shell", "A=.1", 16, 0.875 * M_PI / 6, 0.5, 0.215},
    {"shell", "A=.1;sector=full;angle=20;offset_x=.2;offset_z=-.4", 8, 0.875 * M_PI * 4 / 3, 0.5,
     0.196},
    {"ball_impact", "wall=bilateral", 24, 4.0 / 3 * M_PI * 0.008, 20, 0},
    {"cavity", "", 12, 1 - M_PI / 48, 0.5, 0},
};

static Fem *mesh_of(const struct Shape *s, Fixture *r, int threads)
{
    const Case c = {DIM, s->problem, s->cells, 0, 0, s->set};
    CU_ASSERT_FATAL(fixture_plan(r, &c, "fem", CD, NULL));
    r->plan.setup.threads = threads;
    Fem *f = fem_new(&r->plan.setup, &r->fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    return f;
}

/* Volumes, masses, orientation, altitudes. */
static void test_volumes(void)
{
    for (int k = 0; k < COUNT(shapes); k++) {
        const struct Shape *s = &shapes[k];
        Fixture r;
        Fem *f = mesh_of(s, &r, 1);
        double volume = 0, share = 0, least = INFINITY;
        for (int e = 0; e < f->elements; e++) volume += f->A0[e], least = fmin(least, f->A0[e]);
        for (int i = 0; i < f->nodes; i++) share += f->V0[i];
        const double most = s->volume * (s->deficit / (s->cells * s->cells) + 1e-13);
        CU_ASSERT(least * pow(s->cells, 3) > 0.005); /* of a cell */
        CU_ASSERT(fabs(volume - s->volume) <= most);
        CHECK_CLOSE(share / volume, 1, 1e-13);
        CHECK_CLOSE(solver_fem.unit_dt(f) * f->scene->c, f->edge, 1e-15);
        if (s->altitude > 0) CHECK_CLOSE(f->edge * s->cells, s->altitude, 0.0005);
        fem_free(f);
    }
}

/* The three nodes of a face in ascending order, and whether that turns it over. */
typedef struct Face {
    int node[3], over;
} Face;

static int by_nodes(const void *a, const void *b)
{
    const Face *x = a, *y = b;
    for (int k = 0; k < 3; k++)
        if (x->node[k] != y->node[k]) return x->node[k] < y->node[k] ? -1 : 1;
    return 0;
}

static Face face_of(int a, int b, int c)
{
    Face f = {{a, b, c}, 0};
    for (int pass = 0; pass < 3; pass++) {
        const int k = pass % 2, own = f.node[k];
        if (own <= f.node[k + 1]) continue;
        f.node[k] = f.node[k + 1];
        f.node[k + 1] = own;
        f.over = !f.over;
    }
    return f;
}

static Face *faces_of(const Fem *f)
{
    static const int side[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    Face *face = malloc(sizeof *face * 4 * (size_t)f->elements);
    CU_ASSERT_PTR_NOT_NULL_FATAL(face);
    for (int e = 0; e < f->elements; e++)
        for (int k = 0; k < 4; k++)
            face[4 * e + k] = face_of(f->corner[side[k][0]][e], f->corner[side[k][1]][e],
                                      f->corner[side[k][2]][e]);
    qsort(face, 4 * (size_t)f->elements, sizeof *face, by_nodes);
    return face;
}

/* Do these nodes lie on one plane of the box around the body, or at one radius? */
static bool on_surface(const Fem *f, const Face *face)
{
    const Scene *s = f->scene;
    const bool ring = s->body.kind == BODY_RING;
    double spread[2 * DIM + 2] = {0};
    for (int k = 0; k < 3; k++) {
        double R = 0;
        for (int d = 0; d < DIM; d++) {
            const double x = f->X[d][face->node[k]];
            spread[2 * d] = fmax(spread[2 * d], fabs(x - s->body_lo[d]));
            spread[2 * d + 1] = fmax(spread[2 * d + 1], fabs(x - s->body_hi[d]));
            if (d < 2 || !ring) R += pow(x - s->body.centre[d], 2);
        }
        spread[2 * DIM] = fmax(spread[2 * DIM], fabs(sqrt(R) - s->body.inner));
        spread[2 * DIM + 1] = fmax(spread[2 * DIM + 1], fabs(sqrt(R) - s->body.outer));
    }
    for (int k = 0; k < 2 * DIM + 2; k++)
        if (spread[k] < 1e-12) return true;
    return false;
}

/* Every face is met once from either side, or once on the surface. */
static void test_conformity(void)
{
    for (int s = 0; s < COUNT(shapes); s++) {
        Fixture r;
        Fem *f = mesh_of(&shapes[s], &r, 1);
        Face *face = faces_of(f);
        const int n = 4 * f->elements;
        int wrong = 0, outer = 0;
        for (int k = 0; k < n;) {
            const bool two = k + 1 < n && by_nodes(&face[k], &face[k + 1]) == 0;
            wrong += two ? face[k].over == face[k + 1].over : !on_surface(f, &face[k]);
            wrong += k + 2 < n && by_nodes(&face[k], &face[k + 2]) == 0;
            outer += !two;
            k += two ? 2 : 1;
        }
        CU_ASSERT(wrong == 0 && outer > 0);
        free(face);
        fem_free(f);
    }
}

/* Each corner once in the list of its node. */
static void test_lists(void)
{
    for (int s = 0; s < COUNT(shapes); s++) {
        Fixture r;
        Fem *f = mesh_of(&shapes[s], &r, 1);
        int corners = 0, wrong = 0;
        for (int i = 0; i < f->nodes; i++)
            for (int k = 0; k < VALENCE && f->touching[i][k] != no_force(f); k++, corners++) {
                const int at = f->touching[i][k], e = element_at(at);
                wrong += e >= f->elements || f->corner[(at - force_at(e, 0)) / CHUNK][e] != i;
            }
        CU_ASSERT(corners == CORNERS * f->elements && wrong == 0);
        CU_ASSERT_EQUAL(element_at(no_force(f)), f->slots);
        fem_free(f);
    }
}

/* No bit depends on the number of threads. */
static void test_threads(void)
{
    Fixture one, two;
    Fem *f = mesh_of(&shapes[4], &one, 1), *g = mesh_of(&shapes[4], &two, 2);
    CU_ASSERT(g->threads == 2);
    for (int k = 0; k < 10; k++) {
        CU_ASSERT(solver_fem.step(f, k * 1e-4, 1e-4, k == 0).code == OK);
        CU_ASSERT(solver_fem.step(g, k * 1e-4, 1e-4, k == 0).code == OK);
    }
    for (int d = 0; d < DIM; d++)
        CU_ASSERT(memcmp(f->x[d], g->x[d], sizeof(double) * (size_t)f->nodes) == 0);
    fem_free(f);
    fem_free(g);
}

/* Faces shown for output enclose each element's volume, as it is now. */
static void add_face(void *own, const Patch *p)
{
    double *sum = own;
    const double *a = p->corner[0], *b = p->corner[1], *c = p->corner[2];
    CU_ASSERT_EQUAL(p->sides, 3);
    for (int d = 0; d < 3; d++) {
        const int e = (d + 1) % 3, g = (d + 2) % 3;
        sum[0] += a[d] * (b[e] * c[g] - b[g] * c[e]) / 6;
    }
    sum[1] += p->face == 0 ? p->V0 : 0;
}

static void test_faces(void)
{
    Fixture r;
    Fem *f = mesh_of(&shapes[0], &r, 1);
    double sum[2] = {0};
    solver_fem.patches(f, add_face, sum);
    CHECK_CLOSE(sum[0], 1, 1e-12);
    CHECK_CLOSE(sum[1], 1, 1e-12);
    fem_free(f);
}

static const TestCase tests[] = {
    {"volumes, masses, altitudes", test_volumes},
    {"conforming, with the body's surface", test_conformity},
    {"corner lists complete", test_lists},
    {"threads do not change a bit", test_threads},
    {"faces of elements enclose them", test_faces},
    {NULL, NULL},
};
CHECK_SUITE(tests)
