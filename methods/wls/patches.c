/* patches.c: the material's shape on the grid as polygons, in 3D as the faces of polyhedra: full
 * cells and the pieces of cut ones, as the last step integrated them (W11 3.3, fig 1). */
#include "wls.h"
#include "common/base/polygon.h"

/* A cell that is shown. */
typedef struct Shown {
    const Sim *sim;
    int index[DIM];
    PatchVisit *visit;
    void *own;
} Shown;

static void show(const Shown *s, Patch *patch, const double (*x)[3])
{
    for (int k = 0; k < patch->sides; k++)
        for (int d = 0; d < DIM; d++)
            patch->corner[k][d] = (s->index[d] + s->sim->g.origin[d] + x[k][d]) * s->sim->dx;
    s->visit(s->own, patch);
    patch->face++;
}

static void show_square(const Shown *s, const double distance[CORNERS], const Bend *bend, bool cut)
{
    double d[4];
    Polygon piece[MAX_PIECES];
    Curved curved = {{0}, {{0}}};
    for (int k = 0; k < 4; k++) {
        d[k] = distance[k % CORNERS];
        if (bend) curved.kappa[k] = bend[k % CORNERS].kappa[0];
        for (int a = 0; a < 2 && bend; a++) curved.normal[k][a] = bend[k % CORNERS].normal[a % DIM];
    }
    const int pieces = polygon_pieces(d, bend ? &curved : NULL, piece);
    for (int k = 0; k < pieces; k++) {
        double x[MAX_SIDES][3] = {{0}};
        Patch patch = {.sides = piece[k].n, .cut = cut};
        for (int j = 0; j < piece[k].n; j++)
            for (int a = 0; a < 2; a++) x[j][a] = piece[k].x[j][a];
        show(s, &patch, (const double(*)[3])x);
    }
}

/* Sides of the cube are flat; faces of the surface are triangles about an apex. */
static void show_cube(const Shown *s, const double distance[CORNERS], const Bend *bend, bool cut)
{
    Polyhedron p;
    Patch patch = {.cut = cut};
    wls_cell_shape(distance, bend, &p);
    for (const Face *f = p.face; f < p.face + p.faces; f++) {
        double x[MAX_FACE_SIDES][3];
        const int triangles = f->cut ? f->sides : 1;
        for (int t = 0; t < triangles; t++) {
            patch.sides = f->cut ? 3 : f->sides;
            for (int k = 0; k < patch.sides; k++)
                for (int a = 0; a < 3; a++)
                    x[k][a] = f->cut && k == 2 ? f->apex[a] : p.x[f->vertex[(t + k) % f->sides]][a];
            show(s, &patch, (const double(*)[3])x);
        }
    }
}

static void show_cell(const Shown *s, size_t at, const size_t offset[CORNERS])
{
    const Wls *w = wls_of(s->sim);
    double d[CORNERS];
    Bend bend[CORNERS];
    int inside = 0;
    for (int k = 0; k < CORNERS; k++) {
        d[k] = w->distance[at + offset[k]];
        if (w->bend) bend[k] = w->bend[at + offset[k]];
        inside += d[k] > 0;
    }
    (DIM < 3 ? show_square : show_cube)(s, d, w->bend ? bend : NULL, inside < CORNERS);
}

void wls_patches(const Sim *sim, PatchVisit *visit, void *own)
{
    const Grid *g = &sim->g;
    Shown s = {sim, {0}, visit, own};
    CellRow cells;
    for (int row = 0; DIM > 1 && row < g->rows; row++) {
        if (g->lo[row] >= g->hi[row] || !wls_cell_row(g, row, &cells)) continue;
        for (int d = 1, rest = row; d < DIM; d++) s.index[d] = rest % g->n[d], rest /= g->n[d];
        for (int i = cells.lo; i < cells.hi - 1; i++) {
            s.index[0] = i;
            if (!wls_mirrored_cell(g, 0, i))
                show_cell(&s, (size_t)row * (size_t)g->n[0] + (size_t)i, cells.offset);
        }
    }
}
