/* fuzz_run.c: whatever is typed behind `run`: refused in one line, or a spec whose command makes
 * the same run again. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "studies/runs/engines.h"
#include "studies/runs/run_args.h"
#include "fuzz.h"

const char *fuzz_refusal(int code, const Fault *fault)
{
    if (code != FAULT_USAGE || fault->code != FAULT_USAGE) return "status is not 2";
    if (!fault->text[0]) return "nothing is said";
    for (const char *c = fault->text; *c; c++)
        if ((unsigned char)*c < ' ') return "more than one line is said";
    return NULL;
}

/* Is the resolved spec's command its key: does it resolve to itself? */
static const char *same_again(const RunSpec *spec)
{
    char once[SPEC_TEXT], twice[SPEC_TEXT];
    RunSpec again;
    const Engine *engine;
    Fault fault = {0};
    spec_command(spec, once);
    if (run_args_resolve(once, &again, &engine, &fault)) return "a run's own command is refused";
    spec_command(&again, twice);
    return strcmp(once, twice) ? "a run's command makes another run" : NULL;
}

static const char *resolved(RunSpec *spec)
{
    Fault fault = {0};
    const Engine *engine = engine_for(spec, &fault);
    int code = engine ? engine->resolve(spec, &fault) : FAULT_USAGE;
    return code ? fuzz_refusal(code, &fault) : same_again(spec);
}

const char *fuzz_run(const unsigned char *data, size_t n)
{
    enum { MOST = 64 };
    char *text = fuzz_text(data, n), *argv[MOST + 2] = {"run"};
    RunArgs args;
    Fault fault = {0};
    int argc = 1 + fuzz_split(text, '\n', argv + 1, MOST);
    int code = run_args_read(argc, argv, &args, &fault);
    const char *wrong = code ? fuzz_refusal(code, &fault) : resolved(&args.spec);
    free(text);
    return wrong;
}

/* The first byte chooses a problem and a method, lines behind it are settings. */
const char *fuzz_set(const unsigned char *data, size_t n)
{
    enum { MOST = 40 };
    const char *problems[64], *methods[64], *wrong = NULL;
    char *text = fuzz_text(data, n), *lines[MOST];
    RunSpec spec = {0};
    Fault fault = {0};
    const int byte = (unsigned char)text[0], np = engine_problem_names(problems, 64);
    snprintf(spec.problem, sizeof spec.problem, "%s", problems[byte % np]);
    snprintf(spec.method, sizeof spec.method, "%s",
             methods[byte / np % engine_method_names(methods, 64)]);
    int count = n ? fuzz_split(text + 1, '\n', lines, MOST) : 0;
    for (int k = 0; k < count && !wrong; k++) {
        int code = spec_set(&spec, lines[k], &fault);
        if (code) wrong = fuzz_refusal(code, &fault);
    }
    if (!wrong) wrong = resolved(&spec);
    free(text);
    return wrong;
}

static int columns_of(const char *line)
{
    int n = 1;
    for (; *line; line++) n += *line == ',';
    return n;
}

/* Small enough to run a few thousand times a minute. */
static int is_small(const RunSpec *spec)
{
    const char *particles = spec_get(spec, "particles");
    return spec->cells <= 8 && spec->ppc <= 16 && (!particles || strlen(particles) < 3);
}

/* Two steps of any small run that is not refused: it ends with a whole row, whatever its numbers.
 */
const char *fuzz_case(const unsigned char *data, size_t n)
{
    char *text = fuzz_text(data, n), line[ROW_TEXT];
    RunSpec spec;
    const Engine *engine;
    Fault fault = {0};
    Row row = row_empty();
    int code = run_args_resolve(text, &spec, &engine, &fault);
    free(text);
    if (code) return fuzz_refusal(code, &fault);
    if (!is_small(&spec) || spec_set(&spec, "steps=2", NULL)) return NULL;
    spec.threads = 1;
    if (engine->run(&spec, &row, &fault)) return fault.text[0] ? NULL : "a fault without a text";
    if (row_print(&row, line) >= ROW_TEXT) return "a row too long";
    if (strlen(row.params) + 1 >= sizeof row.params) return "a row without all its parameters";
    return columns_of(line) == row_columns() ? NULL : "a row with other columns";
}
