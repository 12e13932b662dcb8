/* effort.h: what accuracy costs, from the rows of a study whose cases were run several times.
 *
 * NAME.points.csv: one point per case: its largest error, CPU time (best and median of its
 * repeats), work (particle-steps; FEM: element-steps; particles where nothing moves), instructions
 * (that many times those of one particle-step, from t_03_speed.csv if it is there and has the
 * method with this integrator), and on which Pareto fronts it is: of all (by CPU time, by work), of
 * its method.
 *
 * NAME.reach.csv: the CPU time and work with which a method at its best reaches a target, by
 * straight lines between meshes in log-log. `how`: reached; below (its coarsest mesh is better:
 * at most so much); extrapolated (from its two finest meshes, at most twice as fine, where
 * these converge with at least three quarters of the order before); never. */
#ifndef MPMLAB_EFFORT_H
#define MPMLAB_EFFORT_H

#include "studies/study.h"

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

/* Writes both tables. The rows are `repeats` times the same cases, all once before any twice;
 * meshes of one set of options stand together, from coarse to fine. */
void effort_tables(const Results *results, int repeats);

/* A column of NAME.reach.csv of one method over that of another, where both reach the target by
 * themselves; `target` is "problem=ring target=0.001". */
Measure effort_ratio(const Results *results, const char *target, const char *column,
                     const char *method, const char *beside);

/* The lines of NAME.reach.csv. */
void effort_reach_write(FILE *f, const Efforts *all);

#endif
