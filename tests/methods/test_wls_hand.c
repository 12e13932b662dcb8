/* test_wls_hand.c: WLS worked by hand to the last digit: fits at nodes, one cut cell, its
 * mass and its force on one node (W11 eqs 4, 7-24), in 1D and in 2D; `wls` as published.
 *
 * h = 1, rho_0 = 1, mu = 2, lambda = 0. All samples carry e = 0 but one, which carries e = 1:
 * v_x = e, rho = 1 - e/2 and sigma = e s. A fit is linear in its samples and exact for constants,
 * so that fitting e is all there is to do. The sample with e = 1 has F with J = 2 and
 * sigma = mu (F F^T - I)/J: in 1D F = 2, s = 3; in 2D F = (2 2; 0 1), F F^T = (8 2; 2 1),
 * s_xx = 7, s_xy = 2, s_yy = 0.
 *
 * 1D. Particles at 1.75 and 2.25 (e = 1), a surface point at 2.75.
 * Node 2: r = -1/4, 1/4, 3/4, by eq 4 W = 22/32, 22/32, 9/32.
 *   M00 = 53/32, M01 = 27/128, M11 = 125/512; b0 = 11/16, b1 = 11/64; det = 5896/16384,
 *   c0 = (M11 b0 - M01 b1)/det = 49/134, c1 = (M00 b1 - M01 b0)/det = 26/67.
 * Node 3: r = -5/4, -3/4, -1/4, W = 1/32, 9/32, 22/32.
 *   M00 = 1, M01 = -27/64, M11 = 1/4; b0 = 9/32, b1 = -27/128; det = 295/4096,
 *   c0 = -153/590, c1 = -378/295.
 * beta (eq 13): node 2: 2 (3/4) + 2 (3/4) + 1/4 = 13/4; node 3: 2 (1/4) + 3/4 = 5/4.
 * Distance (eqs 15-17): 3/4 at node 2, -1/4 at node 3: the cell is cut at 2.75, V = 3/4,
 * its centroid is 2.375, S = 5/8, 3/8.
 *   e at node 2's line: 49/134 + (26/67)(3/8) = 137/268;
 *   at node 3's: -153/590 + (378/295)(5/8) = 639/1180;
 *   e = (5/8)(137/268) + (3/8)(639/1180) = 165257/316240 = .5225682...
 * Node 3 receives from this cell alone: m = S V rho = (9/32)(1 - e/2), f = -V sigma G = -(9/4) e.
 *
 * 2D. Particles at (2 +- 1/4, 2 +- 1/4), e = 1 at (2.25, 2.25); a surface point at (2.5, 2) with
 * normal (1, 0). Of trigger .4 node (2, 2) alone is good (largest W 121/256; at (3, 2) 3/8).
 * M02 = M12 = 0: the samples lie symmetrically about y = 2.
 * Node (2, 2), all times 256: W = 121 of the particles, 96 of the surface point.
 *   M00 = 580, M01 = 48, M11 = 54.25, M22 = 30.25; b = 121, 30.25, 30.25;
 *   det = 580 * 54.25 - 48^2 = 29161 = 121 * 241, c0 = (54.25 * 121 - 48 * 30.25)/det = 169/964,
 *   c1 = (580 * 30.25 - 48 * 121)/det = 97/241, c2 = 1.
 * beta of node (2, 2): 4 * 2 (3/4)^2 + 1/2 = 5; of (3, 2): 2 * 2 (1/4)(3/4) + 1/2 = 5/4.
 * Distance: 1/2 at (2, 2), -1/2 at (3, 2); no surface point is near (2, 3), (3, 3), whose beta is
 * below 2, the limit of eq 14: -1. The cell is cut at (2.5, 2) and (2, 2 + 1/3): a triangle,
 * V = 1/12, centroid (2 + 1/6, 2 + 1/9); there S = 20/27 of (2, 2), 1/54 of (3, 3).
 *   e = 169/964 + (97/241)/6 + 1/9, the plane of the only good node, whatever its S (eq 19).
 * Node (3, 3) receives from this cell alone, G = (1/9, 1/6): m = (1/54)(1/12)(1 - e/2),
 *   f_x = -V (s_xx G_x + s_xy G_y) e = -(1/12)(7/9 + 2/6) e, f_y = -V s_xy G_x e = -(1/12)(2/9) e.
 */
#include "common/contract/layout.h"
#include "methods/wls/wls.h"
#include "tests/fixture.h"

extern const Method method_wls;

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 4, 0, 1);
    for (int d = 0; d < DIM; d++) s->hi[d] = 6, s->body_lo[d] = 1, s->body_hi[d] = 4;
    s->c = 1;
    return 0;
}

