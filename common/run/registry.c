/* registry.c: the methods, problems and mesh solvers of this dimension, from their .def lists. */
#include "plan.h"

/* PROBLEM and SOLVER lines carry a 1 or 0 for each dimension: KEEP_1 keeps its text, KEEP_0 drops
 * it. */
#define KEEP_0(...)
#define KEEP_1(...)         __VA_ARGS__
#define KEEP(flag)          KEEP_##flag
#define IF(flag)            KEEP(flag)
#define PROBLEM(n, a, b, c) IF(IN_THIS_DIM(a, b, c))(ONE(problem_##n))
#define SOLVER(n, a, b, c)  IF(IN_THIS_DIM(a, b, c))(ONE(solver_##n))
#define METHOD(n)           ONE(method_##n)

#define ONE(symbol) extern const Problem symbol;
#include "problems/problems.def"
#undef ONE
#define ONE(symbol) extern const Solver symbol;
#include "fem_ref/solvers.def"
#undef ONE
#define ONE(symbol) extern const Method symbol;
#include "methods/methods.def"
#undef ONE

#define ONE(symbol) &symbol,
const Problem *const problems[] = {
#include "problems/problems.def"
    0};
const Method *const methods[] = {
#include "methods/methods.def"
    0};
const Solver *const solvers[] = {
#include "fem_ref/solvers.def"
    0};
#undef ONE

#define ONE(symbol) &symbol.info,
const Info *const problem_infos[] = {
#include "problems/problems.def"
    0};
const Info *const method_infos[] = {
#include "methods/methods.def"
#include "fem_ref/solvers.def"
    0};
