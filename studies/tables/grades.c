/* grades.c: see grades.h. */
#include "grades.h"

#include <string.h>

const char *const grade_mark_names[MARKS] = {"ok", "weak", "lost"};

FILE *grades_write(const Results *results)
{
    return results_write(results, "grades", "case,method,grade,note");
}

FILE *grades_write_remedies(const Results *results)
{
    return results_write(results, "remedies", "case,method,remedy,before,after,note");
}

void grade_remedy_add(FILE *f, const char *hard_case, const char *method, const char *remedy,
                      Mark before, Mark after, const char *note)
{
    results_print(f, "%s,%s,%s,%s,%s,%s\n", hard_case, method, remedy, grade_mark_names[before],
                  grade_mark_names[after], note);
}

void grade_add(FILE *f, const char *hard_case, const char *method, Mark grade, const char *note,
               ...)
{
    char text[256];
    PHRASE_INTO(text, note);
    results_print(f, "%s,%s,%s,", hard_case, method, grade_mark_names[grade]);
    const char *nan = strstr(text, "nan"); /* printf may write -nan */
    const bool lost = nan && (nan == text || strchr(" -", nan[-1]));
    table_put_cell(f, lost ? "a run was lost" : text);
    putc('\n', f);
}

Mark grade_mark_of(double value, double ok, double weak)
{
    return value <= ok ? MARK_OK : value <= weak ? MARK_WEAK : MARK_LOST;
}
