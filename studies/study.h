/* study.h: what a study is: a line in studies.def, and a page: const data, a list of runs, and a
 * check that reads the finished table. The engine (run_study.c, journal.c) runs the cases, keeps
 * the journal, writes NAME.csv, .json, .svg, .png; a page says only what is asked and what is
 * claimed. */
#ifndef MPMLAB_STUDY_H
#define MPMLAB_STUDY_H

#include <stdbool.h>
#include "common/run/engine.h"
#include "common/base/table.h"
#include "measure.h"
#include "phrase.h"

typedef struct Cases Cases;
typedef struct Check Check;
typedef struct Study Study;

/* What a study has left in its folder, for its page. */
typedef struct Results {
    const Study *study;
    const char *dir;   /* the folder */
    bool quick;        /* made with --quick; not known to check() */
    const Table *rows; /* NAME.csv; without rows and columns if there is none */
    struct ResultsOwn *own;
} Results;

/* The last line of a page: const StudyPage study_NAME = {.cases = cases, ...}; */
typedef struct StudyPage {
    void (*cases)(Cases *cases, bool quick); /* or NULL: then tables() writes NAME.csv itself */
    /* Adds the runs that the finished rows ask for, as a bisection does; asked again until it adds
     * none. Rows alone decide, so that a re-run adds the same ones. Or NULL. */
    void (*refine)(Cases *cases, const Table *rows, bool quick);
    /* Writes tables that are not rows of runs (shape functions, points of a figure); or NULL. */
    void (*tables)(const Results *results);
    void (*check)(Check *check, const Results *results); /* or NULL: nothing claimed */
    int claims;       /* that check() makes, whatever the tables hold */
    bool timed;       /* it measures time: its cases run one by one, whatever --jobs says */
    const char *also; /* methods on request that it runs, too: "cpdi,tlmpm"; or NULL */
} StudyPage;

struct Study {
    const char *name;   /* NAME.csv, plots/ROOM/NAME.gp */
    const char *figure; /* "W07-5" */
    const char *about;  /* one line */
    const StudyPage *page;
    const char *room;   /* the folder below studies/ and plots/ that holds its files; or NULL */
    const char *script; /* plots/ROOM/SCRIPT.gp, if that is not NAME */
};

/* Adds one run, given as the command line would: case_add(cases, "run bar --ppc %d", n). */
void case_add(Cases *cases, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same with a file NAME.PART.csv that the run must leave beside the table: kind is "history",
 * "particles", "samples", "errors", "nodes" or "patches". */
void case_add_with(Cases *cases, const char *kind, const char *part, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Such a run with each of these methods ("gimp wls"), and a file NAME.PART.METHOD.csv of each; the
 * format is the run without its method. */
void case_add_each(Cases *cases, const char *kind, const char *part, const char *methods,
                   const char *format, ...) __attribute__((format(printf, 5, 6)));

/* Begins NAME.PART.csv ("": NAME.csv) with this line; it is on disk, whole, when tables() is done.
 * Never NULL; not to be closed. */
FILE *results_write(const Results *results, const char *part, const char *header);
FILE *results_write_notes(const Results *results); /* NAME.var, for gnuplot */

/* Writes cells of such a table as fprintf does (%s, %d, %g and %f, with a precision or without),
 * but leaves a cell empty that has no number: NAN, or an infinite one. */
void results_print(FILE *table, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* NAME.PART.csv, which tables() has written; not to be freed. If it is not there, all claims of the
 * study FAIL, and this table has no rows. */
const Table *results_part(const Results *results, const char *part);

/* The file NAME.PART.csv as a table. results_run: if the run reached its end; results_ended: of any
 * run. Without rows if there is none. It belongs to the results, until eight others were asked for.
 */
const Table *results_run(const Results *results, const char *part, ...)
    __attribute__((format(printf, 2, 3)));
const Table *results_ended(const Results *results, const char *part, ...)
    __attribute__((format(printf, 2, 3)));

/* The path of that file, or NULL: for files that are no tables ("patches"). */
const char *results_path(const Results *results, const char *part);

/* "ok", "lost" or, of a run that is not in the table, "absent": for a column `status`. */
const char *results_status(const Results *results, const char *part);

/* A claim: measured within [low, high] is PASS, else FAIL; FAIL, too, if it was computed from
 * fewer rows than it needs. id like "W07-5.mpm-exponent". */
void claim(Check *check, const char *id, const char *statement, Measure measured, double low,
           double high);

/* The paper's sentence needs [low, high] and does not hold here: DIFFERS with the reason while
 * measured stays within the evidence [seen_low, seen_high]; PASS if it does hold; else FAIL. */
void claim_differs(Check *check, const char *id, const char *statement, Measure measured,
                   double low, double high, double seen_low, double seen_high, const char *reason);

/* A number that the plot shows in its key: NAME.var holds "name = value" for gnuplot. */
void claim_note(Check *check, const char *name, double value);

/* How many cases a study has; 0 if its page is wrong. */
int study_case_count(const Study *study, bool quick);

extern const Study studies[]; /* studies.def; ended by one without a name */

#endif
