/* test_scan.c: bodies from images: which samples become particles, where surfaces lie, what is
 * refused; and the moving walls that press them. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>
#include "common/contract/raster.h"
#include "tests/fixture.h"

enum { SIDE = 16, SAMPLES = SIDE * SIDE, FILE_ROOM = 1 << 16 };

/* A file of this test's process; `kind` ends its name. */
static const char *file_name(const char *kind)
{
    static char name[64];
    snprintf(name, sizeof name, "scan%d%s", (int)getpid(), kind);
    return name;
}

static void write_file(const char *kind, const char *head, const void *bytes, size_t n)
{
    FILE *f = fopen(file_name(kind), "wb");
    CU_ASSERT_FATAL(f != NULL);
    fputs(head, f);
    CU_ASSERT(fwrite(bytes, 1, n, f) == n);
    CU_ASSERT(fclose(f) == 0);
}

static void remove_file(const char *kind)
{
    CU_ASSERT(unlink(file_name(kind)) == 0);
}

/* Samples of a scene of the stack: light but for a random third; row 0 is on top. */
static void random_samples(unsigned char grey[SAMPLES])
{
    for (int k = 0; k < SAMPLES; k++) grey[k] = fixture_random(0, 3) < 1 ? 10 : 250;
    grey[0] = 10, grey[SAMPLES - 1] = 250;
}

static bool has_particle(const Sim *sim, double x, double y)
{
    for (int s = 0; s < sim->p.n; s++)
        if (sim->p.id[s] >= 0 &&
            hypot(sim->p.field[AT_X0][s] - x, sim->p.field[AT_X0 + AXIS_Y][s] - y) < 1e-12)
            return true;
    return false;
}

/* The file `kind` at two particles per pixel's width: a particle for every dark sample. */
static void check_samples(const char *kind, const unsigned char grey[SAMPLES])
{
    char set[128];
    Fixture r;
    int dark = 0;
    snprintf(set, sizeof set, "file=%s", file_name(kind));
    const Case c = {2, "scan", SIDE / 2, 4, 0, set};
    CU_ASSERT_FATAL(fixture_plan(&r, &c, "gimp", CD, NULL));
    Sim *sim = fixture_sim(&r);
    for (int k = 0; k < SAMPLES; k++) {
        const double x = (k % SIDE + 0.5) / (double)SIDE, y = 1 - (k / SIDE + 0.5) / (double)SIDE;
        dark += grey[k] < 128;
        CU_ASSERT(has_particle(sim, x, y) == (grey[k] < 128));
    }
    CU_ASSERT(sim->p.count == dark);
    CHECK_CLOSE(sim->p.field[AT_VOL][0], 1.0 / (double)SAMPLES, 1e-15);
    sim_free(sim);
}

/* Binary PGM of one and two bytes, text PGM, binary PBM. */
static void test_formats(void)
{
    unsigned char grey[SAMPLES], wide[2 * SAMPLES], bits[SAMPLES / 8] = {0};
    char text[FILE_ROOM];
    size_t n = 0;
    if (DIM != 2) return;
    random_samples(grey);
    for (int k = 0; k < SAMPLES; k++) {
        wide[2 * k] = (unsigned char)(1000 * grey[k] / 255 >> 8);
        wide[2 * k + 1] = (unsigned char)(1000 * grey[k] / 255 & 255);
        if (grey[k] < 128) bits[k / 8] |= (unsigned char)(128 >> k % 8);
        n += (size_t)snprintf(text + n, sizeof text - n, "%d\n", grey[k]);
    }
    write_file(".pgm", "P5\n# a remark\n16 16\n255\n", grey, sizeof grey);
    check_samples(".pgm", grey);
    write_file(".pgm", "P5\n16 16\n1000\n", wide, sizeof wide);
    check_samples(".pgm", grey);
    write_file(".pgm", "P2 16 16 255\n", text, n);
    check_samples(".pgm", grey);
    remove_file(".pgm");
    write_file(".pbm", "P4\n16 16\n", bits, sizeof bits);
    check_samples(".pbm", grey);
    remove_file(".pbm");
}

/* Largest distance of surface points from the ring's radii, over the pixel, and largest angle of
 * their normals; none lies on a plane of symmetry. */
