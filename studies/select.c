/* select.c: see select.h. */
#include "select.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/run/engine.h"
#include "phrase.h"

enum { MOST_CONDITIONS = 12, WHERE_TEXT = 512, VALUE_TEXT = 80, MOST_NAMES = 256 };
enum { SETTING = -1, NO_TABLE = -2 }; /* in place of a column */

static const char setting_mark[] = "set.";
static const char *page = "a study";

void select_begin(const char *study)
{
    page = study;
}

static bool is_setting(const char *name)
{
    for (const Engine *const *e = engines; *e; e++) {
        if (info_param_find(*(*e)->settings, name)) return true;
        for (int k = 0; k < 2; k++)
            for (const Info *const *i = k ? (*e)->methods : (*e)->problems; *i; i++)
                if (info_param_find((*i)->params, name)) return true;
    }
    return false;
}

static _Noreturn void refuse(const Table *t, const char *name)
{
    const char *names[MOST_NAMES];
    Fault fault;
    int n = 0;
    for (int k = 0; k < t->ncol && n < MOST_NAMES; k++) names[n++] = t->name[k];
    for (const Engine *const *e = engines; *e && table_column(t, "params") >= 0; e++)
        for (int k = 0; k < 2; k++)
            for (const Info *const *i = k ? (*e)->methods : (*e)->problems; *i; i++)
                for (const Param *p = (*i)->params; p && p->name && n < MOST_NAMES; p++)
                    names[n++] = p->name;
    fault_set(&fault, FAULT_MACHINE, "%s: its table has no column and no setting '%s'", page, name);
    fault_did_you_mean(&fault, "", name, names, n);
    fprintf(stderr, "mpmlab: %s\n", fault.text);
    exit(FAULT_MACHINE);
}

/* The column of that name; SETTING or NO_TABLE. */
static int find(const Table *t, const char *name)
{
    const int column = table_column(t, name);
    const bool marked = strncmp(name, setting_mark, strlen(setting_mark)) == 0;
    if (column >= 0) return column;
    if (t->ncol == 0) return NO_TABLE;
    if (table_column(t, "params") < 0 || !is_setting(marked ? strchr(name, '.') + 1 : name))
        refuse(t, name);
    return SETTING;
}

/* The default of a setting that every run has, if it is one in all dimensions. */
static const Param *usual_of(const char *name)
{
    const Param *usual = info_param_find(*engines[0]->settings, name);
    for (const Engine *const *e = engines; *e && usual; e++)
        if (fabs(info_param_find(*(*e)->settings, name)->value - usual->value) > 0) usual = NULL;
    return usual;
}

/* The setting as the row spells it, or its default; "" if the run has none of this name. */
static const char *setting_text(const Table *t, int row, const char *name, char out[VALUE_TEXT])
{
    if (strncmp(name, setting_mark, strlen(setting_mark)) == 0) name = strchr(name, '.') + 1;
    const Param *usual = usual_of(name);
    const size_t n = strlen(name);
    out[0] = '\0';
    if (usual) info_param_print(usual, usual->value, out);
    for (const char *at = table_text(t, row, "params"); *at;
         at += strcspn(at, ";"), at += *at == ';')
        if (strncmp(at, name, n) == 0 && at[n] == '=')
            snprintf(out, VALUE_TEXT, "%.*s", (int)strcspn(at + n + 1, ";"), at + n + 1);
    return out;
}

static const char *value_text(const Table *t, int row, int column, const char *name,
                              char out[VALUE_TEXT])
{
    if (column == NO_TABLE) return "";
    return column == SETTING ? setting_text(t, row, name, out) : t->cell[row * t->ncol + column];
}

const char *select_text(const Table *t, int row, const char *column)
{
    const int k = find(t, column);
    if (k == SETTING) refuse(t, column);
    return k < 0 ? "" : t->cell[row * t->ncol + k];
}

double select_number(const Table *t, int row, const char *name)
{
    char text[VALUE_TEXT];
    double x;
    return info_number_parse(value_text(t, row, find(t, name), name, text), &x) ? NAN : x;
}

bool select_is(const Table *t, int row, const char *column, const char *text)
{
    return strcmp(select_text(t, row, column), text) == 0;
}

bool select_is_lost(const Table *t, int row)
{
    if (table_column(t, "status") < 0) return false;
    return !select_is(t, row, "status", "ok") && !select_is(t, row, "status", "energy_growth");
}

double select_kept(const Table *t, int row, const char *name)
{
    return select_is_lost(t, row) ? NAN : select_number(t, row, name);
}

/* ---- Conditions */

typedef struct Conditions {
    char text[WHERE_TEXT]; /* cut up */
    int n, column[MOST_CONDITIONS];
    const char *name[MOST_CONDITIONS], *value[MOST_CONDITIONS];
} Conditions;

