/* trial.h: tables of studies that nobody ran: a row and a file for each case, with numbers that are
 * smooth and finite, so that every claim has all it asks for. Then they are spoiled one way or
 * another. */
#ifndef MPMLAB_TRIAL_H
#define MPMLAB_TRIAL_H

#include "studies/engine/cases.h"

enum { TRIAL_PATH = 512 };

/* What is wrong with one row, or with all: nothing; the run was lost and its numbers are empty; its
 * numbers are a thousand times as large, or as small; it is absent; the numbers of each row are
 * multiplied by a factor of its own, 1e-3 to 1e3, or divided by it. */
typedef enum { SOUND, LOST_RUN, LARGER, SMALLER, ABSENT, UNEVEN, UNEVEN_TOO } Spoiled;

/* The text of a table whose rows are all spoiled so; owned by the caller. */
char *trial_text(const Cases *cases, Spoiled how);

/* Writes dir/NAME.csv, every row spoiled so. */
void trial_rows(const Study *study, const Cases *cases, const char *dir, Spoiled how);

/* The same with one row spoiled and the others as in `sound`, of trial_text(cases, SOUND). */
void trial_one_row(const Study *study, const Cases *cases, const char *sound, const char *dir,
                   int row, Spoiled how);

/* Writes the files that the runs would have left. */
void trial_files(const Cases *cases);

/* Leaves the header of every .csv in dir alone. */
void trial_empty(const char *dir);

/* Is the name in a list, which ends with NULL? What ends in a point there stands for all names that
 * begin so. */
bool trial_is_one(const char *name, const char *const list[]);

/* Deletes what is in dir. */
void trial_clear(const char *dir);

#endif
