/* study_command.c: `study` and `claims`: results made, judged and shown. */
#define _GNU_SOURCE /* O_DIRECTORY */
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>
#include "studies/engine/claims.h"
#include "common/base/stopwatch.h"
#include "cli.h"
#include "studies/runs/must.h"
#include "studies/scoreboard/page.h"
#include "studies/engine/plot.h"
#include "studies/runs/engines.h"
#include "studies/runs/options.h"
#include "studies/engine/run_study.h"

typedef struct StudyArgs {
    const char *name; /* as typed */
    StudyOptions options;
} StudyArgs;

static const char default_out[] = "build/out";

static const Option study_options[] = {
    {"quick", NULL, "fewer and smaller cases, into OUT/quick; no verdicts"},
    {"jobs", "N", "cases at once, each in a process (default 1; timed studies: always 1)"},
    {"out", "DIR", "where results go (default build/out)"},
    {"method", "M,M", "only the cases of these methods; no verdicts"},
    {"list", NULL, "only print the missing cases, one command per line"},
    {"collect", NULL, "first take in the rows that such commands have left"},
    {NULL, NULL, NULL},
};

/* Figures are written W07-5, W07_5 or w07-5. */
static bool is_figure(const char *figure, const char *text)
{
    for (; *figure && *text; figure++, text++)
        if (tolower((unsigned char)*figure) != tolower((unsigned char)*text) &&
            !(*figure == '-' && *text == '_'))
            return false;
    return !*figure && !*text;
}

const char *study_meant(const char *text)
{
    const char *meant = NULL;
    int n = 0;
    for (const Study *s = studies; s->name; s++) {
        if (is_figure(s->figure, text)) return s->name;
        if (strncmp(s->name, text, strlen(text)) != 0) continue;
        meant = s->name;
        n++;
    }
    return n == 1 ? meant : NULL;
}

const Study *study_named(const char *name, Fault *fault)
{
    const char *names[128] = {"all"};
    int n = 1;
    for (const Study *s = studies; s->name && n < 128; s++) {
        if (strcmp(s->name, name) == 0) return s;
        names[n++] = s->name;
    }
    const char *meant = study_meant(name);
    option_refuse(fault, "NAME", name, "a study or all", meant ? &meant : names, meant ? 1 : n);
    return NULL;
}

/* Every word of "mpm,gimp" must be a method. */
static int methods_check(const char *words, Fault *fault)
{
    char word[64];
    for (;; words++) {
        size_t n = strcspn(words, ",");
        snprintf(word, sizeof word, "%.*s", (int)n, words);
        int code = engine_check_method("--method", word, fault);
        words += n;
        if (code || !*words) return code;
    }
}

static int take_name(StudyArgs *args, const char *got, Fault *fault)
{
    if (args->name) return option_refuse(fault, "NAME", got, "one study or all", NULL, 0);
    args->name = got;
    return strcmp(got, "all") == 0 || study_named(got, fault) ? 0 : FAULT_USAGE;
}

static int take_folder(const char **out, const char *got, Fault *fault)
{
    *out = got;
    return *got ? 0 : fault_set(fault, FAULT_USAGE, "--out: got '', takes a folder");
}

int study_take_option(StudyOptions *o, const char *name, const char *got, Fault *fault)
{
    const bool list = strcmp(name, "list") == 0;
    if (strcmp(name, "out") == 0) return take_folder(&o->dir, got, fault);
    if (strcmp(name, "jobs") == 0) return option_whole("--jobs", got, 1024, &o->jobs, fault);
    if (!list && strcmp(name, "collect") != 0) return STUDY_OTHER_OPTION;
    if (o->action != STUDY_DO)
        return fault_set(fault, FAULT_USAGE, "--list, --collect: got both, takes one of them");
    o->action = list ? STUDY_LIST : STUDY_COLLECT;
    return 0;
}

static int take_study(void *into, const char *name, const char *got, Fault *fault)
{
    StudyArgs *args = into;
    if (!name) return take_name(args, got, fault);
    const int code = study_take_option(&args->options, name, got, fault);
    if (code != STUDY_OTHER_OPTION) return code;
    if (strcmp(name, "quick") == 0) {
        args->options.quick = true;
        return 0;
    }
    args->options.methods = got; /* --method */
    return methods_check(got, fault);
}

/* claims.csv and index.html of everything in dir; one program at a time, or the one that read
 * first might write last. */
static int publish(Check *check, bool judged, const char *dir, Fault *fault)
{
    int fd = open(dir, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0 || flock(fd, LOCK_EX) != 0) errno = 0; /* a file system without locks */
    int code = judged ? claims_judge_all(check, dir, fault) : 0;
    if (code == 0 && judged) code = claims_write(check, dir, fault);
    if (code == 0) code = page_write(check, dir, fault);
    if (fd >= 0) close(fd);
    return code;
}

