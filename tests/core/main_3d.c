/* main_3d.c: 3D has no scenes yet, but compiles; the suites that bring scenes of their own. */
#include "tests/check.h"

extern const TestCase twin_tests[];
extern const TestCase shapes_tests[];
extern const TestCase material_tests[];
extern const TestCase exact_tests[];
extern const TestCase remedies_tests[];
extern const TestCase mass_tests[];

int main(void)
{
    const TestSuite suites[] = {
        {"twin", twin_tests},   {"shapes", shapes_tests},     {"material", material_tests},
        {"exact", exact_tests}, {"remedies", remedies_tests}, {"mass", mass_tests},
        {NULL, NULL},
    };
    return check_run(suites);
}
