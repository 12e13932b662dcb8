/* errors_file.c: the errors of all points at one instant and their weights in the norms, as a file:
 * any norm over any choice of points can be taken from it, for particles and FEM alike. */
#include <math.h>
#include <stdlib.h>
#include "output.h"
#include "common/base/table.h"

/* slot[id] of points with mass, -1 for others, so that rows come in placement order. */
static int *slots_with_mass(const Points *p, int *count)
{
    int *slot = malloc(sizeof(int) * (size_t)(p->n + 1));
    *count = 0;
    for (int k = 0; slot && k < p->n; k++) slot[k] = -1;
    for (int k = 0; slot && k < p->n; k++) {
        if (p->id[k] < 0) continue;
        slot[p->id[k]] = p->m[k] > 0 ? k : -1;
        if (p->id[k] >= *count) *count = p->id[k] + 1;
    }
    return slot;
}

int output_errors(const char *path, const Scene *scene, const Points *p, double t, Scratch *s,
                  Fault *fault)
{
    int count, *slot = slots_with_mass(p, &count);
    if (!slot) return fault_set(fault, FAULT_MACHINE, "out of memory writing %s", path);
    FILE *out = file_begin(path, fault);
    norm_displacement(scene, p, t, 1, s);
    if (out) fputs("id,X,Y,error,weight,Z\n", out);
    for (int id = 0; out && id < count; id++) {
        const int k = slot[id];
        if (k < 0) continue;
        const double cells[] = {p->X[0][k], DIM > 1 ? p->X[DIM > 1][k] : NAN, s->w[k], p->V0[k],
                                DIM > 2 ? p->X[DIM - 1][k] : NAN};
        fprintf(out, "%d", id);
        for (int c = 0; c < 5; c++) {
            putc(',', out);
            info_number_write(out, cells[c]);
        }
        putc('\n', out);
    }
    free(slot);
    return out ? file_commit(out, path, fault) : FAULT_MACHINE;
}
