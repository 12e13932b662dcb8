/* effort_points.h: what effort.c and effort_reach.c share. */
#ifndef MPMLAB_EFFORT_POINTS_H
#define MPMLAB_EFFORT_POINTS_H

#include "effort.h"

/* One case; texts belong to the table of rows. */
typedef struct Effort {
    const char *problem, *method, *integrator, *layout, *status;
    double ppc, cells, error;       /* particles per cell really used; cells per unit length; - */
    double cpu, median;             /* [s] of the repeats: least, median */
    double work, instructions;      /* particle-steps; NAN: not counted */
    bool usable;                    /* reached its end, with an error */
    bool front, front_work;         /* on the problem's Pareto front by CPU time, by work */
    bool front_own, front_own_work; /* on its method's */
} Effort;

typedef struct Efforts {
    int n;
    Effort *list;
} Efforts;

/* NAME.reach.csv. 0 or a fault. */
int effort_reach_write(const Efforts *all, const char *path, Fault *fault);

#endif
