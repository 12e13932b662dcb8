/* select.h: rows of a table chosen by name, and numbers taken from them.
 *
 * `where` is a format that gives "name=value name=value ...": rows must meet all of them. A name is
 * a column or, in a table of runs, a setting of the run (`nu`, `domain`); "set.steps" is the
 * setting `steps` where a column has that name, too. Any other name is an error of the page: one
 * line with the nearest name on standard error, and exit 1. Values compare as numbers where both
 * are numbers. A setting that every run has and a row does not spell out has its default. */
#ifndef MPMLAB_SELECT_H
#define MPMLAB_SELECT_H

#include <stdbool.h>
#include "common/base/table.h"
#include "measure.h"

/* The study that messages name. */
void select_begin(const char *study);

const char *select_text(const Table *t, int row, const char *column);
double select_number(const Table *t, int row, const char *name); /* NAN: empty, or a word */
bool select_is(const Table *t, int row, const char *column, const char *text);

/* The first row after `row` that meets `where`; -1: there is none, or t is NULL. EACH_ROW(row, t,
 * where, ...) loops over all such rows. */
int select_next(const Table *t, int row, const char *where, ...)
    __attribute__((format(printf, 3, 4)));
#define EACH_ROW(row, t, ...) for (int row = -1; (row = select_next(t, row, __VA_ARGS__)) >= 0;)

/* Does this row meet it? */
bool select_meets(const Table *t, int row, const char *where, ...)
    __attribute__((format(printf, 3, 4)));

/* Did the run of this row end before its time? Energy growth alone does not end one. Tables without
 * a column `status` know of none. */
bool select_is_lost(const Table *t, int row);

/* A number of a row; NAN if its run was lost. */
double select_kept(const Table *t, int row, const char *name);

/* `name` of the first such row: one row. None if its run was lost. */
Measure select_value(const Table *t, const char *name, const char *where, ...)
    __attribute__((format(printf, 3, 4)));

/* The same, of a run that was lost, too: how far it got, how it ended. */
Measure select_ended(const Table *t, const char *name, const char *where, ...)
    __attribute__((format(printf, 3, 4)));

/* Numbers of all such rows, at most `most`, of runs that were not lost; NAN of the others. */
int select_all(const Table *t, const char *name, int most, double out[], const char *where, ...)
    __attribute__((format(printf, 5, 6)));

/* The largest and the smallest value of column `name` in the rows that meet `where`, of which there
 * must be `needs`. NAN if one of these runs was lost. */
Measure select_max(const Table *t, const char *name, int needs, const char *where, ...)
    __attribute__((format(printf, 4, 5)));
Measure select_min(const Table *t, const char *name, int needs, const char *where, ...)
    __attribute__((format(printf, 4, 5)));

/* The largest over all rows. */
Measure select_largest(const Table *t, const char *name, int needs);

/* The value of column `name` in the last row; NAN if the table has none. */
double select_last(const Table *t, const char *name);

/* How many runs of such rows were lost, of `needs` that there must be. */
Measure select_count_lost(const Table *t, int needs, const char *where);

/* The next word at *rest, which is moved behind it; NULL at the end. The word is a phrase
 * (phrase.h): nobody frees it. EACH_WORD(m, "gimp wls") loops over the words as `const char *m`. */
const char *select_word(const char **rest);
#define EACH_WORD(m, words) for (const char *m##_rest = (words), *m; (m = select_word(&m##_rest));)

/* Is it one of the words? */
bool select_is_word(const char *words, const char *word);

#endif
