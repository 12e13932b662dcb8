/* claims.h: what studies claim, judged on the tables on disk; claims.csv. */
#ifndef MPMLAB_CLAIMS_H
#define MPMLAB_CLAIMS_H

#include "studies/study.h"

typedef enum Verdict { PASS, FAIL, DIFFERS, NOT_RUN } Verdict;

typedef struct Claim {
    const Study *study;
    char id[64], statement[256], reason[256];
    double measured, low, high;
    int rows;    /* rows of tables that it is computed from */
    bool judged; /* all its rows were there: the verdict is about the number */
    Verdict verdict;
} Claim;

/* Collects the claims of one study or of several, one after the other. */
struct Check {
    const Study *study; /* the one that is checking now */
    int n;
    Claim *list;
    bool notes;   /* write NAME.var, too */
    FILE *stream; /* it, while a study checks */
};

const char *claim_verdict_name(Verdict v);

/* Whose claim it is: "W07", "W11" (it tests a sentence of the paper, statements.h), "hard" or
 * "own". */
const char *claim_group(const Claim *c);

/* Reads dir/NAME.csv and runs the study's check on it, which adds claims to `check`. 0 or a fault;
 * also a fault if the study makes more or fewer claims than it declares. */
int claims_judge_study(Check *check, const Study *study, const char *dir, Fault *fault);

/* The claims of every study, NOT_RUN where its table is absent or is not what it asks for now.
 * 0 or a fault; free check->list in any case. */
int claims_judge_all(Check *check, const char *dir, Fault *fault);

/* Writes dir/claims.csv. 0 or a fault. */
int claims_write(const Check *check, const char *dir, Fault *fault);

#endif
