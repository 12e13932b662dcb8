/* list_command.c: `list` and `describe`: what there is, and what each takes. */
#include <string.h>
#include "cli.h"
#include "studies/runs/engines.h"

typedef const Info *const *InfoList;

/* What `list` knows, in this order; a study has no dimension of its own. */
enum { METHODS, PROBLEMS, STUDIES, INTEGRATORS, KINDS };
static const char *const kinds[KINDS] = {"methods", "problems", "studies", "integrators"};

/* One line: kind (in the singular), name, every dimension that knows it, what it is. */
static void print_entry(int kind, const char *name)
{
    const Info *info = NULL;
    printf("%.*s\t%s\t", (int)strlen(kinds[kind]) - 1, kinds[kind], name);
    for (const Engine *const *e = engines; *e; e++) {
        const Info *here = engine_info_in(kind == METHODS    ? (*e)->methods
                                          : kind == PROBLEMS ? (*e)->problems
                                                             : (*e)->integrators,
                                          name);
        if (here) printf("%s%d", info ? "," : "", (*e)->dim);
        if (here) info = here;
    }
    printf("\t%s\n", info ? info->about : "");
}

static void print_entries(int kind)
{
    const char *names[64];
    int n = 0;
    if (kind == METHODS) n = engine_method_names(names, 64);
    if (kind == PROBLEMS) n = engine_problem_names(names, 64);
    if (kind == INTEGRATORS)
        for (InfoList i = engines[0]->integrators; *i; i++) names[n++] = (*i)->name;
    for (int k = 0; k < n; k++) print_entry(kind, names[k]);
    for (const Study *s = studies; kind == STUDIES && s->name; s++)
        printf("study\t%s\t-\t%s: %s\n", s->name, s->figure, s->about);
}

static int list(int argc, char **argv, Fault *fault)
{
    const char *kind = NULL;
    bool found = false;
    const int code = options_read(argc, argv, options_none, option_take_word, &kind, fault);
    if (code) return code;
    for (int k = 0; k < KINDS; k++) {
        if (kind && strcmp(kind, kinds[k]) != 0) continue;
        print_entries(k);
        found = true;
    }
    return found ? 0
                 : option_refuse(fault, "KIND", kind, "methods, problems, studies or integrators",
                                 kinds, KINDS);
}

const Command list_command = {
    .name = "list",
    .usage = "[methods|problems|studies|integrators]",
    .about = "what there is: kind, name, dimensions and one line each, separated by tabs",
    .options = options_none,
    .run = list,
};

static int refuse_name(const char *name, Fault *fault)
{
    const char *names[192];
    int n = engine_problem_names(names, 64);
    n += engine_method_names(names + n, 64);
    for (InfoList i = engines[0]->integrators; *i; i++) names[n++] = (*i)->name;
    for (const Study *s = studies; s->name && n < 192; s++) names[n++] = s->name;
    const char *meant = name && *name ? study_meant(name) : NULL;
    return option_refuse(fault, "NAME", name ? name : "", "a problem, method, integrator or study",
                         meant ? &meant : names, meant ? 1 : n);
}

static int describe_study(const char *name)
{
    const Study *s = study_named(name, NULL);
    if (!s) return -1;
    printf("study %s\n  figure  %s\n  about   %s\n  cases   %d (quick: %d)\n  table   %s.csv\n",
           s->name, s->figure, s->about, study_case_count(s, false), study_case_count(s, true),
           s->name);
    return 0;
}

static int describe(int argc, char **argv, Fault *fault)
{
    const char *name = NULL;
    int known = 0, code = options_read(argc, argv, options_none, option_take_word, &name, fault);
    if (code) return code;
    if (!name) return refuse_name(name, fault);
    for (const Engine *const *e = engines; *e; e++) known |= (*e)->describe(name, stdout) == 0;
    known |= describe_study(name) == 0;
    return known ? 0 : refuse_name(name, fault);
}

const Command describe_command = {
    .name = "describe",
    .usage = "NAME",
    .about =
        "parameters, defaults and sources of a problem, method or integrator; what a study does",
    .options = options_none,
    .run = describe,
};
