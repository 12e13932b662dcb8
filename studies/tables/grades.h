/* grades.h: what the pages of the hard cases (H-1 ...) share: grades, which the scoreboard's
 * section on stability collects.
 *
 * NAME.grades.csv: case,method,grade,note. A grade tells how well a method does in a case; the page
 * states its limits. NAME.remedies.csv: case,method,remedy,before,after,note: grades of the same
 * case without and with an option. */
#ifndef MPMLAB_GRADES_H
#define MPMLAB_GRADES_H

#include "curves.h"

typedef enum Mark { MARK_OK, MARK_WEAK, MARK_LOST, MARKS } Mark;
extern const char *const grade_mark_names[MARKS]; /* "ok" "weak" "lost" */

/* problems/block.c: wave speed in dt0 and that of its P waves in 2D and 3D [m/s], and its CFL
 * number. */
#define BLOCK_SPEED   100.0
#define BLOCK_P_SPEED 116.02387
#define BLOCK_CFL     0.3

/* problems/free_block.c: c, W11 eq 33 [m/s]; a turn at its spin [s]. */
#define FREE_C    131.559
#define FREE_TURN (2 * M_PI * 0.7071 / (0.2 * FREE_C))

/* Each method of an engine that the table has rows of, as `const Info *m`: what was not run has no
 * grade. */
#define EACH_METHOD_OF(m, engine, table)                                                           \
    EACH_METHOD(m, engine)                                                                         \
        if (select_next(table, -1, "method=%s", m->name) >= 0)

/* Begin NAME.grades.csv and NAME.remedies.csv, in tables(). */
FILE *grades_write(const Results *results);
FILE *grades_write_remedies(const Results *results);

/* note: a printf format. If a number in it is NAN, the whole note becomes "a run was lost". */
void grade_add(FILE *f, const char *hard_case, const char *method, Mark grade, const char *note,
               ...) __attribute__((format(printf, 5, 6)));

/* note: what the option does to the number, or "". */
void grade_remedy_add(FILE *f, const char *hard_case, const char *method, const char *remedy,
                      Mark before, Mark after, const char *note);

/* MARK_OK while value <= ok, MARK_WEAK while <= weak; else, and if NAN, MARK_LOST. */
Mark grade_mark_of(double value, double ok, double weak);

#endif
