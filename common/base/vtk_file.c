/* vtk_file.c: see vtk_file.h. VTK's XML format: every appended array is a UInt64 with its length in
 * bytes and then its bytes, encoded as one; offsets count encoded characters. */
#include <stdlib.h>
#include "info.h"
#include "table.h"
#include "vtk_file.h"

static const struct {
    const char *name;
    int size;
} types[] = {[VTK_F64] = {"Float64", 8}, [VTK_I64] = {"Int64", 8}, [VTK_U8] = {"UInt8", 1}};

/* A base64 stream: three bytes make four characters. */
typedef struct Encoder {
    FILE *out;
    unsigned char held[3];
    int n;
} Encoder;

static void put_group(Encoder *e)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned bits = (unsigned)e->held[0] << 16 | (unsigned)e->held[1] << 8 | e->held[2];
    char text[4] = {digits[bits >> 18], digits[bits >> 12 & 63], digits[bits >> 6 & 63],
                    digits[bits & 63]};
    for (int k = e->n + 1; k < 4; k++) text[k] = '=';
    fwrite(text, 1, 4, e->out);
    *e = (Encoder){.out = e->out};
}

static void put_bytes(Encoder *e, const void *data, uint64_t n)
{
    for (const unsigned char *byte = data; n > 0; n--) {
        e->held[e->n++] = *byte++;
        if (e->n == 3) put_group(e);
    }
}

/* One array of the appended block, in the order in which the header named them. */
typedef struct Block {
    const void *data;
    uint64_t bytes;
} Block;

enum { MOST_BLOCKS = 40 };

typedef struct Writer {
    FILE *out;
    Block block[MOST_BLOCKS];
    int n;
    uint64_t offset;
} Writer;

static void declare(Writer *w, const VtkArray *a, int64_t n)
{
    if (!a->data || w->n == MOST_BLOCKS) return;
    const uint64_t bytes = (uint64_t)n * (uint64_t)(a->components * types[a->type].size);
    fprintf(w->out,
            "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"appended\" "
            "offset=\"%llu\"/>\n",
            types[a->type].name, a->name, a->components, (unsigned long long)w->offset);
    w->block[w->n++] = (Block){a->data, bytes};
    w->offset += (bytes + 8 + 2) / 3 * 4;
}

static void declare_all(Writer *w, const char *where, const VtkArray *list, int64_t n)
{
    if (!list) return;
    fprintf(w->out, "<%s>\n", where);
    for (; list->name; list++) declare(w, list, n);
    fprintf(w->out, "</%s>\n", where);
}

static void append_all(Writer *w)
{
    fputs("<AppendedData encoding=\"base64\">\n_", w->out);
    for (int k = 0; k < w->n; k++) {
        Encoder e = {.out = w->out};
        put_bytes(&e, &w->block[k].bytes, 8);
        put_bytes(&e, w->block[k].data, w->block[k].bytes);
        if (e.n) put_group(&e);
    }
    fputs("\n</AppendedData>\n</VTKFile>\n", w->out);
}

/* Polygons, or a vertex each. */
static void declare_cells(Writer *w, const VtkData *d, const int64_t *count)
{
    const int cloud = d->cells < 0;
    const int64_t cells = cloud ? d->points : d->cells;
    const int64_t corners = cloud ? d->points : cells ? d->end[cells - 1] : 0;
    fprintf(w->out, "<%s>\n", cloud ? "Verts" : "Polys");
    declare(w, &(VtkArray){"connectivity", VTK_I64, 1, cloud ? count : d->corner}, corners);
    declare(w, &(VtkArray){"offsets", VTK_I64, 1, cloud ? count + 1 : d->end}, cells);
    fprintf(w->out, "</%s>\n", cloud ? "Verts" : "Polys");
}

static void write_all(Writer *w, const VtkData *d, const int64_t *count)
{
    char time[64];
    info_number_print(d->t, time);
    const int little = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, cloud = d->cells < 0;
    fprintf(w->out,
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"%s\" "
            "header_type=\"UInt64\">\n<PolyData>\n<FieldData><DataArray type=\"Float64\" "
            "Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">%s</DataArray>"
            "</FieldData>\n<Piece NumberOfPoints=\"%lld\" NumberOfVerts=\"%lld\" "
            "NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"%lld\">\n",
            little ? "LittleEndian" : "BigEndian", time, (long long)d->points,
            (long long)(cloud ? d->points : 0), (long long)(cloud ? 0 : d->cells));
    declare_all(w, "PointData", d->on_point, d->points);
    declare_all(w, "CellData", d->on_cell, d->cells);
    fputs("<Points>\n", w->out);
    declare(w, &(VtkArray){"Points", VTK_F64, 3, d->x}, d->points);
    fputs("</Points>\n", w->out);
    declare_cells(w, d, count);
    fputs("</Piece>\n</PolyData>\n", w->out);
    append_all(w);
}

int vtk_file_write(const char *path, const VtkData *data, Fault *fault)
{
    int64_t *count = malloc(sizeof *count * ((size_t)data->points + 1));
    if (!count) return fault_set(fault, FAULT_MACHINE, "out of memory writing %s", path);
    for (int64_t k = 0; k <= data->points; k++) count[k] = k;
    Writer w = {.out = file_begin(path, fault)};
    int code = w.out ? 0 : FAULT_MACHINE;
    if (w.out) write_all(&w, data, count);
    if (w.out) code = file_commit(w.out, path, fault);
    free(count);
    return code;
}

int vtk_file_collect(const char *path, const char *stem, int n, const long step[], const double t[],
                     Fault *fault)
{
    char time[64];
    FILE *out = file_begin(path, fault);
    if (!out) return FAULT_MACHINE;
    fputs("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n",
          out);
    for (int k = 0; k < n; k++) {
        info_number_print(t[k], time);
        fprintf(out, "<DataSet timestep=\"%s\" part=\"0\" file=\"%s_%06ld.vtp\"/>\n", time, stem,
                step[k]);
    }
    fputs("</Collection>\n</VTKFile>\n", out);
    return file_commit(out, path, fault);
}
