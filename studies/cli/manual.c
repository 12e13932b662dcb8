/* manual.c: see manual.h. Commands and options say what they are themselves (cli.h, options.h). */
#include "manual.h"

#include <string.h>
#include "facts.h"

static const char about[] = "Compares ways to move information between particles and a grid.";

/* Options of the program itself. */
static const Option own[] = {
    {"version", NULL, "version, compiler, flags, dimensions, OpenMP"},
    {"help", NULL, "this text (also help, -h); after a command: its options (also help COMMAND)"},
    {"man", NULL, "all of it as a manual page (man -l)"},
    {"completion", NULL, "completion of words for bash"},
    {NULL, NULL, NULL},
};

/* Lines as they are shown. */
static const struct Section {
    const char *title, *lines[8];
} sections[] = {
    {"Exit status",
     {"0    done; of a run: whatever the status in its row",
      "1    the machine failed: disk, memory, a figure", "2    wrong usage, said in one line",
      "3    claims: one of them fails",
      "130  interrupted (SIGINT, SIGTERM, SIGHUP); everything finished is kept"}},
    {"Files",
     {"OUT/NAME.rows   the rows of a study as they finish; a study goes on from it",
      "OUT/NAME.csv    its table; NAME.json where it comes from; NAME.svg, NAME.png",
      "OUT/claims.csv  the verdicts; OUT/index.html all of it on one page"}},
    {"Environment",
     {"OMP_WAIT_POLICY, GOMP_SPINCOUNT  how the --threads of a run wait for each other (OpenMP); "
      "if",
      "                neither is set they spin for microseconds, then sleep"}},
};
enum { SECTIONS = sizeof sections / sizeof *sections };

void manual_help(const Command *const commands[], int n)
{
    printf("usage: mpmlab COMMAND ...\n%s\n\n", about);
    for (int k = 0; k < n; k++) printf("  %-10s %s\n", commands[k]->name, commands[k]->about);
    printf("\n");
    options_help(own, stdout);
    for (const struct Section *s = sections; s < sections + SECTIONS; s++) {
        printf("\n%s\n", s->title);
        for (int k = 0; s->lines[k]; k++) printf("  %s\n", s->lines[k]);
    }
}

void manual_command(const Command *c)
{
    printf("usage: mpmlab %s %s\n%s\n", c->name, c->usage, c->about);
    if (c->options->name) printf("\n");
    options_help(c->options, stdout);
}

void manual_version(void)
{
    printf("mpmlab %s\n%s\n%s\n", FACT_VERSION, FACT_COMPILER, FACT_FLAGS);
    printf("sources %s (runs), %s (studies)\ndimensions", FACT_SOURCES, FACT_STUDIES);
    for (const Engine *const *e = engines; *e; e++) printf(" %d", (*e)->dim);
#ifdef _OPENMP
    printf("\nOpenMP %d\n", _OPENMP);
#else
    printf("\nOpenMP none\n");
#endif
}

/* Text for troff: nothing in it is a request or an escape. */
static void troff(const char *text)
{
    if (*text == '.' || *text == '\'') fputs("\\&", stdout);
    for (; *text; text++) {
        if (*text == '\\')
            fputs("\\e", stdout);
        else if (*text == '-')
            fputs("\\-", stdout);
        else
            putchar(*text);
    }
}

static void troff_options(const Option *o)
{
    for (; o->name; o++) {
        printf(".TP\n.B \\-\\-");
        troff(o->name);
        if (o->takes) printf(" \\fI%s\\fP", o->takes);
        putchar('\n');
        troff(o->help);
        putchar('\n');
    }
}

static void troff_command(const Command *c)
{
    printf(".SS mpmlab %s ", c->name);
    troff(c->usage);
    putchar('\n');
    troff(c->about);
    putchar('\n');
    troff_options(c->options);
}

void manual_page(const Command *const commands[], int n)
{
    printf(".TH MPMLAB 1 \"\" \"mpmlab ");
    troff(FACT_VERSION);
    printf("\"\n.SH NAME\nmpmlab \\- particles and grids compared\n"
           ".SH SYNOPSIS\n.B mpmlab\n.I COMMAND\n\\&...\n.SH DESCRIPTION\n");
    troff(about);
    printf("\n.SH COMMANDS\n");
    for (int k = 0; k < n; k++) troff_command(commands[k]);
    printf(".SH OPTIONS\n");
    troff_options(own);
    for (const struct Section *s = sections; s < sections + SECTIONS; s++) {
        printf(".SH \"%s\"\n.nf\n", s->title);
        for (int k = 0; s->lines[k]; k++) {
            troff(s->lines[k]);
            putchar('\n');
        }
        printf(".fi\n");
    }
}

/* Shell text that makes the plain words that a command takes. */
static const char *words_of(const Command *c)
{
    if (strstr(c->usage, "PROBLEM")) return "$(_mpmlab_names problems)";
    if (strstr(c->usage, "NAME|all")) return "all $(_mpmlab_names studies)";
    if (strstr(c->usage, "methods|")) return "methods problems studies integrators";
    return strncmp(c->usage, "NAME", 4) == 0 ? "$(_mpmlab_names)" : "";
}

static void option_words(const Option *o)
{
    for (; o->name; o++) printf("--%s ", o->name);
}

void manual_completion(const Command *const commands[], int n)
{
    printf("# Completion of mpmlab's words for bash; made by mpmlab --completion.\n"
           "_mpmlab_names() { mpmlab list \"$@\" 2>/dev/null | cut -f 2; }\n"
           "_mpmlab() {\n"
           "    local words='' word=${COMP_WORDS[COMP_CWORD]}\n"
           "    case ${COMP_WORDS[COMP_CWORD - 1]} in\n"
           "    --method) words=$(_mpmlab_names methods) ;;\n"
           "    --integrator) words=$(_mpmlab_names integrators) ;;\n"
           "    --csv | --history | --particles | --nodes | --samples | --errors | --patches | "
           "--vtk | --probe | "
           "--out | --name) return ;;\n"
           "    *) case ${COMP_WORDS[1]} in\n");
    for (int k = 0; k < n; k++) {
        printf("        %s) words=\"", commands[k]->name);
        option_words(commands[k]->options);
        printf("--help %s\" ;;\n", words_of(commands[k]));
    }
    printf("        *) words='");
    for (int k = 0; k < n; k++) printf("%s ", commands[k]->name);
    option_words(own);
    printf("' ;;\n        esac ;;\n    esac\n"
           "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n}\n"
           "complete -o default -F _mpmlab mpmlab\n");
}
