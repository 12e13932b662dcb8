/* main_3d.c: the tests of three dimensions: those of the core, scenes and tetrahedra. */
#include "tests/check.h"

extern const TestCase contract_tests[];
extern const TestCase twin_tests[];
extern const TestCase shapes_tests[];
extern const TestCase material_tests[];
extern const TestCase exact_tests[];
extern const TestCase invariants_tests[];
extern const TestCase hard_tests[];
extern const TestCase on_nodes_tests[];
extern const TestCase order_tests[];
extern const TestCase dynamics_tests[];
extern const TestCase rules_tests[];
extern const TestCase status_tests[];
extern const TestCase methods_tests[];
extern const TestCase remedies_tests[];
extern const TestCase measures_tests[];
extern const TestCase mass_tests[];
extern const TestCase ledger_tests[];
extern const TestCase shell_tests[];
extern const TestCase tetrahedra_tests[];

int main(void)
{
    const TestSuite suites[] = {
        {"contract", contract_tests},
        {"twin", twin_tests},
        {"shapes", shapes_tests},
        {"material", material_tests},
        {"exact", exact_tests},
        {"invariants", invariants_tests},
        {"order", order_tests},
        {"dynamics", dynamics_tests},
        {"rules", rules_tests},
        {"status", status_tests},
        {"methods", methods_tests},
        {"remedies", remedies_tests},
        {"measures", measures_tests},
        {"hard cases", hard_tests},
        {"mass", mass_tests},
        {"ledger", ledger_tests},
        {"tents on nodes", on_nodes_tests},
        {"shell", shell_tests},
        {"tetrahedra", tetrahedra_tests},
        {NULL, NULL},
    };
    return check_run(suites);
}
