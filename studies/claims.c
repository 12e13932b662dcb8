/* claims.c: verdicts. A number that is not there (NAN) always fails. */
#include "claims.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../common/info.h"
#include "memory.h"
#include "sidecar.h"

const char *verdict_name(Verdict v)
{
    static const char *const names[] = {"PASS", "FAIL", "DIFFERS", "NOT_RUN"};
    return names[v];
}

/* A value under a name that gnuplot takes: letters, digits and _. */
static void write_note(FILE *out, const char *name, double value)
{
    char number[64];
    if (!out) return;
    number_print(value, number);
    for (const char *c = name; *c; c++) {
        int plain = (*c >= '0' && *c <= '9') || ((*c | 32) >= 'a' && (*c | 32) <= 'z');
        putc(plain ? *c : '_', out);
    }
    fprintf(out, " = %s\n", isfinite(value) ? number : "NaN");
}

void note_number(Check *check, const char *name, double value)
{
    write_note(check->notes, name, value);
}

static void add(Check *check, const char *id, const char *statement, Verdict verdict,
                const double numbers[3], const char *reason)
{
    Claim c = {.study = check->study, .verdict = verdict};
    snprintf(c.id, sizeof c.id, "%s", id);
    snprintf(c.statement, sizeof c.statement, "%s", statement);
    snprintf(c.reason, sizeof c.reason, "%s", reason);
    c.measured = numbers[0];
    c.low = numbers[1];
    c.high = numbers[2];
    check->list = one_more(check->list, check->n, sizeof c);
    check->list[check->n++] = c;
}

static bool within(double x, double low, double high)
{
    return x >= low && x <= high;
}

void claim(Check *check, const char *id, const char *statement, double measured, double low,
           double high)
{
    claim_differs(check, id, statement, measured, low, high, NAN, NAN, "");
}

void claim_differs(Check *check, const char *id, const char *statement, double measured, double low,
                   double high, double seen_low, double seen_high, const char *reason)
{
    const double numbers[] = {measured, low, high};
    write_note(check->notes, id, measured);
    if (within(measured, low, high))
        add(check, id, statement, PASS, numbers, "");
    else if (within(measured, seen_low, seen_high))
        add(check, id, statement, DIFFERS, numbers, reason);
    else
        add(check, id, statement, FAIL, numbers,
            isnan(measured) ? "the table does not have the number" : "outside [low, high]");
}

int check_study(Check *check, const Study *study, const char *dir, Fault *fault)
{
    char *path = text_of("%s/%s.csv", dir, study->name);
    Table *rows = table_read(path, fault);
    free(path);
    if (!rows) return FAULT_MACHINE;
    check->study = study;
    study->check(check, rows, dir);
    table_free(rows);
    return 0;
}

static void not_run(Check *check, const Study *study, const char *reason)
{
    const double numbers[] = {NAN, NAN, NAN};
    char id[64];
    snprintf(id, sizeof id, "%s.not-run", study->figure);
    check->study = study;
    add(check, id, study->about, NOT_RUN, numbers, reason);
}

int check_all(Check *check, const char *dir, Fault *fault)
{
    for (const Study *const *s = studies; *s; s++) {
        char reason[128];
        if (!(*s)->check) continue;
        if (!sidecar_is_current(*s, dir, reason))
            not_run(check, *s, reason);
        else if (check_study(check, *s, dir, fault))
            return FAULT_MACHINE;
    }
    return 0;
}

static void number_cell(FILE *f, double x)
{
    char text[64] = "";
    if (!isnan(x)) number_print(x, text);
    fprintf(f, "%s,", text);
}

int claims_write(const Check *check, const char *dir, Fault *fault)
{
    char *path = text_of("%s/claims.csv", dir);
    FILE *f = file_begin(path, fault);
    if (f) fputs("id,figure,statement,measured,low,high,verdict,reason\n", f);
    for (const Claim *c = check->list; f && c < check->list + check->n; c++) {
        csv_cell(f, c->id);
        putc(',', f);
        csv_cell(f, c->study->figure);
        putc(',', f);
        csv_cell(f, c->statement);
        putc(',', f);
        number_cell(f, c->measured);
        number_cell(f, c->low);
        number_cell(f, c->high);
        fprintf(f, "%s,", verdict_name(c->verdict));
        csv_cell(f, c->reason);
        putc('\n', f);
    }
    int code = f ? file_commit(f, path, fault) : FAULT_MACHINE;
    free(path);
    return code;
}