static void read_conditions(Conditions *c, const Table *t, const char *where, va_list args)
{
    const int length = vsnprintf(c->text, WHERE_TEXT, where, args);
    char *rest = c->text;
    c->n = 0;
    for (char *word; (word = strtok_r(rest, " ", &rest));) {
        char *equals = strchr(word, '=');
        if (!equals || c->n == MOST_CONDITIONS || length >= WHERE_TEXT) refuse(t, word);
        *equals = '\0';
        c->name[c->n] = word;
        c->value[c->n] = equals + 1;
        c->column[c->n++] = find(t, word);
    }
}

/* The conditions of a function whose last named argument is `where`. */
#define READ_CONDITIONS(c, t, where)                                                               \
    do {                                                                                           \
        va_list args;                                                                              \
        va_start(args, where);                                                                     \
        read_conditions(c, t, where, args);                                                        \
        va_end(args);                                                                              \
    } while (0)

static bool same_value(const char *a, const char *b)
{
    double x, y;
    if (info_number_parse(a, &x) == 0 && info_number_parse(b, &y) == 0) return !(x < y || x > y);
    return strcmp(a, b) == 0;
}

static bool meets(const Conditions *c, const Table *t, int row)
{
    char text[VALUE_TEXT];
    for (int k = 0; k < c->n; k++)
        if (!same_value(value_text(t, row, c->column[k], c->name[k], text), c->value[k]))
            return false;
    return true;
}

static int next(const Conditions *c, const Table *t, int row)
{
    for (row++; row < t->nrow; row++)
        if (meets(c, t, row)) return row;
    return -1;
}

bool select_meets(const Table *t, int row, const char *where, ...)
{
    Conditions c;
    READ_CONDITIONS(&c, t, where);
    return meets(&c, t, row);
}

int select_next(const Table *t, int row, const char *where, ...)
{
    Conditions c;
    if (!t) return -1;
    READ_CONDITIONS(&c, t, where);
    return next(&c, t, row);
}

static Measure first(const Table *t, const char *name, bool kept, const Conditions *c)
{
    const int row = next(c, t, -1);
    find(t, name);
    if (row < 0) return measure(NAN, 0, 1);
    const double value = kept ? select_kept(t, row, name) : select_number(t, row, name);
    return measure(value, !isnan(value), 1);
}

Measure select_value(const Table *t, const char *name, const char *where, ...)
{
    Conditions c;
    READ_CONDITIONS(&c, t, where);
    return first(t, name, true, &c);
}

Measure select_ended(const Table *t, const char *name, const char *where, ...)
{
    Conditions c;
    READ_CONDITIONS(&c, t, where);
    return first(t, name, false, &c);
}

int select_all(const Table *t, const char *name, int most, double out[], const char *where, ...)
{
    Conditions c;
    int n = 0;
    READ_CONDITIONS(&c, t, where);
    find(t, name);
    for (int row = -1; n < most && (row = next(&c, t, row)) >= 0;)
        out[n++] = select_kept(t, row, name);
    return n;
}

static Measure extreme(const Table *t, const char *name, const Conditions *c, Measure m,
                       void (*add)(Measure *, double))
{
    for (int row = -1; (row = next(c, t, row)) >= 0;) add(&m, select_kept(t, row, name));
    return m;
}

Measure select_max(const Table *t, const char *name, int needs, const char *where, ...)
{
    Conditions c;
    READ_CONDITIONS(&c, t, where);
    return extreme(t, name, &c, measure_max_of(needs), measure_add_max);
}

Measure select_min(const Table *t, const char *name, int needs, const char *where, ...)
{
    Conditions c;
    READ_CONDITIONS(&c, t, where);
    return extreme(t, name, &c, measure_min_of(needs), measure_add_min);
}

Measure select_largest(const Table *t, const char *name, int needs)
{
    return select_max(t, name, needs, "%s", "");
}

double select_last(const Table *t, const char *name)
{
    return t->nrow > 0 ? select_number(t, t->nrow - 1, name) : NAN;
}

Measure select_count_lost(const Table *t, int needs, const char *where)
{
    Measure lost = measure_sum_of(needs);
    for (int row = -1; (row = select_next(t, row, "%s", where)) >= 0;)
        measure_add(&lost, select_is_lost(t, row));
    return lost;
}

const char *select_word(const char **rest)
{
    const char *word = *rest + strspn(*rest, " ");
    const size_t n = strcspn(word, " ");
    *rest = word + n;
    return n > 0 ? phrase("%.*s", (int)n, word) : NULL;
}

bool select_is_word(const char *words, const char *word)
{
    EACH_WORD(w, words)
        if (strcmp(w, word) == 0) return true;
    return false;
}