static void measure_surface(const char *set, double pixel, double *away, double *angle)
{
    const Case c = {DIM, "scan", 16, 0, 0, set};
    Fixture r;
    Layout l = {0};
    CU_ASSERT_FATAL(fixture_plan(&r, &c, "wls2", CD, "load=radial"));
    CU_ASSERT_FATAL(r.plan.scene.problem->place(&r.plan.scene, 1.0 / 32, true, &l));
    *away = *angle = 0;
    for (int p = 0; p < l.n; p++) {
        double square = 0, along = 0;
        for (int d = 0; d < DIM; d++) square += pow(l.X[d][p], 2);
        const double R = sqrt(square), side = R < 0.75 ? -1 : 1;
        if (l.volume[p] > 0) continue;
        for (int d = 0; d < DIM; d++) {
            CU_ASSERT(l.X[d][p] > 1e-3);
            along += side * l.normal[d][p] * l.X[d][p] / R;
        }
        *away = fmax(*away, fmin(fabs(R - 0.5), fabs(R - 1)) / pixel);
        *angle = fmax(*angle, acos(fmin(along, 1)));
    }
    layout_free(&l);
}

/* Halfway between samples is within a pixel's half diagonal; where the grey says it is much nearer.
 */
static void test_surface(void)
{
    double away, angle;
    measure_surface("pixels=64;width=1.1", 1.1 / 64, &away, &angle);
    CU_ASSERT(away < 0.5 * sqrt(DIM) && away > 0.1 && angle < 0.03);
    measure_surface("pixels=64;width=1.1;edge=grey", 1.1 / 64, &away, &angle);
    CU_ASSERT(away < 0.02 && angle < 0.03);
}

/* Image of the repository: the same samples as the drawing, so the same row, but for its name. */
static void test_sample_file(void)
{
    const Case drawn = {2, "scan", 32, 4, 0, "pixels=64;strain=.02"},
               read = {2, "scan", 32, 4, 0, "file=scan_porous.pgm;strain=.02"};
    const RunSpec spec[] = {fixture_spec(&drawn, "wls2", NULL, NULL),
                            fixture_spec(&read, "wls2", NULL, NULL)};
    Row row[2];
    char want[64], bytes[FILE_ROOM];
    if (DIM != 2) return;
    unlink("scan_porous.pgm");
    CU_ASSERT_FATAL(symlink(SCANS "/porous.pgm", "scan_porous.pgm") == 0);
    FILE *f = fopen("scan_porous.pgm", "rb");
    CU_ASSERT_FATAL(f != NULL);
    const size_t n = fread(bytes, 1, sizeof bytes, f);
    fclose(f);
    for (int k = 0; k < 2; k++) CU_ASSERT_FATAL(run_spec(&spec[k], &row[k], NULL) == 0);
    CU_ASSERT(row[0].particles == row[1].particles && row[0].nodes == row[1].nodes);
    CU_ASSERT(row[0].energy_drift == row[1].energy_drift);
    CU_ASSERT(row[0].momentum_drift == row[1].momentum_drift);
    snprintf(want, sizeof want, "checksum=%lu;",
             crc32(0, (const unsigned char *)bytes, (unsigned)n));
    CU_ASSERT(strstr(row[1].params, want) && strstr(row[1].params, "file=scan_porous.pgm;"));
    unlink("scan_porous.pgm");
}

static void check_refused(const char *set, const char *says)
{
    const Case c = {DIM, "scan", 16, 0, 0, set};
    Fixture r;
    CU_ASSERT_FATAL(!fixture_plan(&r, &c, "gimp", CD, NULL));
    CU_ASSERT(r.fault.code == FAULT_USAGE && strstr(r.fault.text, says) != NULL);
}

/* The file `kind` with this content, and more settings. */
static void check_bad(const char *kind, const char *head, size_t n, const char *more,
                      const char *says)
{
    unsigned char light[SAMPLES];
    char set[128];
    memset(light, 255, sizeof light);
    write_file(kind, head, light, n);
    snprintf(set, sizeof set, "file=%s%s", file_name(kind), more);
    check_refused(set, says);
    remove_file(kind);
}

static void test_bad_images(void)
{
    if (DIM != 2) return;
    check_bad(".pgm", "P5\n16 16\n255\n", SAMPLES, "", "darker than the threshold");
    check_bad(".pgm", "P5\n16 16\n255\n", SAMPLES - 1, "", file_name(".pgm"));
    check_bad(".pgm", "P5\n99999999 99999999\n255\n", SAMPLES, "", file_name(".pgm"));
    check_bad(".pgm", "P5\n0 16\n255\n", SAMPLES, "", file_name(".pgm"));
    check_bad(".pgm", "P5\n16 16\n", 0, "", file_name(".pgm"));
    check_bad(".ppm", "P6\n4 4\n255\n", 48, "", file_name(".ppm"));
    check_bad(".png", "\x89PNG\r\n", 48, "", file_name(".png"));
    check_bad(".pgm", "", 0, "", file_name(".pgm"));
    check_bad(".pgm", "P1\n2 2\n1 0 0 1\n", 0, ";checksum=1", "checksum: got 1, the file's is");
    check_refused("file=.", ". is no file");
    check_refused("file=nowhere.pgm", "nowhere.pgm can not be read");
    check_refused("file=a=b.pgm", "without , ; = or a new line");
    check_refused("checksum=5", "a drawing has none");
    check_refused("pixels=9.5", "whole number");
    check_refused("load=radial;width=.9", "outer radius");
}

