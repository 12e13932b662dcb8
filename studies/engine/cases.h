/* cases.h: the runs that a study asks for, resolved, each with the key its row is kept under. */
#ifndef MPMLAB_CASES_H
#define MPMLAB_CASES_H

#include "journal.h"
#include "studies/study.h"

typedef struct Case {
    RunSpec spec; /* resolved */
    const Engine *engine;
    char *command; /* spec_command(spec) */
    char *key;     /* the command, and what the program was built from */
    char *file;    /* that the run must leave, with its folder; or NULL */
    const char *kind;
} Case;

struct Cases {
    int n, listed; /* listed: those of the study's own list; `refine` added the others */
    Case *list;
    const char *dir;     /* where files go */
    const char *name;    /* the study's: files are NAME.PART.csv */
    const char *methods; /* keep only these ("mpm,gimp"), or NULL: all */
    const char *also;    /* the study's: methods on request that it runs, too */
    char program[16];    /* what this program was built from: the last word of every key */
    Fault fault;         /* the first wrong case, if any */
};

/* Asks the study for its cases. 0, or a fault: the page itself is wrong. */
int cases_build(Cases *cases, const Study *study, bool quick, const char *methods, const char *dir,
                Fault *fault);

/* Calls the study's `refine`, which adds the cases that the finished rows make necessary; n grows
 * if it adds any. 0 or a fault. */
int cases_refine(Cases *cases, const Study *study, const Table *rows, bool quick, Fault *fault);
void cases_free(Cases *cases);

/* Indices into cases of what must still run, each run once; *n of them, owned by the caller. */
int *cases_missing(const Cases *cases, const Journal *journal, int *n);

/* What this program's results depend on: its sources and how they were compiled. */
unsigned long cases_program(void);

/* A checksum over all listed keys: what the table of this study depends on. */
unsigned long cases_checksum(const Cases *cases);

#endif
