/* statements.c: see statements.h. */
#include "statements.h"

#include <stddef.h>
#include <string.h>

#define STATEMENT(place, text, claims, why) {PAPER, place, text, claims, why},
#define OWN(claims)                         {PAPER, "", "", claims, ""},

const Statement statements[] = {
#define PAPER "W07"
#include "studies/w07/statements.def"
#undef PAPER
#define PAPER "W11"
#include "studies/w11/statements.def"
#undef PAPER
    {NULL, NULL, NULL, NULL, NULL}};

static bool names(const char *ids, const char *id)
{
    const size_t n = strlen(id);
    for (const char *at = ids; (at = strstr(at, id)); at += n)
        if ((at == ids || at[-1] == ' ') && (at[n] == ' ' || !at[n])) return true;
    return false;
}

const Statement *statement_of_claim(const char *id)
{
    for (const Statement *s = statements; s->paper; s++)
        if (names(s->claims, id)) return s;
    return NULL;
}

bool statement_is_published(const Statement *s)
{
    return *s->text != '\0';
}
