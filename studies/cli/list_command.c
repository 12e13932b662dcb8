/* list_command.c: `list` and `describe`: what there is, and what each takes. */
#include <string.h>
#include "cli.h"
#include "studies/runs/engines.h"

typedef const Info *const *InfoList;

static InfoList problems_of(const Engine *e)
{
    return e->problems;
}

static InfoList methods_of(const Engine *e)
{
    return e->methods;
}

static InfoList integrators_of(const Engine *e)
{
    return e->integrators;
}

static const Info *info_in(InfoList list, const char *name)
{
    for (; *list; list++)
        if (strcmp((*list)->name, name) == 0) return *list;
    return NULL;
}

/* One line: kind, name, every dimension that knows it, what it is. */
static void print_entry(const char *kind, const char *name, InfoList (*of)(const Engine *))
{
    const Info *info = NULL;
    printf("%s\t%s\t", kind, name);
    for (const Engine *const *e = engines; *e; e++) {
        const Info *here = info_in(of(*e), name);
        if (here) printf("%s%d", info ? "," : "", (*e)->dim);
        if (here) info = here;
    }
    printf("\t%s\n", info ? info->about : "");
}

static void print_entries(const char *kind, int names_of(const char *names[], int max),
                          InfoList (*of)(const Engine *))
{
    const char *names[64];
    const int n = names_of(names, 64);
    for (int k = 0; k < n; k++) print_entry(kind, names[k], of);
}

static void list_methods(void)
{
    print_entries("method", engine_method_names, methods_of);
}

static void list_problems(void)
{
    print_entries("problem", engine_problem_names, problems_of);
}

static void list_integrators(void)
{
    for (InfoList i = engines[0]->integrators; *i; i++)
        print_entry("integrator", (*i)->name, integrators_of);
}

/* A study has no dimension of its own. */
static void list_studies(void)
{
    for (const Study *s = studies; s->name; s++)
        printf("study\t%s\t-\t%s: %s\n", s->name, s->figure, s->about);
}

static int list(int argc, char **argv, Fault *fault)
{
    static const char *const kinds[] = {"methods", "problems", "studies", "integrators"};
    static void (*const print[])(void) = {list_methods, list_problems, list_studies,
                                          list_integrators};
    const char *kind = NULL;
    int found = 0, code = options_read(argc, argv, options_none, option_take_word, &kind, fault);
    if (code) return code;
    for (int k = 0; k < 4; k++) {
        if (kind && strcmp(kind, kinds[k]) != 0) continue;
        print[k]();
        found = 1;
    }
    return found ? 0
                 : option_refuse(fault, "KIND", kind, "methods, problems, studies or integrators",
                                 kinds, 4);
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
