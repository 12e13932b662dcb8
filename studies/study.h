/* study.h: what a study is: const data, a list of runs, and a check that reads the finished table.
 * The engine (run_study.c, journal.c) runs the cases, keeps the journal, writes NAME.csv, .json,
 * .svg, .png; a study page says only what is asked, what is plotted and what is claimed. */
#ifndef MPMLAB_STUDY_H
#define MPMLAB_STUDY_H

#include <stdbool.h>
#include "common/run/engine.h"
#include "common/base/table.h"
#include "measure.h"

typedef struct Cases Cases;
typedef struct Check Check;

typedef struct Study {
    const char *name;                        /* NAME.csv, plots/ROOM/NAME.gp */
    const char *figure;                      /* "W07-5" */
    const char *about;                       /* one line */
    void (*cases)(Cases *cases, bool quick); /* or NULL: then tables() writes NAME.csv itself */
    /* Adds the runs that the finished rows ask for, as a bisection does; asked again until it adds
     * none. Rows alone decide, so that a re-run adds the same ones. Or NULL. */
    void (*refine)(Cases *cases, const Table *rows, bool quick);
    /* Tables that are not rows of runs (shape functions, drawings), written into dir; or NULL. */
    int (*tables)(const char *dir, bool quick, Fault *fault);
    void (*check)(Check *check, const Table *rows, const char *dir); /* or NULL: nothing claimed */
    int claims;         /* that check() makes, whatever the tables hold */
    bool timed;         /* it measures time: its cases run one by one, whatever --jobs says */
    const char *script; /* plots/ROOM/SCRIPT.gp, if that is not NAME */
} Study;

/* Adds one run, given as the command line would: case_add(cases, "run bar --ppc %d", n). */
void case_add(Cases *cases, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same with a file that the run must leave beside the table: kind is "history", "particles",
 * "samples", "errors", "nodes" or "patches", file a name within the study's folder. */
void case_add_with(Cases *cases, const char *kind, const char *file, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* A claim: measured within [low, high] is PASS, else FAIL; FAIL, too, if it stands on fewer rows
 * than it needs. id like "W07-5.mpm-exponent". */
void claim(Check *check, const char *id, const char *statement, Measure measured, double low,
           double high);

/* The paper's sentence needs [low, high] and does not hold here: DIFFERS with the reason while
 * measured stays within the evidence [seen_low, seen_high]; PASS if it does hold; else FAIL. */
void claim_differs(Check *check, const char *id, const char *statement, Measure measured,
                   double low, double high, double seen_low, double seen_high, const char *reason);

/* Reads dir/NAME.PART.csv, which tables() wrote. If it is not there, all claims of the study FAIL;
 * then, too, the table that is returned has no rows. */
Table *claim_part(Check *check, const char *dir, const char *part);

/* A number that the plot shows in its key: NAME.var holds "name = value" for gnuplot. */
void claim_note(Check *check, const char *name, double value);

/* Rows of the table that satisfy "column=value" for each of the n texts; collects column `want`.
 * Returns how many were found (at most max). Texts compare as numbers where both are numbers. */
int select_rows(const Table *t, int n, const char *const where[], const char *want, int max,
                double out[]);

/* Does the row satisfy all of them? */
bool row_matches(const Table *t, int row, int n, const char *const where[]);

/* How many cases a study has; 0 if its page is wrong. */
int study_case_count(const Study *study, bool quick);

extern const Study *const studies[]; /* registry.c, NULL-terminated */

/* The folder below studies/ and plots/ that holds the study's files; "." if it is not registered.
 */
const char *study_room(const Study *study);

#endif