/* 3D: a stack whose slice k is dark in its first k columns, from slice 1 on. */
static void test_stack(void)
{
    enum { SLICES = 3, WIDE = 4 };
    char set[128], kind[32];
    Fixture r;
    if (DIM != 3) return;
    for (int k = 1; k <= SLICES; k++) {
        unsigned char grey[WIDE * WIDE];
        for (int q = 0; q < WIDE * WIDE; q++) grey[q] = q % WIDE < k ? 0 : 255;
        snprintf(kind, sizeof kind, "_%03d.pgm", k);
        write_file(kind, "P5\n4 4\n255\n", grey, sizeof grey);
    }
    snprintf(set, sizeof set, "dim=3;width=2;file=%s", file_name("_%03d.pgm"));
    const Case c = {3, "scan", 1, 8, 0, set};
    CU_ASSERT_FATAL(fixture_plan(&r, &c, "gimp", CD, NULL));
    CHECK_CLOSE(r.plan.scene.body_hi[AXIS_LAST], 1.5, 1e-15);
    Sim *sim = fixture_sim(&r);
    CU_ASSERT(sim->p.count == WIDE * (1 + 2 + 3));
    sim_free(sim);
    write_file("_002.pgm", "P5\n4 3\n255\n", "000000000000", 12);
    check_refused(set, "the first slice has 4 x 4");
    snprintf(set, sizeof set, "dim=3;file=%s", file_name("_001.pgm"));
    check_refused(set, "has no number of the slice");
    for (int k = 1; k <= SLICES; k++) {
        snprintf(kind, sizeof kind, "_%03d.pgm", k);
        remove_file(kind);
    }
}

/* Platens carry their particles exactly, and their work is what the sample gains. */
static void test_platens(void)
{
    static const char *const judged[] = {"gimp", "ge_gimp", "mpm", "ge_wls"};
    for (int m = 0; m < COUNT(judged) && DIM == 2; m++) {
        const Case c = {2, "scan", 32, 4, 0, "strain=.05"};
        const RunSpec spec = fixture_spec(&c, judged[m], NULL, NULL);
        Row row;
        CU_ASSERT_FATAL(run_spec(&spec, &row, NULL) == 0);
        CHECK_TEXT(row.status, "ok");
        CHECK_CLOSE(row.energy_drift, 0, m == 3 ? 0.03 : 0.01);
        if (m < 3) CHECK_CLOSE(row.momentum_drift, 0, 1e-12);
    }
    for (int threads = 1; threads < 4 && DIM == 2; threads += 2) {
        const Case c = {2, "scan", 32, 4, 0, "strain=.05"};
        Fixture r;
        CU_ASSERT_FATAL(fixture_plan(&r, &c, "ge_gimp", CD, NULL));
        r.plan.setup.threads = threads;
        Sim *sim = fixture_sim(&r);
        CU_ASSERT(fixture_steps(&r, sim, 0, 50));
        double *state = fixture_state(sim);
        const int n = sim->p.count;
        for (int p = 0; p < n; p++) {
            const double Y = state[(AT_X0 + AXIS_Y) * n + p], y = state[(AT_X + AXIS_Y) * n + p];
            const double V = 0.02 * r.plan.scene.c, way = V * 50 * r.dt;
            if (Y < 0.01) CHECK_CLOSE(y - Y, way, 1e-12);
            if (Y > 0.99) CHECK_CLOSE(Y - y, way, 1e-12);
        }
        free(state);
        sim_free(sim);
    }
}

static const TestCase tests[] = {
    {"a particle for every dark sample, in all formats", test_formats},
    {"surface points and normals of the ring", test_surface},
    {"the sample of the repository", test_sample_file},
    {"images that are refused", test_bad_images},
    {"stacks", test_stack},
    {"platens", test_platens},
    {NULL, NULL},
};
CHECK_SUITE(tests)
