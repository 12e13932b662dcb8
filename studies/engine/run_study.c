/* run_study.c: one study from its cases to its figure: journal, table, sidecar, notes, plot. */
#include <stdlib.h>
#include "claims.h"
#include "collect.h"
#include "studies/phrase.h"
#include "studies/runs/must.h"
#include "plot.h"
#include "pool.h"
#include "results.h"
#include "sidecar.h"
#include "run_study.h"

int study_case_count(const Study *study, bool quick)
{
    Cases cases;
    int code = cases_build(&cases, study, quick, NULL, "", NULL);
    int n = code ? 0 : cases.n;
    cases_free(&cases);
    return n;
}

static int run_missing(const Study *study, const StudyOptions *o, const Cases *cases,
                       Journal *journal, const char *path, Fault *fault)
{
    int n, *missing = cases_missing(cases, journal, &n);
    int code = pool_run(cases, missing, n, study->page->timed ? 1 : o->jobs, journal, path,
                        study->name, fault);
    free(missing);
    return code ? code : journal_reload(journal, path, fault);
}

static int write_rows(const Study *study, const char *dir, const Cases *cases,
                      const Journal *journal, Fault *fault)
{
    const char *csv = phrase("%s/%s.csv", dir, study->name);
    return study->page->cases ? sidecar_write_rows(cases, journal, csv, fault) : 0;
}

/* The cases that the rows so far ask for, if any. */
static int refine(const Study *study, const StudyOptions *o, Cases *cases, const Journal *journal,
                  Fault *fault)
{
    int code = write_rows(study, o->dir, cases, journal, fault);
    Table *rows = code ? NULL : table_read_part(o->dir, study->name, NULL, fault);
    code = rows ? cases_refine(cases, study, rows, o->quick, fault) : FAULT_MACHINE;
    table_free(rows);
    return code;
}

static int run_cases(const Study *study, const StudyOptions *o, Cases *cases, Journal *journal,
                     const char *path, Fault *fault)
{
    int code, before;
    do {
        before = cases->n;
        code = run_missing(study, o, cases, journal, path, fault);
        if (code == 0 && study->page->refine) code = refine(study, o, cases, journal, fault);
    } while (code == 0 && cases->n > before);
    return code;
}

/* Everything behind the runs. A study without cases writes its NAME.csv itself, in tables(). */
static int finish(const Study *study, const StudyOptions *o, const Cases *cases,
                  const Journal *journal, Fault *fault)
{
    int code = o->keep ? sidecar_keep(study, cases, o->dir, fault) : 0;
    if (code == 0) code = write_rows(study, o->dir, cases, journal, fault);
    if (code == 0 && study->page->tables) code = results_tables(study, o->dir, o->quick, fault);
    if (code == 0) code = sidecar_write(study, cases, o->dir, fault);
    if (code == 0 && study->page->check) {
        Check check = {.notes = true};
        code = claims_judge_study(&check, study, o->dir, fault);
        free(check.list);
    }
    return code ? code : plot_study(study, o->dir, fault);
}

static int run_locked(const Study *study, const StudyOptions *o, Cases *cases, Journal *journal,
                      const char *path, Fault *fault)
{
    if (o->action == STUDY_LIST && study->page->timed)
        fprintf(stderr, "mpmlab: %s measures time: run these one after the other\n", study->name);
    if (o->action == STUDY_LIST) return collect_list(study, cases, journal, o->dir, fault);
    if (o->action == STUDY_COLLECT) {
        int code = collect_merge(study, cases, journal, path, o->dir, fault);
        if (code == 0) code = journal_reload(journal, path, fault);
        if (code) return code;
    }
    int code = run_cases(study, o, cases, journal, path, fault);
    return code ? code : finish(study, o, cases, journal, fault);
}

/* What a study leaves beside its journal must find its place before the runs begin. */
static int check_files(const Study *study, const Cases *cases, const char *dir, Fault *fault)
{
    static const char *const endings[] = {"csv", "json", "var", "svg", "png", "page.png"};
    int code = 0;
    for (size_t k = 0; k < sizeof endings / sizeof *endings && code == 0; k++)
        code = file_check(phrase("%s/%s.%s", dir, study->name, endings[k]), fault);
    for (const Case *c = cases->list; c < cases->list + cases->n && code == 0; c++)
        if (c->file) code = file_check(c->file, fault);
    return code;
}

int run_study(const Study *study, const StudyOptions *o, Fault *fault)
{
    Cases cases;
    Journal journal;
    const char *path = phrase("%s/%s.rows", o->dir, study->name);
    int code = file_make_folder(o->dir, fault);
    if (code == 0)
        code = cases_build(&cases, study, o->quick, o->methods, o->dir, fault);
    else
        cases = (Cases){0};
    bool nothing = code == 0 && o->methods && cases.n == 0; /* none of its cases has the methods */
    if (code == 0 && !nothing) code = journal_open(&journal, path, fault);
    if (code == 0 && !nothing) {
        if (o->action != STUDY_LIST) code = check_files(study, &cases, o->dir, fault);
        if (code == 0 && o->action != STUDY_LIST)
            code = journal_compact(&journal, path, cases.program, fault);
        if (code == 0) code = run_locked(study, o, &cases, &journal, path, fault);
        journal_close(&journal);
    }
    cases_free(&cases);
    return code;
}
