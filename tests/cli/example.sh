#!/usr/bin/env bash
# example.sh FOLDER: README's worked examples, done as a reader would in a copy of the tree below FOLDER:
# two methods (one with a number), a problem, a study with two claims and a plot, a test: one file and one line each (the
# study: two files and one line), built, run, and found in lists and in studies. Then what new-method refuses. Prints what
# failed, then "N passed, N failed"; status 1 if any did.
set -u
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$0")/checks.sh"
# Make's variables (CC=..., OMP=...) are passed on to the copy, its jobserver is not; run by hand this expects a build with
# the default settings. To save time the copy gets the objects of this build. Their .d files name them by the build folder,
# so it has the same name there; if that is absolute, which would be this very folder, all is compiled anew in build/.
case $1 in /*) built= ;; *) built=${1%/*} ;; esac
build=${built:-build}
case ${MAKEFLAGS-} in *' -- '*) MAKEFLAGS=" -- ${MAKEFLAGS##* -- }" ;; *) unset MAKEFLAGS ;; esac
root=$(realpath "$(dirname "$0")/../..")
mkdir -p "$1"
tree=$(realpath "$1")/tree
unchanged() { # TEXT ARGUMENT...: one line with the text in it, status 2, nothing written
    local text=$1 before
    shift
    before=$(find methods -type f -exec cksum {} + | cksum)
    refused "new-method $*" 2 "$text" new-method "$@"
    ok "new-method $*: writes nothing" test "$before" = "$(find methods -type f -exec cksum {} + | cksum)"
}
compile() { # [TARGET]
    make -s -j"$(nproc)" BUILD="$build" "${1:-all}" >log 2>&1 ||
        { head -n 20 log >&2; false; }
}
invariants() { # DIM: of every method in the list
    compile "$build/tests/core_$1d" || return 1
    ONLY=invariants OMP_WAIT_POLICY=passive "$build/tests/core_$1d" >log || { grep -A 3 'had failures' log >&2; false; }
}
failed_range() { ! "$program" run free_bar --method blend --set alpha=2 >out 2>err && grep -q 'alpha' err; }
# code LINE: README's code that begins with it.
code() { awk -v first="$1" '$0 == first { on = 1 } /^```/ { on = 0 } on' "$root/README.md"; }
readme() { code "$(head -n 1 "$1")" | cmp -s - "$1"; } # FILE: that code is all of it
drifts() { ONLY='drift: ' OMP_WAIT_POLICY=passive "$build/tests/core_2d" >log || { grep -A 3 'had failures' log >&2; false; }; }

rm -rf "$tree"
mkdir -p "$tree"
cp -a "$root"/{Makefile,common,methods,problems,fem_ref,studies,plots,tests} "$tree/"
mkdir -p "$tree/$build"
[ ! -e "$built/mpmlab" ] || cp -a "$built"/{d[1-3],common,studies,facts.h} "$tree/$build/" # with their times, which make compares
cd "$tree" || exit 1
program=$build/mpmlab
ok "the copy compiles" compile
for file in "$root"/tests/{problems/example_problem.c,studies/example_study.c} \
    "$root"/tests/studies/example_plot.gp "$root"/methods/flip_pic.c; do
    ok "README shows $file as it is" readme "$file"
done
ok "new-method" "$program" new-method rpic
ok "names both files" grep -qx 'METHOD(rpic)' methods/methods.def
cp methods/rpic.c template.c
"$program" new-method second >out && rm methods/second.c && sed -i '/second/d' methods/methods.def
cp tests/methods/example_method.c methods/rpic.c
ok "new-method with a number" "$program" new-method blend
sed 's/flip_pic/blend/g' "$root/methods/flip_pic.c" >methods/blend.c
cp tests/problems/example_problem.c problems/free_bar.c
echo 'PROBLEM(free_bar, 1, 0, 0)' >>problems/problems.def
cp tests/studies/example_study.c studies/own/t_90_free_bar.c
cp tests/studies/example_plot.gp plots/own/t_90_free_bar.gp
echo 'STUDY(own, t_90_free_bar, "T-90", "free bar: convergence of GIMP and GE-GIMP")' >>studies/studies.def
ok "the examples compile" compile
ok "is listed" grep -q "^method.rpic.1,2" <("$program" list methods)
ok "is described" grep -q 'Jiang' <("$program" describe rpic)
ok "runs in 1D" grep -q ',ok,' <("$program" run bar --method rpic)
ok "runs in 2D" grep -q ',ok,' <("$program" run ring --method rpic --cells 16)
ok "stands in the ring's study" "$program" study w11_06_ring --quick --method rpic
ok "with its rows" grep -q ',rpic,' build/out/quick/w11_06_ring.csv
error() { "$program" run free_bar "$@" | tail -n 1 | cut -d, -f12; } # error_linf
ok "the method with a number: its number acts" test "$(error --method blend --set alpha=1)" = "$(error --method gimp)"
ok "and differs for another" test "$(error --method blend --set alpha=.5)" != "$(error --method gimp)"
ok "the number has a range" failed_range
ok "the problem is described" grep -q 'first mode' <("$program" describe free_bar)
ok "and runs with every integrator" grep -q ',ok,' <("$program" run free_bar --integrator usl)
ok "the study runs" "$program" study t_90_free_bar
ok "draws" test -s build/out/t_90_free_bar.svg
ok "the page of claims is written" "$program" claims --out build/out >claims.log
ok "its first claim passes" grep -q '^T-90.order,.*,PASS,' build/out/claims.csv
ok "and its second" grep -q '^T-90.ratio,.*,PASS,' build/out/claims.csv
code '/* test_drift.c: a block without stress that drifts keeps its velocity. */' >tests/core/test_drift.c
echo 'core/test_drift: core_2d' >>tests/tests.def
ok "every invariant holds for the methods in 2D" invariants 2
ok "README's test passes, for these methods too" drifts
unchanged "no method has" rpic
unchanged "no method has" gimp
unchanged "no method has" fem
unchanged "takes at most 31" 2nd
unchanged "takes at most 31" Upper
unchanged "takes at most 31" ../evil
unchanged "takes at most 31" 'a b'
unchanged "takes at most 31" ''
unchanged "takes at most 31" a23456789012345678901234567890123
unchanged "one name only" a b
cp template.c methods/rpic.c # what new-method writes compiles and runs as it is: GIMP
ok "the template compiles" compile
"$program" run ring --cells 8 --method gimp | tail -n 1 | cut -d, -f12 >gimp
"$program" run ring --cells 8 --method rpic | tail -n 1 | cut -d, -f12 >rpic
ok "the template is GIMP" cmp -s gimp rpic
verdict
