/* patches.c: the material's shape on the grid as polygons: full cells and the pieces of cut
 * ones, as the last step integrated them (W11 3.3, fig 1). In two dimensions; none in others. */
#include "wls.h"
#include "common/base/polygon.h"

static void show_polygon(const Sim *sim, const int cell[DIM], const Polygon *p, bool cut,
                         PatchVisit *visit, void *own)
{
    Patch patch = {.sides = p->n, .cut = cut};
    for (int k = 0; k < p->n; k++)
        for (int d = 0; d < DIM; d++)
            patch.corner[k][d] = (cell[d] + sim->g.origin[d] + p->x[k][d % 2]) * sim->dx;
    visit(own, &patch);
}

/* The cell above node `at`, whose neighbour along axis 1 is `up` nodes on. */
static void show_cell(const Sim *sim, const int cell[DIM], size_t at, size_t up, PatchVisit *visit,
                      void *own)
{
    static const Polygon whole = {4, false, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    const double *distance = wls_of(sim)->distance;
    const double d[4] = {distance[at], distance[at + 1], distance[at + up], distance[at + up + 1]};
    Polygon piece[MAX_PIECES];
    Curved curved = {{0}, {{0}}};
    if (d[0] > 0 && d[1] > 0 && d[2] > 0 && d[3] > 0) {
        show_polygon(sim, cell, &whole, false, visit, own);
        return;
    }
    const Bend *bend = wls_of(sim)->bend;
    for (int k = 0; k < 4 && bend; k++) {
        const Bend *b = &bend[at + (size_t)(k & 1) + (k > 1 ? up : 0)];
        curved.kappa[k] = b->kappa;
        for (int a = 0; a < 2; a++) curved.normal[k][a] = b->normal[a % DIM];
    }
    const int pieces = polygon_pieces(d, bend ? &curved : NULL, piece);
    for (int k = 0; k < pieces; k++) show_polygon(sim, cell, &piece[k], true, visit, own);
}

void wls_patches(const Sim *sim, PatchVisit *visit, void *own)
{
    const Grid *g = &sim->g;
    for (int row = 0; DIM == 2 && row + 1 < g->rows; row++) {
        const int lo = g->lo[row] > g->lo[row + 1] ? g->lo[row] : g->lo[row + 1];
        const int hi = g->hi[row] < g->hi[row + 1] ? g->hi[row] : g->hi[row + 1];
        int cell[DIM] = {0};
        cell[DIM - 1] = row;
        if (wls_mirrored_cell(g, DIM - 1, row)) continue;
        for (int i = lo; i < hi - 1; i++) {
            cell[0] = i;
            if (!wls_mirrored_cell(g, 0, i))
                show_cell(sim, cell, (size_t)row * (size_t)g->n[0] + (size_t)i, (size_t)g->n[0],
                          visit, own);
        }
    }
}