/* 1D: 1.75, 2.25, surface 2.75. 2D: the four particles, surface (2.5, 2). */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    Vec X, normal = {1};
    (void)s, (void)spacing, (void)fitted;
    for (int k = 0; k < CORNERS; k++) {
        for (int d = 0; d < DIM; d++) X[d] = k >> d & 1 ? 2.25 : 1.75;
        layout_add(out, X, 0.25, NULL);
    }
    for (int d = 0; d < DIM; d++) X[d] = 2;
    X[0] = DIM == 1 ? 2.75 : 2.5;
    layout_add(out, X, 0, normal);
    return true;
}

/* e = 1 on the last of the particles. */
static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)s, (void)u, (void)L;
    for (int p = 0; p < n; p++) {
        bool marked = true;
        for (int d = 0; d < DIM; d++) marked = marked && X[d][p] > 2.2 && X[d][p] < 2.3;
        if (!marked) continue;
        v[0][p] = 1;
        F[0][p] = 2;
        if (DIM > 1) F[1 % NMAT][p] = 2;
    }
}

static const Problem by_hand = {.cfl = 0.1, .init = init, .place = place, .start = start};

/* Sorted and with its cells integrated; what Sim points to stays in r. */
static Sim *assemble(Fixture *r)
{
    fixture_scene(r, &by_hand, &method_wls, CD, 1, DIM == 1 ? 2 : 4);
    r->plan.setup.fitted = true;
    r->plan.method_par[P_TRIGGER] = DIM == 1 ? 0.12 : 0.4;
    Sim *sim = fixture_sim(r);
    const size_t nodes = (size_t)sim->g.rows * (size_t)sim->g.n[0];
    sim_sort(sim);
    for (size_t at = 0; at < nodes; at++) sim->g.node[at] = (Line){0};
    wls_assemble(sim, 0, true);
    return sim;
}

static size_t node_at(const Sim *sim, int x, int y)
{
    const Grid *g = &sim->g;
    const size_t row = DIM == 1 ? 0 : (size_t)(y - g->origin[DIM - 1]);
    return row * (size_t)g->n[0] + (size_t)(x - g->origin[0]);
}

#define CHECK_HAND(a, b) CU_ASSERT(fabs((a) - (b)) <= 1e-15 * fabs(b))

/* Value and slopes of v_x of a node. */
static void check_fit(const Sim *sim, size_t at, const double c[1 + DIM])
{
    for (int k = 0; k <= DIM; k++) CHECK_HAND(wls_of(sim)->fit[at][FIT_VALUE + k][Q_V], c[k]);
}

static void check_surface(const Sim *sim, size_t at, double beta, double far)
{
    const Wls *w = wls_of(sim);
    CHECK_HAND(w->fit[at][FIT_MOMENTS][M_BETA], beta);
    CHECK_HAND(w->distance[at], far);
}

/* Mass and internal force of a node. */
static void check_node(const Sim *sim, size_t at, double mass, const Vec force)
{
    const Line n = sim->g.node[at];
    CHECK_HAND(n[0], mass);
    for (int a = 0; a < DIM; a++) {
        double f = 0;
        for (int b = 0; b < DIM; b++) f += n[FLUX + b * DIM + a];
        CHECK_HAND(f, force[a]);
    }
}

static void test_line(void)
{
    const double e = 165257.0 / 316240;
    Fixture r;
    if (DIM != 1) return;
    Sim *sim = assemble(&r);
    const size_t inner = node_at(sim, 2, 0), outer = node_at(sim, 3, 0);
    check_fit(sim, inner, (double[1 + DIM]){49.0 / 134, 26.0 / 67});
    check_fit(sim, outer, (double[1 + DIM]){-153.0 / 590, -378.0 / 295});
    check_surface(sim, inner, 13.0 / 4, 0.75);
    check_surface(sim, outer, 5.0 / 4, -0.25);
    check_node(sim, outer, 9.0 / 32 * (1 - e / 2), (Vec){-9.0 / 4 * e});
    sim_free(sim);
}

static void test_plane(void)
{
    const double e = 169.0 / 964 + 97.0 / 241 / 6 + 1.0 / 9;
    const double inner[] = {169.0 / 964, 97.0 / 241, 1};
    const double force[] = {-1.0 / 12 * (7.0 / 9 + 2.0 / 6) * e, -1.0 / 12 * (2.0 / 9) * e};
    Fixture r;
    if (DIM != 2) return;
    Sim *sim = assemble(&r);
    check_fit(sim, node_at(sim, 2, 2), inner);
    check_surface(sim, node_at(sim, 2, 2), 5, 0.5);
    check_surface(sim, node_at(sim, 3, 2), 5.0 / 4, -0.5);
    check_node(sim, node_at(sim, 3, 3), 1.0 / 54 / 12 * (1 - e / 2), force);
    sim_free(sim);
}

static const TestCase tests[] = {
    {"a line: two fits, a cut cell, a force", test_line},
    {"a plane: a fit, a cut cell, a force", test_plane},
    {NULL, NULL},
};
CHECK_SUITE(tests)
