/* test_snapshot.c: polygons of cut cells and elements, and the files of --vtk without a reader. */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "common/run/plan.h"
#include "common/core/step.h"
#include "common/base/table.h"
#include "common/base/vtk_file.h"
#include "tests/check.h"

/* What all polygons of a state cover. */
typedef struct Cover {
    double area, lowest;
    int cut, whole;
    double cell; /* area of a whole cell */
} Cover;

static void add_patch(void *own, const Patch *patch)
{
    Cover *c = own;
    double twice = 0;
    for (int k = 0; k < patch->sides; k++) {
        const double *a = patch->corner[k], *b = patch->corner[(k + 1) % patch->sides];
        twice += a[0] * b[1] - a[1] * b[0];
        for (int d = 0; d < DIM; d++) c->lowest = fmin(c->lowest, a[d]);
    }
    /* counter-clockwise; the area of a sliver may drown in the round-off of its coordinates */
    CU_ASSERT(patch->sides >= 3 && twice > -1e-15);
    const double whole = fabs(twice / 2 - c->cell);
    CU_ASSERT(!(c->cell > 0) || (patch->cut ? twice / 2 <= c->cell : whole <= 1e-14));
    c->area += twice / 2;
    c->cut += patch->cut;
    c->whole += !patch->cut;
}

