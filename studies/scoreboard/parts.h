/* parts.h: the parts of the page; each writes what stands for its marker in plots/page.html.
 */
#ifndef MPMLAB_PARTS_H
#define MPMLAB_PARTS_H

#include "studies/engine/claims.h"

typedef struct Page {
    FILE *f;
    const Check *claims;
    const char *dir;
} Page;

void page_counts(const Page *page);       /* how many of each verdict */
void page_papers(const Page *page);       /* what holds of each paper, and what differs */
void page_verdicts(const Page *page);     /* one button per verdict */
void page_figure_names(const Page *page); /* one option per figure that has claims */
void page_claims(const Page *page);       /* one row per claim */
void page_which(const Page *page);        /* the best method for each error, from study T-2 */
void page_stability(const Page *page);  /* one row per method: limits, what breaks it, what helps */
void page_figures(const Page *page);    /* one card per figure */
void page_needs(const Page *page);      /* which method by need, with its evidence */
void page_statements(const Page *page); /* what the papers say, sentence by sentence */
void page_problems(const Page *page);   /* one card per problem */

/* How many of the paper's sentences hold in all their claims, wherever these stand. */
void page_sentences(const Page *page, const char *paper);

/* Every method's price of each error, if dir/NAME.reach.csv is there. */
void page_prices(const Page *page, const char *name);

void page_text(FILE *f, const char *text); /* escaped */
void page_element(FILE *f, const char *open, const char *text, const char *close);
void page_claim_link(FILE *f, const Claim *c); /* to its row, in its verdict's colour */

#endif
