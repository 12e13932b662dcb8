/* main_dim.c: the tests of one dimension, every suite that lives in it. */
#include "check.h"

extern const TestCase contract_tests[];

int main(void)
{
    const TestSuite suites[] = {{"contract", contract_tests}, {NULL, NULL}};
    return check_run(suites);
}
