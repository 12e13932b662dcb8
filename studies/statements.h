/* statements.h: what the papers say that can be measured, sentence by sentence in our words, and
 * which claims test it. Data: studies/w07/statements.def, studies/w11/statements.def. */
#ifndef MPMLAB_STATEMENTS_H
#define MPMLAB_STATEMENTS_H

#include <stdbool.h>

typedef struct Statement {
    const char *paper, *place, *text; /* "W07"; section, equation or figure; the sentence */
    const char *claims;               /* ids, separated by blanks; "": none */
    const char *why;                  /* no claim tests it, or "" */
} Statement;

/* In the papers' order, ended by a NULL paper. The lines after a paper's own statements name claims
 * on its pages that test none of its sentences: their place and text are "". */
extern const Statement statements[];

/* The line that names this claim, or NULL. */
const Statement *statement_of_claim(const char *id);

/* Is it a sentence of the paper, and no list of our own claims? */
bool statement_is_published(const Statement *s);

#endif
