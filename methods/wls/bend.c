/* bend.c: curved surfaces: the curvature and the distance of a node from the surface points near it
 * (their sums: surface.c). See wls.h. */
#include <math.h>
#include "wls.h"

/* Mean outward normal and curvature from the surface sums of a node; false: no curvature is known.
 * With <.> the S-weighted mean and t normal to nbar = <n>/|<n>|:
 *   sb = <r.t>,  s2 = <(r.t)^2> - sb^2,  kappa = <(r.t)(n.t)>/s2. In 2D only. */
static bool find_bend(const Line skin[2], Bend *out)
{
    *out = (Bend){{0}, {0}};
    if (DIM != 2 || !(skin[0][K_ONE] > 0)) return false;
    const double scale = 1 / skin[0][K_ONE], nx = skin[0][K_NORMAL] * scale,
                 ny = skin[0][K_NORMAL + DIM - 1] * scale, length = hypot(nx, ny);
    if (!(length >= 0.9)) return false; /* an edge, or two surfaces */
    const double t[2] = {-ny / length, nx / length};
    double sb = 0, s2 = 0, turn = 0;
    for (int d = 0; d < DIM; d++) {
        sb += scale * skin[0][K_FIRST + d] * t[d % 2];
        for (int e = 0; e < DIM; e++) {
            s2 += scale * skin[1][K_RR + pair(d, e)] * t[d % 2] * t[e % 2];
            turn += scale * skin[1][K_RN + d * DIM + e] * t[d % 2] * t[e % 2];
        }
    }
    s2 -= sb * sb;
    out->normal[0] = nx / length;
    out->normal[AXIS_LAST] = ny / length;
    if (!(s2 >= 1e-3) || !(fabs(turn) <= 0.3 * s2)) return false; /* one point; rough */
    out->kappa[0] = turn / s2;
    return true;
}

/* d = [<r.n_p> + <r>.nbar]/2 - kappa sb^2/2: both means of a circle's distance, whose second-order
 * parts all but cancel; the plain mean along normals where there is no curvature. */
static double flat_distance(const Line skin[2], Bend *bend)
{
    const double along = skin[0][K_ALONG] / skin[0][K_ONE];
    if (!find_bend(skin, bend)) return along;
    double r[DIM], mean = 0;
    for (int d = 0; d < DIM; d++) {
        r[d] = skin[0][K_FIRST + d] / skin[0][K_ONE];
        mean += r[d] * bend->normal[d];
    }
    const double sb = r[AXIS_LAST] * bend->normal[0] - r[0] * bend->normal[AXIS_LAST];
    return 0.5 * (along + mean) - 0.5 * bend->kappa[0] * sb * sb;
}

/* Tangents t of a unit vector n. */
static void tangents(const double n[3], double t[2][3])
{
    int axis = 0;
    double length = 0;
    for (int a = 1; a < 3; a++)
        if (fabs(n[a]) < fabs(n[axis])) axis = a;
    for (int a = 0; a < 3; a++) {
        t[0][a] = (a == axis) - n[axis] * n[a];
        length += t[0][a] * t[0][a];
    }
    for (int a = 0; a < 3; a++) t[0][a] /= sqrt(length);
    for (int a = 0; a < 3; a++)
        t[1][a] = n[(a + 1) % 3] * t[0][(a + 2) % 3] - n[(a + 2) % 3] * t[0][(a + 1) % 3];
}

/* Covariances of surface points about a node in the tangents: of r, and of their normals with r. */
static void tangent_covariances(const Line skin[2], const double mean[2][3], double t[2][3],
                                double C[2][2], double G[2][2])
{
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            C[i][j] = G[i][j] = 0;
            for (int a = 0; a < DIM; a++)
                for (int b = 0; b < DIM; b++) {
                    const double rr = skin[1][K_RR + pair(a, b)] / skin[0][K_ONE],
                                 rn = skin[1][K_RN + b * DIM + a] / skin[0][K_ONE];
                    C[i][j] += t[i][a] * t[j][b] * (rr - mean[0][a] * mean[0][b]);
                    G[i][j] += t[i][a] * t[j][b] * (rn - mean[1][a] * mean[0][b]);
                }
        }
}

/* Curvature in the tangents, the symmetric part of G C^-1; false: their points do not determine it,
 * or it is that of an edge. */
static bool tangent_curvature(double C[2][2], double G[2][2], double K[2][2])
{
    const double half = 0.5 * (C[0][0] + C[1][1]), apart = 0.5 * (C[0][0] - C[1][1]);
    const double det = C[0][0] * C[1][1] - C[0][1] * C[0][1];
    if (!(half - sqrt(apart * apart + C[0][1] * C[0][1]) >= 1e-3)) return false;
    for (int i = 0; i < 2; i++) {
        K[i][0] = (G[i][0] * C[1][1] - G[i][1] * C[0][1]) / det;
        K[i][1] = (G[i][1] * C[0][0] - G[i][0] * C[0][1]) / det;
    }
    K[0][1] = K[1][0] = 0.5 * (K[0][1] + K[1][0]);
    const double square = K[0][0] * K[0][0] + 2 * K[0][1] * K[0][1] + K[1][1] * K[1][1];
    return square <= 0.42 * 0.42;
}

/* The same in space, for the paraboloid through the points:
 *   d = [<r.n_p> + <r>.nbar]/2 - s.K s/2,  s: tangential part of <r>. */
static double space_distance(const Line skin[2], Bend *bend)
{
    const double along = skin[0][K_ALONG] / skin[0][K_ONE];
    double mean[2][3] = {{0}}, n[3] = {0}, t[2][3], C[2][2], G[2][2], K[2][2], s[2] = {0};
    double length = 0, across = 0;
    *bend = (Bend){{0}, {0}};
    for (int a = 0; a < DIM; a++) {
        mean[0][a] = skin[0][K_FIRST + a] / skin[0][K_ONE];
        mean[1][a] = skin[0][K_NORMAL + a] / skin[0][K_ONE];
        length += mean[1][a] * mean[1][a];
    }
    length = sqrt(length);
    if (!(length >= 0.9)) return along; /* an edge, or two surfaces */
    for (int a = 0; a < DIM; a++) n[a] = mean[1][a] / length;
    tangents(n, t);
    tangent_covariances(skin, (const double(*)[3])mean, t, C, G);
    if (!tangent_curvature(C, G, K)) return along;
    for (int a = 0; a < DIM; a++) {
        bend->normal[a] = n[a];
        across += mean[0][a] * n[a];
        for (int i = 0; i < 2; i++) s[i] += mean[0][a] * t[i][a];
        for (int b = a; b < DIM; b++)
            for (int i = 0; i < 4; i++)
                bend->kappa[pair(a, b) % BENDS] += t[i / 2][a] * K[i / 2][i % 2] * t[i % 2][b];
    }
    const double bulge = s[0] * s[0] * K[0][0] + 2 * s[0] * s[1] * K[0][1] + s[1] * s[1] * K[1][1];
    return 0.5 * (along + across) - 0.5 * bulge;
}

double wls_curved_distance(const Line skin[2], Bend *bend)
{
    return DIM < 3 ? flat_distance(skin, bend) : space_distance(skin, bend);
}
