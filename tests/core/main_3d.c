/* main_3d.c: the tests of three dimensions: those of the core, scenes and tetrahedra. */
#include "tests/check.h"

extern const TestCase twin_tests[];
extern const TestCase shapes_tests[];
extern const TestCase material_tests[];
extern const TestCase exact_tests[];
extern const TestCase order_tests[];
extern const TestCase dynamics_tests[];
extern const TestCase status_tests[];
extern const TestCase methods_tests[];
extern const TestCase remedies_tests[];
extern const TestCase measures_tests[];
extern const TestCase mass_tests[];
extern const TestCase ledger_tests[];
extern const TestCase wls_cut_tests[];
extern const TestCase shell_tests[];
extern const TestCase tetrahedra_tests[];

int main(void)
{
    const TestSuite suites[] = {
        {"twin", twin_tests},
        {"shapes", shapes_tests},
        {"material", material_tests},
        {"exact", exact_tests},
        {"order", order_tests},
        {"dynamics", dynamics_tests},
        {"status", status_tests},
        {"methods", methods_tests},
        {"remedies", remedies_tests},
        {"measures", measures_tests},
        {"mass", mass_tests},
        {"ledger", ledger_tests},
        {"WLS: cut surfaces", wls_cut_tests},
        {"shell", shell_tests},
        {"tetrahedra", tetrahedra_tests},
        {NULL, NULL},
    };
    return check_run(suites);
}
