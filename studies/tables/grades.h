/* grades.h: what the pages of the hard cases (H1 ...) share: who takes part, histories, and grades,
 * which the scoreboard's section on stability collects.
 *
 * NAME.grades.csv: case,method,grade,note. A grade says how a method stands up to a case; the page
 * says where it draws its lines. NAME.remedies.csv: case,method,remedy,before,after: grades of the
 * same case without and with an option. */
#ifndef MPMLAB_GRADES_H
#define MPMLAB_GRADES_H

#include "curves.h"

typedef enum Mark { MARK_OK, MARK_WEAK, MARK_LOST, MARKS } Mark;
extern const char *const grade_mark_names[MARKS]; /* "ok" "weak" "lost" */

/* problems/block.c: wave speed in dt0 [m/s], and its CFL number. */
#define BLOCK_SPEED 100.0
#define BLOCK_CFL   0.3

/* Does this method have a grid (and particles)? FEM has none. */
bool has_grid(const Engine *engine, const char *method);

/* Is this a run that the program takes ("run block --set domain=stretch")? */
bool is_run(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Does it take a parameter of this name? */
bool has_param(const Info *method, const char *name);

/* Open dir/NAME.grades.csv, dir/NAME.remedies.csv; NULL and a fault. To be closed with grades_end,
 * which takes NULL. */
FILE *grades_begin(const char *dir, const char *name, Fault *fault);
FILE *grades_remedies_begin(const char *dir, const char *name, Fault *fault);
int grades_end(FILE *f, const char *dir, const char *name, const char *part, Fault *fault);

/* Tables of a page: dir/NAME.PART.csv by `points` from the rows, then grades by `marks` from that.
 */
int grades_tables(const char *dir, const char *name, const char *part,
                  void (*points)(FILE *f, const Table *rows),
                  void (*marks)(FILE *f, const Table *points), Fault *fault);

void grade_add(FILE *f, const char *hard_case, const char *method, Mark grade, const char *note,
               ...) __attribute__((format(printf, 5, 6)));

void grade_remedy_add(FILE *f, const char *hard_case, const char *method, const char *remedy,
                      Mark before, Mark after);

/* MARK_OK while value <= ok, MARK_WEAK while <= weak; else, and if NAN, MARK_LOST. */
Mark grade_mark_of(double value, double ok, double weak);

/* Largest of column `want` over the rows of these methods ("gimp wls") that also meet `where`
 * ("column=value ..."), `each` of them of every method; NAN if one of them has no such row, was
 * lost, or is NAN. */
Measure curve_worst(const Table *t, const char *methods, int each, const char *want,
                    const char *where);

#endif