/* One line per study of `study all`, so that a log shows how far it is. */
static void report_study(const Study *study, const StudyOptions *o, const char *fault, double since)
{
    if (o->action == STUDY_LIST) return;
    fprintf(stderr, "mpmlab: %s: %s", study->name, fault ? "failed" : "done");
    if (!o->methods) fprintf(stderr, ", %d cases", study_case_count(study, o->quick));
    fprintf(stderr, ", %.1f s%s%s\n", stopwatch_wall() - since, fault ? ": " : "",
            fault ? fault : "");
}

/* Runs one study or all; the first fault is kept, but only an interruption ends the rest. */
static int run_studies(const StudyArgs *args, Fault *fault)
{
    int code = 0;
    bool drawn = true;
    for (const Study *s = studies; s->name && code != FAULT_INTERRUPTED; s++) {
        Fault f = {0};
        const bool all = strcmp(args->name, "all") == 0;
        const double start = stopwatch_wall();
        if (!all && strcmp(args->name, s->name) != 0) continue;
        int got = run_study(s, &args->options, &f);
        const bool failed = got && got != PLOT_NO_GNUPLOT;
        if (all) report_study(s, &args->options, failed ? f.text : NULL, start);
        if (got == PLOT_NO_GNUPLOT)
            drawn = false;
        else if (got && (code == 0 || got == FAULT_INTERRUPTED)) {
            code = got;
            *fault = f;
        }
    }
    if (!drawn) fputs("mpmlab: gnuplot is not installed: no figures drawn\n", stderr);
    return code;
}

/* Can the claims and the page be written behind the runs? */
static int check_files(const StudyOptions *o, Fault *fault)
{
    static const char *const names[] = {"claims.csv", "index.html"};
    int code = o->action == STUDY_LIST ? 0 : file_make_folder(o->dir, fault);
    for (int k = 0; k < 2 && code == 0 && o->action != STUDY_LIST; k++)
        code = file_check(phrase("%s/%s", o->dir, names[k]), fault);

    return code;
}

static int study(int argc, char **argv, Fault *fault)
{
    StudyArgs args = {.options = {.dir = default_out, .jobs = 1}};
    Check check = {0};
    Fault late;
    int code = options_read(argc, argv, study_options, take_study, &args, fault);
    if (code) return code;
    if (!args.name) return fault_set(fault, FAULT_USAGE, "NAME: got nothing, takes a study or all");
    const char *dir = phrase("%s%s", args.options.dir, args.options.quick ? "/quick" : "");
    args.options.dir = dir;
    if ((code = check_files(&args.options, fault))) return code;
    code = run_studies(&args, fault);
    if (args.options.action != STUDY_LIST && (code == 0 || code == FAULT_MACHINE)) {
        int last = publish(&check, !args.options.quick, dir, code ? &late : fault);
        code = code ? code : last;
    }
    free(check.list);
    return code;
}

const Command study_command = {
    .name = "study",
    .usage = "NAME|all [options]",
    .about = "runs what a study lacks, writes its table and figure, and judges its claims",
    .options = study_options,
    .run = study,
};

static const Option claims_options[] = {
    {"out", "DIR", "where the results are (default build/out)"},
    {NULL, NULL, NULL},
};

static int take_claims(void *into, const char *name, const char *got, Fault *fault)
{
    if (!name) return option_refuse(fault, "argument", got, "options only", NULL, 0);
    return take_folder(into, got, fault);
}

static void print_number(double x, int width)
{
    if (isnan(x))
        printf("%*s", width, "-");
    else
        printf("%*.5g", width, x);
}

static void print_claim(const Claim *c, int id_width, bool colour)
{
    static const char *const codes[] = {"\033[32m", "\033[31m", "\033[33m", "\033[2m"};
    printf("%s%-7s%s  %-*s  ", colour ? codes[c->verdict] : "", claim_verdict_name(c->verdict),
           colour ? "\033[0m" : "", id_width, c->id);
    print_number(c->measured, 12);
    printf("  [");
    print_number(c->low, 0);
    printf(", ");
    print_number(c->high, 0);
    printf("]  %s%s%s\n", c->statement, c->reason[0] ? ": " : "", c->reason);
}

static int claims(int argc, char **argv, Fault *fault)
{
    const char *out = default_out;
    Check check = {0};
    int width = 0, failed = 0;
    int code = options_read(argc, argv, claims_options, take_claims, &out, fault);
    if (code == 0 && out != default_out && access(out, F_OK) != 0)
        code = option_refuse(fault, "--out", out, "a folder that is there", NULL, 0);
    if (code == 0) code = file_make_folder(out, fault);
    if (code == 0) code = publish(&check, true, out, fault);
    for (int k = 0; k < check.n; k++) {
        int n = (int)strlen(check.list[k].id);
        width = n > width ? n : width;
        failed |= check.list[k].verdict == FAIL;
    }
    for (int k = 0; k < check.n && code == 0; k++)
        print_claim(&check.list[k], width, isatty(STDOUT_FILENO));
    free(check.list);
    return code ? code : failed ? EXIT_CLAIM_FAILED : 0;
}

const Command claims_command = {
    .name = "claims",
    .usage = "[--out DIR]",
    .about = "judges every claim on the tables on disk; status 3 if one fails",
    .options = claims_options,
    .run = claims,
};