static Cover cover(const char *problem, const char *method, bool elements)
{
    RunSpec spec = {0};
    Plan plan;
    Fault fault = {0};
    strcpy(spec.problem, problem);
    strcpy(spec.method, method);
    check_context_of(DIM, &spec);
    CU_ASSERT_FATAL(plan_make(&spec, &plan, &fault) == 0);
    void *self = plan.solver->make(&plan.setup, &fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(self);
    CU_ASSERT(plan.solver->elements == elements);
    CU_ASSERT(plan.solver->step(self, 0, 1e-9, true).code == OK);
    Cover c = {.lowest = INFINITY, .cell = elements ? 0 : plan.scene.cell * plan.scene.cell};
    plan.solver->patches(self, add_patch, &c);
    plan.solver->free(self);
    return c;
}

static void test_cover(void)
{
    const Cover disk = cover("disk_impact", "wls2", false);
    CHECK_CLOSE(disk.area, M_PI * 0.04, 2e-4);
    CU_ASSERT(disk.cut > 50 && disk.whole > 200);
    const Cover plate = cover("hole_plate", "wls2", false);
    CHECK_CLOSE(plate.area, 1 - M_PI / 16, 5e-4);
    CU_ASSERT(plate.lowest == 0); /* nothing beyond the symmetry lines */
    const Cover mesh = cover("hole_plate", "fem", true);
    CHECK_CLOSE(mesh.area, 1 - M_PI / 16, 1e-3);
    const Cover none = cover("disk_impact", "gimp", false);
    CU_ASSERT_EQUAL(none.cut + none.whole, 0);
}

static int count_in(const char *path, const char *word)
{
    char line[512];
    FILE *f = fopen(path, "r");
    int n = 0;
    while (f && fgets(line, sizeof line, f)) n += strstr(line, word) != NULL;
    if (f) fclose(f);
    return f ? n : -1;
}

static void test_files(void)
{
    RunSpec spec = {.problem = "disk_impact", .method = "wls2", .cells = 16, .vtk = "snap"};
    Row row;
    Fault fault = {0};
    spec.every = 7;
    mkdir("snap", 0777);
    CU_ASSERT(spec_set(&spec, "steps=20", &fault) == 0);
    check_context_of(DIM, &spec);
    CU_ASSERT_FATAL(run_spec(&spec, &row, &fault) == 0);
    /* 0, 7, 14 and the last */
    CU_ASSERT_EQUAL(count_in("snap/particles.pvd", "<DataSet"), 4);
    CU_ASSERT_EQUAL(count_in("snap/nodes.pvd", "<DataSet"), 4);
    CU_ASSERT_EQUAL(count_in("snap/cells.pvd", "<DataSet"), 4);
    CU_ASSERT_EQUAL(count_in("snap/particles_000020.vtp", "Name=\"displacement\""), 1);
    CU_ASSERT_EQUAL(count_in("snap/particles_000020.vtp", "</VTKFile>"), 1);
    CU_ASSERT_EQUAL(count_in("snap/particles_000020.vtp", "Name=\"von_mises\""), 1);
    CU_ASSERT_EQUAL(count_in("snap/cells_000007.vtp", "Name=\"cut\""), 1);
    CU_ASSERT_EQUAL(count_in("snap/nodes_000000.vtp", "</VTKFile>"), 1);
    static const char *const kinds[] = {"particles", "nodes", "cells"};
    for (int k = 0; k < 3; k++)
        for (int step = -1; step <= 20; step++) {
            char path[64];
            snprintf(path, sizeof path, step < 0 ? "snap/%s.pvd" : "snap/%s_%06d.vtp", kinds[k],
                     step);
            remove(path);
        }
    CU_ASSERT_EQUAL(rmdir("snap"), 0); /* nothing else was left there */
}

/* A scene that only projects has one snapshot, with the grid it projects to. */
static void test_projection(void)
{
    RunSpec spec = {.problem = "patch", .method = "wls2", .cells = 8, .vtk = "snap"};
    Row row;
    Fault fault = {0};
    mkdir("snap", 0777);
    check_context_of(DIM, &spec);
    CU_ASSERT_FATAL(run_spec(&spec, &row, &fault) == 0);
    CU_ASSERT_EQUAL(count_in("snap/particles.pvd", "<DataSet"), 1);
    CU_ASSERT_EQUAL(count_in("snap/nodes.pvd", "<DataSet"), 1);
    CU_ASSERT_EQUAL(count_in("snap/cells.pvd", "<DataSet"), 1);
    CU_ASSERT_EQUAL(count_in("snap/nodes_000000.vtp", "</VTKFile>"), 1);
    CU_ASSERT_EQUAL(system("rm -r snap"), 0);
}

/* Snapshots do not change a run. */
static void test_same_run(void)
{
    RunSpec spec = {.problem = "hole_plate", .method = "wls2", .cells = 8, .vtk = "snap"};
    Row plain, watched;
    Fault fault = {0};
    RunSpec bare = spec;
    bare.vtk = NULL;
    mkdir("snap", 0777);
    check_context_of(DIM, &spec);
    CU_ASSERT_FATAL(run_spec(&bare, &plain, &fault) == 0 && run_spec(&spec, &watched, &fault) == 0);
    CU_ASSERT(plain.energy_drift == watched.energy_drift);
    CU_ASSERT(plain.momentum_drift == watched.momentum_drift);
    CU_ASSERT_EQUAL(system("rm -r snap"), 0);
}

static void test_no_folder(void)
{
    RunSpec spec = {.problem = "disk_impact", .method = "gimp", .cells = 8, .vtk = "absent/folder"};
    Row row;
    Fault fault = {0};
    check_context_of(DIM, &spec);
    CU_ASSERT_EQUAL(run_spec(&spec, &row, &fault), FAULT_MACHINE);
    CU_ASSERT_PTR_NOT_NULL(strstr(fault.text, "absent/folder"));
}

/* Each output that cannot be written is named before anything is built: this mesh would not fit
 * into memory, which would be the fault else. */
static void test_outputs_first(void)
{
    RunSpec plain = {.problem = "ring", .method = "wls2", .cells = 1e6};
    Row row;
    Fault fault = {0};
    check_context_of(DIM, &plain);
    CU_ASSERT_EQUAL(run_spec(&plain, &row, &fault), FAULT_MACHINE);
    CU_ASSERT_PTR_NULL(strstr(fault.text, "absent"));
    for (int k = 0; k < 7; k++) {
        RunSpec one = plain;
        const char **const outputs[] = {&one.history, &one.particles, &one.nodes, &one.samples,
                                        &one.errors,  &one.patches,   &one.vtk};
        *outputs[k] = "absent/place";
        CU_ASSERT_EQUAL(run_spec(&one, &row, &fault), FAULT_MACHINE);
        CU_ASSERT_PTR_NOT_NULL(strstr(fault.text, "absent/place"));
    }
}

/* "Man" is TWFu; eight bytes of length 3 come first. */
static void test_base64(void)
{
    const unsigned char bytes[] = {'M', 'a', 'n'};
    const double x[3][3] = {{0}};
    const VtkArray arrays[] = {{"text", VTK_U8, 1, bytes}, {0}};
    const VtkData data = {.t = 0.5, .points = 3, .x = &x[0][0], .cells = -1, .on_point = arrays};
    CU_ASSERT_EQUAL(vtk_file_write("base64.vtp", &data, NULL), 0);
    CU_ASSERT_EQUAL(count_in("base64.vtp", "_AwAAAAAAAABNYW4="), 1);
    CU_ASSERT_EQUAL(count_in("base64.vtp", "offset=\"16\""), 1); /* of what comes next */
    CU_ASSERT_EQUAL(count_in("base64.vtp", "NumberOfPoints=\"3\" NumberOfVerts=\"3\""), 1);
    remove("base64.vtp");
}

static const TestCase tests[] = {
    {"polygons cover the body", test_cover},
    {"files and collections", test_files},
    {"a projection has its snapshot", test_projection},
    {"a run that is watched is the same run", test_same_run},
    {"a folder that is not there", test_no_folder},
    {"outputs are checked first", test_outputs_first},
    {"base64", test_base64},
    {NULL, NULL},
};
CHECK_SUITE(tests)
