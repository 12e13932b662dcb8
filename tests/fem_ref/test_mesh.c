/* test_mesh.c: the FEM meshes of every body: areas, orientation, conformity, masses, limits. */
#include "fem_ref/mesh.h"
#include "fem_check.h"

static const Problem plain = {.info = {.name = "plain"}};

/* Bodies, the exact area of their polygons, and how many pieces of boundary they have. */
typedef struct Shape {
    const char *name;
    Scene scene;
    int cells;
    double area, perimeter;
} Shape;

static double ring_area(double inner, double outer, double step, int n)
{
    return 0.5 * n * sin(step) * (outer * outer - inner * inner);
}

static Scene scene_of(Body body, double lo_x, double lo_y, double hi_x, double hi_y)
{
    return (Scene){.problem = &plain,
                   .mat = material_make(NEO_HOOKEAN, 1e4, 0.3, 2),
                   .c = 100,
                   .body_lo = {lo_x, lo_y},
                   .body_hi = {hi_x, hi_y},
                   .body = body};
}

enum { SHAPES = 5 };

static void shapes(Shape out[SHAPES])
{
    const double quarter = M_PI / 2, turn = 2 * M_PI;
    const int nq = 19, nf = 76,
              ns = 2 * 9; /* 16 cells: ceil(pi/2 .75 16), full, 2 ceil(.35 pi 8) */
    out[0] =
        (Shape){"box", scene_of((Body){.kind = BODY_BOX}, -0.2, 0.1, 1.1, 0.8), 10, 1.3 * 0.7, 4};
    out[1] =
        (Shape){"quarter ring", scene_of((Body){BODY_RING, {0, 0}, 0.5, 1, 0, quarter}, 0, 0, 1, 1),
                16, ring_area(0.5, 1, quarter / nq, nq), 1 + 2 * nq * 1.5 * sin(quarter / nq / 2)};
    out[2] = (Shape){
        "full ring",
        scene_of((Body){BODY_RING, {0.3, -0.2}, 0.5, 1, 0.7, 0.7 + turn}, -0.7, -1.2, 1.3, 0.8), 16,
        ring_area(0.5, 1, turn / nf, nf), 2 * nf * 1.5 * sin(turn / nf / 2)};
    out[3] = (Shape){"disk",
                     scene_of((Body){BODY_DISK, {0.3, 0.3}, 0, 0.2, 0, turn}, 0.1, 0.1, 0.5, 0.5),
                     48, ring_area(0, 0.2, turn / 60, 60), 2 * 60 * 0.2 * sin(turn / 120)};
    out[4] = (Shape){
        "hole plate", scene_of((Body){BODY_HOLE_PLATE, {0, 0}, 0.5, 0, 0, quarter}, 0, 0, 1, 1), 16,
        1 - ring_area(0, 0.5, quarter / ns, ns), 3 + 2 * ns * 0.5 * sin(quarter / ns / 2)};
}

/* Area, mass, and counter-clockwise triangles that are not slivers. */
static void test_areas(void)
{
    Shape shape[SHAPES];
    shapes(shape);
    for (int k = 0; k < SHAPES; k++) {
        Fem *f = make(&shape[k].scene, shape[k].cells, 1);
        double area = 0, mass = 0, share = 0, smallest = 1;
        for (int e = 0; e < f->slots; e++) area += f->A0[e];
        for (int e = 0; e < f->elements; e++) smallest = fmin(smallest, f->A0[e]);
        for (int i = 0; i < f->nodes; i++) mass += f->m[i], share += f->V0[i];
        CHECK_CLOSE(area, shape[k].area, 1e-13);
        CHECK_CLOSE(share, area, 1e-13);
        CHECK_CLOSE(mass, 2 * area, 1e-13);
        CU_ASSERT(smallest * shape[k].cells * shape[k].cells > 0.1); /* of a cell */
        fem_free(f);
    }
}

