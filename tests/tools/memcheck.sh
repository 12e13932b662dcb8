#!/usr/bin/env bash
# memcheck.sh FOLDER: valgrind over the unit tests, every method on every problem and the quick studies, in a build
# for any processor. Interrupted, it goes on where it was.
# Prints the counts; status 1 if there is an error or a leak. Hours.
set -u
if ! command -v valgrind >/dev/null; then
    echo "SKIPPED valgrind"
    exit 0
fi
mkdir -p "$1"
folder=$(realpath "$1")
mkdir -p "$folder/logs" "$folder/clean"
check() { # NAME PROGRAM ARGUMENTS...: once for each build, if it ended well and nothing was found (clean/NAME)
    [ "$folder/clean/$1" -nt "$2" ] && return 0
    rm -f "$folder/logs/$1".*
    valgrind -q --leak-check=full --show-leak-kinds=definite,indirect,possible --error-exitcode=9 \
        --log-file="$folder/logs/$1.%p" "${@:2}" && touch "$folder/clean/$1"
}
unit() { # PROGRAM SUITE: in a process and a folder of its own
    mkdir -p "$folder/tests/run/$1.$2"
    (cd "$folder/tests/run/$1.$2" && ONLY="$2: " check "$1.$2" "$folder/tests/$1" >>log)
}
run() { # PROBLEM METHOD: in a process of its own, to its very end
    local table=--history
    case $1 in squeeze | patch) table=--nodes ;; esac # they have no time steps
    check "$1.$2" "$folder/mpmlab" run "$1" --method "$2" --cells 8 --set steps=3 --set allow_unstable=1 \
        $table "$folder/$1.$2.t.csv" --particles "$folder/$1.$2.p.csv" >/dev/null 2>&1
    [ $? -ne 9 ] # it may refuse
}
export folder
export -f check unit run
each() { xargs -P "$(nproc)" -L 1 bash -c '"$@"' bash "$1"; } # FUNCTION, arguments by line
suites() { # PROGRAM: itself and a suite, a line each
    sed -nE "s/^[a-z_0-9]*\/?test_([a-z_0-9]+):(.*) $1( .*)?\$/$1 \1/p" "$(dirname "$0")/../tests.def"
}
failed=0
units=(core_2d core_3d core_1d wls tools scenes fem) # longest first
# Optimized and in vectors of two, but without FMA, which valgrind takes a call for.
make -s -j "$(nproc)" BUILD="$folder" ARCH= OMP=-fopenmp-simd WARN=-w \
    OPT='-O3 -ffp-contract=off -fno-math-errno -fno-trapping-math' all "${units[@]/#/$folder/tests/}" || exit 1
# Cases of studies first, which the pairs below stand for; then what makes tables, verdicts, figures and page of them.
"$folder/mpmlab" study all --quick --jobs "$(nproc)" --out "$folder/out" || failed=1
check quick "$folder/mpmlab" study all --quick --out "$folder/out" || failed=1
for problem in $("$folder/mpmlab" list problems | cut -f 2); do
    "$folder/mpmlab" list methods | cut -f 2 | sed "s/^/$problem /"
done | each run || failed=1
for program in "${units[@]}"; do suites "$program"; done | each unit || failed=1
found=$(find "$folder/logs" -type f -size +0 | wc -l)
echo "valgrind: $(find "$folder/logs" -type f | wc -l) processes, $found with errors or leaks"
find "$folder/logs" -type f -size +0 -exec head -n 12 {} \; | head -n 40
[ "$failed" -eq 0 ] && [ "$found" -eq 0 ]
