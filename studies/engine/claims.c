/* claims.c: verdicts. A number that is not there (NAN) always fails. */
#include "claims.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "common/base/info.h"
#include "studies/phrase.h"
#include "studies/runs/must.h"
#include "results.h"
#include "studies/statements.h"
#include "sidecar.h"

const char *claim_verdict_name(Verdict v)
{
    static const char *const names[] = {"PASS", "FAIL", "DIFFERS", "NOT_RUN"};
    return names[v];
}

/* A value under a name that gnuplot takes: letters, digits and _. */
static void write_note(FILE *out, const char *name, double value)
{
    char number[64];
    if (!out) return;
    info_number_print(value, number);
    for (const char *c = name; *c; c++) {
        int plain = (*c >= '0' && *c <= '9') || ((*c | 32) >= 'a' && (*c | 32) <= 'z');
        putc(plain ? *c : '_', out);
    }
    fprintf(out, " = %s\n", isfinite(value) ? number : "NaN");
}

void claim_note(Check *check, const char *name, double value)
{
    write_note(check->stream, name, value);
}

static void add(Check *check, const char *id, const char *statement, Verdict verdict,
                const double bounds[2], Measure measured, const char *reason)
{
    Claim c = {.study = check->study, .verdict = verdict};
    snprintf(c.id, sizeof c.id, "%s", id);
    snprintf(c.statement, sizeof c.statement, "%s", statement);
    snprintf(c.reason, sizeof c.reason, "%s", reason);
    c.measured = isfinite(measured.value) ? measured.value : NAN;
    c.rows = measured.rows;
    c.judged = measured.rows >= measured.needs && !isnan(measured.value);
    c.low = bounds[0];
    c.high = bounds[1];
    check->list = must_grow(check->list, check->n, sizeof c);
    check->list[check->n++] = c;
}

static bool within(double x, double low, double high)
{
    return x >= low && x <= high;
}

/* Why no verdict on the number itself can be given; "" if one can. */
static void why_not(Measure m, char reason[128])
{
    reason[0] = '\0';
    if (m.rows < m.needs)
        snprintf(reason, 128, "the tables have numbers in %d rows, the claim needs %d", m.rows,
                 m.needs);
    else if (isnan(m.value))
        snprintf(reason, 128, "the tables do not give the number");
}

void claim(Check *check, const char *id, const char *statement, Measure measured, double low,
           double high)
{
    claim_differs(check, id, statement, measured, low, high, NAN, NAN, "");
}

void claim_differs(Check *check, const char *id, const char *statement, Measure measured,
                   double low, double high, double seen_low, double seen_high, const char *reason)
{
    const double bounds[] = {low, high};
    char why[128];
    why_not(measured, why);
    write_note(check->stream, id, measured.value);
    if (*why)
        add(check, id, statement, FAIL, bounds, measured, why);
    else if (within(measured.value, low, high))
        add(check, id, statement, PASS, bounds, measured, "");
    else if (within(measured.value, seen_low, seen_high))
        add(check, id, statement, DIFFERS, bounds, measured, reason);
    else
        add(check, id, statement, FAIL, bounds, measured, "outside [low, high]");
}

static void fail_all(Check *check, int from, const char *missing)
{
    for (Claim *c = check->list + from; c < check->list + check->n; c++) {
        c->verdict = FAIL;
        c->judged = false;
        snprintf(c->reason, sizeof c->reason, "%s is not there or is no table", missing);
    }
}

int claims_judge_study(Check *check, const Study *study, const char *dir, Fault *fault)
{
    const int before = check->n;
    Results *r = results_open(study, dir, false);
    check->study = study;
    check->stream = check->notes ? results_write_notes(r) : NULL;
    study->page->check(check, r);
    if (results_missing(r)[0]) fail_all(check, before, results_missing(r));
    const int code = results_close(r, fault);
    if (code) return code;
    if (check->n - before == study->page->claims) return 0;
    return fault_set(fault, FAULT_MACHINE, "study %s: makes %d claims, declares %d", study->name,
                     check->n - before, study->page->claims);
}

static void not_run(Check *check, const Study *study, const char *reason)
{
    const double bounds[] = {NAN, NAN};
    check->study = study;
    add(check, phrase("%s.not-run", study->figure), study->about, NOT_RUN, bounds,
        measure(NAN, 0, 0), reason);
}

int claims_judge_all(Check *check, const char *dir, Fault *fault)
{
    for (const Study *s = studies; s->name; s++) {
        char reason[128];
        if (!s->page->check) continue;
        if (!sidecar_is_current(s, dir, reason))
            not_run(check, s, reason);
        else if (claims_judge_study(check, s, dir, fault))
            return FAULT_MACHINE;
    }
    return 0;
}

static void number_cell(FILE *f, double x)
{
    char text[64] = "";
    if (!isnan(x)) info_number_print(x, text);
    fprintf(f, "%s,", text);
}

const char *claim_group(const Claim *c)
{
    const Statement *s = statement_of_claim(c->id);
    const char *page = c->study->figure;
    if (*page == 'H') return "hard";
    const bool on_page = s && strncmp(page, s->paper, strlen(s->paper)) == 0;
    return on_page && statement_is_published(s) ? s->paper : "own";
}

int claims_write(const Check *check, const char *dir, Fault *fault)
{
    const char *path = phrase("%s/claims.csv", dir);
    FILE *f = file_begin(path, fault);
    if (f)
        fputs("id,figure,statement,measured,low,high,verdict,reason,source,group,rows,sentence\n",
              f);
    for (const Claim *c = check->list; f && c < check->list + check->n; c++) {
        const Statement *s = statement_of_claim(c->id);
        const bool published = s && statement_is_published(s);
        table_put_cell(f, c->id);
        fprintf(f, ",%s,", c->study->figure);
        table_put_cell(f, c->statement);
        putc(',', f);
        number_cell(f, c->measured);
        number_cell(f, c->low);
        number_cell(f, c->high);
        fprintf(f, "%s,", claim_verdict_name(c->verdict));
        table_put_cell(f, c->reason);
        putc(',', f);
        table_put_cell(f, published ? phrase("%s %s", s->paper, s->place) : "");
        fprintf(f, ",%s,%d,", claim_group(c), c->rows);
        table_put_cell(f, s ? s->text : "");
        putc('\n', f);
    }
    return f ? file_commit(f, path, fault) : FAULT_MACHINE;
}
