/* test_tetrahedra.c: the FEM in 3D: meshes of every body, patch, body force, ledger, threads. */
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

static Fem *mesh_of(const struct Shape *s, Rig *r, int threads)
{
    const Case c = {DIM, s->problem, s->cells, 0, 0, s->set};
    CU_ASSERT_FATAL(rig_plan(r, &c, "fem", CD, NULL));
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
        Rig r;
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
        Rig r;
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
        Rig r;
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

/* ---- motion */

static const Mat affine = {1.2, 0.3, -0.1, -0.05, 0.9, 0.2, 0.1, -0.15, 1.1};

static void start_affine(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F,
                         Fields L)
{
    (void)s, (void)v, (void)F, (void)L;
    for (int p = 0; p < n; p++)
        for (int a = 0; a < DIM; a++) {
            u[a][p] = -X[a][p];
            for (int b = 0; b < DIM; b++) u[a][p] += affine[a * DIM + b] * X[b][p];
        }
}

/* b = (1, 2, 3) + X: linear, so that one point an element integrates it exactly. */
static void linear_body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    (void)s, (void)t;
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < n; p++) b[a][p] = a + 1 + X[a][p];
}

static const Problem strained = {.info = {.name = "strained"}, .start = start_affine};
static const Problem pulled = {.info = {.name = "pulled"}, .body = linear_body};

/* The octant of a shell, or (kind box) a unit cube; no walls. */
static Scene free_body(const Problem *problem, BodyKind kind)
{
    Scene s = {.problem = problem,
               .mat = material_make(NEO_HOOKEAN, 1e4, 0.3, 2),
               .body_hi = {1, 1, 1},
               .octant = true,
               .body = {.kind = kind, .inner = 0.5, .outer = 1}};
    for (int d = 0; d < DIM; d++) s.turn[d * (DIM + 1)] = 1;
    s.c = material_wave_speed_p(&s.mat);
    return s;
}

static bool is_inside(const Fem *f, int i)
{
    double R = 0;
    bool in = true;
    for (int d = 0; d < DIM; d++) {
        R += f->X[d][i] * f->X[d][i];
        in = in && f->X[d][i] > 1e-9;
    }
    return in && R > pow(0.5 + 1e-9, 2) && R < pow(1 - 1e-9, 2);
}

/* A uniform strain is seen exactly by every element and leaves the nodes inside without force. */
static void test_patch(void)
{
    const Scene s = free_body(&strained, BODY_SHELL);
    Fem *f = make(&s, 8, 1);
    double inside = 0, outside = 0;
    for (int e = 0; e < f->elements; e++)
        for (int k = 0; k < NMAT; k++) CHECK_CLOSE(f->F[k][e], affine[k], 1e-12);
    CU_ASSERT(solver_fem.step(f, 0, 1e-6, true).code == OK);
    for (int i = 0; i < f->nodes; i++) {
        double *worst = is_inside(f, i) ? &inside : &outside;
        for (int d = 0; d < DIM; d++) *worst = fmax(*worst, fabs(f->v[d][i]));
    }
    CU_ASSERT(outside > 1e-3);
    CU_ASSERT(inside > 0 && inside < 1e-11 * outside);
    fem_free(f);
}

/* The force on a corner is minus the slope of the stored energy as that corner moves. */
static void test_gradient(void)
{
    const Scene s = free_body(&strained, BODY_SHELL);
    Fem *f = make(&s, 4, 1);
    const int e = 7;
    for (int c = 0; c < CORNERS; c++)
        for (int d = 0; d < DIM; d++) {
            const int i = f->corner[c][e];
            const double step = 1e-5, force = f->force[force_at(e, c)][d];
            double psi[2];
            for (int side = 0; side < 2; side++) {
                const double *F[NMAT];
                f->now[i][d] += side ? 2 * step : -step;
                fem_strain(f);
                for (int k = 0; k < NMAT; k++) F[k] = f->F[k] + e;
                material_stored_energy(&s.mat, 1, F, &psi[side]);
            }
            f->now[i][d] -= step;
            fem_strain(f);
            CHECK_CLOSE(force, -f->A0[e] * (psi[1] - psi[0]) / (2 * step), 1e-6 * s.mat.E * 0.01);
        }
    fem_free(f);
}

/* Both ways of taking a linear body force give the body the same momentum, by half a step; inside
 * the integral over an element's corners is what is taken at the node. */
static void test_body(void)
{
    const Scene s = free_body(&pulled, BODY_BOX);
    const double integrate[] = {1}, dt = 1e-5;
    Fault fault = {0};
    Setup setup = {
        .scene = &s, .cells = 6, .integrator = CD, .threads = 1, .method_par = integrate};
    Fem *f = solver_fem.make(&setup, &fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    CU_ASSERT(solver_fem.step(f, 0, dt, true).code == OK);
    Vec given;
    solver_fem.impulse(f, given);
    for (int d = 0; d < DIM; d++)
        CHECK_CLOSE(given[d], 0.5 * dt * s.mat.rho * (d + 1.5), 1e-12 * dt);
    double gap = 0;
    for (int i = 0; i < f->nodes; i++) {
        bool in = true;
        for (int d = 0; d < DIM; d++) in = in && f->X[d][i] > 0.01 && f->X[d][i] < 0.99;
        for (int d = 0; d < DIM && in; d++)
            gap = fmax(gap, fabs(f->v[d][i] - 0.5 * dt * (d + 1 + f->X[d][i])));
    }
    CU_ASSERT(gap < 1e-9 * dt);
    fem_free(f);
}

/* No bit depends on the number of threads. */
static void test_threads(void)
{
    Rig one, two;
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
    Rig r;
    Fem *f = mesh_of(&shapes[0], &r, 1);
    double sum[2] = {0};
    solver_fem.patches(f, add_face, sum);
    CHECK_CLOSE(sum[0], 1, 1e-12);
    CHECK_CLOSE(sum[1], 1, 1e-12);
    fem_free(f);
}

extern const TestCase tetrahedra_tests[];
const TestCase tetrahedra_tests[] = {
    {"volumes, masses, altitudes", test_volumes},
    {"conforming, with the body's surface", test_conformity},
    {"corner lists complete", test_lists},
    {"patch: uniform strain", test_patch},
    {"forces are the slopes of the stored energy", test_gradient},
    {"body force integrated over elements", test_body},
    {"threads do not change a bit", test_threads},
    {"faces of elements enclose them", test_faces},
    {NULL, NULL},
};
