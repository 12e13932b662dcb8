/* fuzz.h: properties of everything that reads input, for any bytes at all. The fuzzer (make fuzz)
 * looks for bytes that break one; the unit tests replay those it has found (tests/fuzz/found). */
#ifndef MPMLAB_FUZZ_H
#define MPMLAB_FUZZ_H

#include <stddef.h>
#include "common/base/fault.h"

/* Each returns NULL, or what is wrong with how n bytes of input were taken. */
const char *fuzz_run(const unsigned char *data, size_t n);  /* arguments of `run`, one per line */
const char *fuzz_set(const unsigned char *data, size_t n);  /* a problem, then settings */
const char *fuzz_case(const unsigned char *data, size_t n); /* a run text, run for two steps */
const char *fuzz_journal(const unsigned char *data, size_t n); /* a journal, or records of one */
const char *fuzz_table(const unsigned char *data, size_t n);   /* a CSV table */
const char *fuzz_append(const unsigned char *data, size_t n);  /* a table that a row is added to */
const char *fuzz_sweep(const unsigned char *data, size_t n);   /* a problem, then lists */

/* Is this how something is refused: status 2 and one line? NULL, or what is not. */
const char *fuzz_refusal(int code, const Fault *fault);

/* The bytes as text ended by a 0; the caller frees it. */
char *fuzz_text(const unsigned char *data, size_t n);

/* The path of a scratch file that holds the bytes; valid until the next call. */
const char *fuzz_file(const unsigned char *data, size_t n);

/* All of a file (ended by a 0, the caller frees it) and its length. */
char *fuzz_read(const char *path, size_t *n);

/* Splits text in place at its separators into at most max words. How many. */
int fuzz_split(char *text, char separator, char *words[], int max);

#endif
