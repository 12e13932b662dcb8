/* patches.c: see patches.h. */
#include "patches.h"

Patches patches_open(const char *path)
{
    return (Patches){.f = path ? fopen(path, "r") : NULL};
}

bool patches_next(Patches *p)
{
    char line[256];
    int cut;
    while (p->f && fgets(line, sizeof line, p->f)) { /* a header, empty lines between polygons */
        if (sscanf(line, "%*d,%d,%lf,%lf,%d,%lf", &p->k, &p->x[0], &p->x[1], &cut, &p->x[2]) < 4)
            continue;
        p->cut = cut;
        p->corners++;
        return true;
    }
    if (p->f) fclose(p->f);
    p->f = NULL;
    return false;
}
