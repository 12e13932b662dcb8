/* fuzz_main.c: what libFuzzer calls; FUZZ is the property that is looked at. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    const char *wrong = FUZZ(data, n);
    if (!wrong) return 0;
    fprintf(stderr, "found: %s\n", wrong);
    abort();
}