/* How often the directed edge a -> b occurs. */
static int edge_count(const Fem *f, int a, int b)
{
    int count = 0;
    for (int e = 0; e < f->elements; e++)
        for (int k = 0; k < CORNERS; k++)
            count += f->corner[k][e] == a && f->corner[(k + 1) % CORNERS][e] == b;
    return count;
}

/* Every edge is met once from either side, or once on the boundary, whose length is known. */
static void test_conformity(void)
{
    Shape shape[SHAPES];
    shapes(shape);
    for (int s = 0; s < SHAPES; s++) {
        Fem *f = make(&shape[s].scene, shape[s].cells, 1);
        double perimeter = 0;
        int wrong = 0;
        for (int e = 0; e < f->elements; e++)
            for (int k = 0; k < CORNERS; k++) {
                int a = f->corner[k][e], b = f->corner[(k + 1) % CORNERS][e],
                    back = edge_count(f, b, a);
                wrong += edge_count(f, a, b) != 1 || back > 1;
                if (back == 0) perimeter += hypot(f->X[0][a] - f->X[0][b], f->X[1][a] - f->X[1][b]);
            }
        CU_ASSERT_EQUAL(wrong, 0);
        CHECK_CLOSE(perimeter, shape[s].perimeter, 1e-12);
        fem_free(f);
    }
}

/* The list of corners of each node is complete and starts from zero velocity and F = I. */
static void test_lists(void)
{
    Shape shape[SHAPES];
    shapes(shape);
    for (int s = 0; s < SHAPES; s++) {
        Fem *f = make(&shape[s].scene, shape[s].cells, 1);
        int corners = 0;
        double worst = 0;
        for (int i = 0; i < f->nodes; i++)
            for (int k = 0; k < VALENCE; k++) corners += f->touching[i][k] != no_force(f);
        for (int e = 0; e < f->slots; e++)
            for (int k = 0; k < NMAT; k++) worst = fmax(worst, fabs(f->F[k][e] - (k % 3 == 0)));
        CU_ASSERT_EQUAL(corners, CORNERS * f->elements);
        CU_ASSERT(worst < 1e-13);
        fem_free(f);
    }
}

/* h where the published runs used it; the smaller of h and the least height in plates and disks. */
static void test_time_step(void)
{
    Shape shape[SHAPES];
    shapes(shape);
    for (int s = 0; s < SHAPES; s++) {
        Fem *f = make(&shape[s].scene, shape[s].cells, 1);
        double ratio = solver_fem.unit_dt(f) * shape[s].scene.c * shape[s].cells;
        CU_ASSERT(s < 3 ? ratio == 1 : ratio < 1 && ratio > 0.4);
        fem_free(f);
    }
}

static void test_too_many(void)
{
    Shape shape[SHAPES];
    Fault fault = {0};
    shapes(shape);
    for (int s = 0; s < SHAPES; s++) {
        check_context(DIM, shape[s].name, "fem", "cd", "cells 1e8");
        Setup setup = {
            .scene = &shape[s].scene, .cells = 100000000, .integrator = CD, .threads = 1};
        CU_ASSERT_PTR_NULL(fem_new(&setup, &fault));
        CU_ASSERT_EQUAL(fault.code, FAULT_MACHINE);
    }
    static const Problem odd = {.info = {.name = "odd"}};
    check_context(DIM, "odd", "fem", "cd", NULL);
    CU_ASSERT_EQUAL(solver_fem.takes(&shape[0].scene, &fault), 0);
    const Scene unknown = {.problem = &odd, .body = {.kind = (BodyKind)17}};
    CU_ASSERT_EQUAL(solver_fem.takes(&unknown, &fault), FAULT_USAGE);
}

static const TestCase tests[] = {
    {"areas, masses, orientation", test_areas},
    {"conforming, boundary of the right length", test_conformity},
    {"corner lists complete, F = I at rest", test_lists},
    {"length of the time step", test_time_step},
    {"too large or unknown bodies are refused", test_too_many},
    {NULL, NULL},
};
CHECK_SUITE(tests)
