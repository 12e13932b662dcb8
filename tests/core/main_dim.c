/* main_dim.c: the tests of one dimension, every suite that lives in it. */
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
extern const TestCase spots_tests[];
extern const TestCase rules_tests[];
extern const TestCase status_tests[];
extern const TestCase methods_tests[];
extern const TestCase remedies_tests[];
extern const TestCase wls_hand_tests[];
extern const TestCase measures_tests[];
extern const TestCase mass_tests[];
extern const TestCase ledger_tests[];
extern const TestCase wls_symbols_tests[];
extern const TestCase wls_cut_tests[];
extern const TestCase column_tests[];

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
        {"spots", spots_tests},
        {"rules", rules_tests},
        {"status", status_tests},
        {"methods", methods_tests},
        {"remedies", remedies_tests},
        {"WLS by hand", wls_hand_tests},
        {"measures", measures_tests},
        {"WLS: symbols of its transfers", wls_symbols_tests},
        {"WLS: cut surfaces", wls_cut_tests},
        {"column", column_tests},
        {"hard cases", hard_tests},
        {"mass", mass_tests},
        {"ledger", ledger_tests},
        {"tents on nodes", on_nodes_tests},
        {NULL, NULL},
    };
    return check_run(suites);
}
