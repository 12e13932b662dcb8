/* image.c: see image.h. */
#include "image.h"
#include <ctype.h>
#include <netpbm/pgm.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <zlib.h>

enum { MOST_SAMPLES = 1 << 30, PATH_ROOM = 256 };

int image_new(Image *out, const int n[3])
{
    const size_t samples = (size_t)n[0] * (size_t)n[1] * (size_t)n[2];
    *out = (Image){{n[0], n[1], n[2]}, malloc(samples * sizeof(uint16_t)), 0};
    for (size_t k = 0; out->grey && k < samples; k++) out->grey[k] = GREY_LIGHT;
    return out->grey != NULL;
}

void image_free(Image *image)
{
    free(image->grey);
    image->grey = NULL;
}

/* The first line of the error that libnetpbm reported before its jump; warnings are dropped. */
static char reported[128];

static void keep_error(const char *text)
{
    snprintf(reported, sizeof reported, "%.*s", (int)strcspn(text, "\n"), text);
}

static void drop_remark(const char *text)
{
    (void)text;
}

/* Makes room for slice k, whose size must be that of the first. */
static bool make_room(Image *im, int k, int columns, int rows)
{
    if (k > 0 && (columns != im->n[0] || rows != im->n[1])) {
        snprintf(reported, sizeof reported, "%d x %d samples, the first slice has %d x %d", columns,
                 rows, im->n[0], im->n[1]);
        return false;
    }
    if (columns < 1 || rows < 1 || (double)columns * rows * (k + 1) > (double)MOST_SAMPLES) {
        snprintf(reported, sizeof reported, "%d x %d samples, takes 1 to 2^30 in all", columns,
                 rows);
        return false;
    }
    *im = (Image){{columns, rows, k + 1}, im->grey, im->checksum};
    uint16_t *more = realloc(im->grey, image_at(im, 0, 0, k + 1) * sizeof *more);
    if (more) im->grey = more;
    if (!more) strcpy(reported, "out of memory");
    return more != NULL;
}

/* Slice k from an open file. libnetpbm ends the process on errors unless it is given a place to
 * jump to. */
static bool read_slice(FILE *f, Image *im, int k)
{
    jmp_buf place;
    gray *volatile row = NULL;
    volatile bool ok = false;
    int columns, rows, format;
    gray most;
    strcpy(reported, "not a PGM or PBM image");
    pm_setusererrormsgfn(keep_error);
    pm_setusermessagefn(drop_remark);
    pm_setjmpbuf(&place);
    if (setjmp(place) == 0) {
        pgm_readpgminit(f, &columns, &rows, &most, &format);
        ok = make_room(im, k, columns, rows) && (row = malloc((size_t)columns * sizeof *row));
        for (int j = im->n[1] - 1; ok && j >= 0; j--) {
            pgm_readpgmrow(f, row, columns, most, format);
            uint16_t *to = im->grey + image_at(im, 0, j, k);
            for (int i = 0; i < columns; i++)
                to[i] = (uint16_t)(((unsigned long)row[i] * GREY_LIGHT + most / 2) / most);
        }
    } else
        ok = false;
    pm_setjmpbuf(NULL);
    free(row);
    return ok;
}

static unsigned long add_checksum(unsigned long sum, FILE *f)
{
    unsigned char part[1 << 14];
    size_t got;
    rewind(f);
    while ((got = fread(part, 1, sizeof part, f)) > 0) sum = crc32(sum, part, (unsigned)got);
    return sum;
}

/* The mode of the file at a path; 0: there is none. */
static mode_t kind_of(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 ? about.st_mode : 0;
}

/* One file; devices and pipes, which may never end, are not opened. */
static int add_file(Image *im, int k, const char *path, Fault *fault)
{
    if (kind_of(path) && !S_ISREG(kind_of(path)))
        return fault_set(fault, FAULT_USAGE, "%.180s is no file", path);
    FILE *f = fopen(path, "rb");
    if (!f) return fault_set(fault, FAULT_USAGE, "%.180s can not be read", path);
    const bool ok = read_slice(f, im, k);
    if (ok) im->checksum = add_checksum(im->checksum, f);
    fclose(f);
    if (ok) return 0;
    return fault_set(fault, FAULT_USAGE, "%.180s: %s", path, reported);
}

/* Name of slice k; false if the pattern has not exactly one %d or %0Nd. */
static bool slice_name(char name[PATH_ROOM], const char *pattern, int k)
{
    const char *mark = strchr(pattern, '%');
    if (!mark || strchr(mark + 1, '%')) return false;
    const char *end = mark + 1;
    while (isdigit((unsigned char)*end)) end++;
    if (*end != 'd' || end - mark > 3) return false;
    return snprintf(name, PATH_ROOM, "%.*s%0*d%s", (int)(mark - pattern), pattern, atoi(mark + 1),
                    k, end + 1) < PATH_ROOM;
}

static int read_stack(Image *out, const char *pattern, Fault *fault)
{
    char name[PATH_ROOM];
    if (!slice_name(name, pattern, 0))
        return fault_set(fault, FAULT_USAGE,
                         "%.180s has no number of the slice, such as %%04d, or several", pattern);
    int first = kind_of(name) ? 0 : 1, n = 0;
    while (slice_name(name, pattern, first + n) && (n == 0 || kind_of(name)))
        if (add_file(out, n++, name, fault)) return FAULT_USAGE;
    return 0;
}

int image_read(Image *out, const char *path, int stack, Fault *fault)
{
    *out = (Image){{0}, NULL, 0};
    const int bad = stack ? read_stack(out, path, fault) : add_file(out, 0, path, fault);
    if (bad) image_free(out);
    return bad;
}
