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
find "$folder/logs" -type f -size +0 -delete # what was found is checked again
# check NAME PROGRAM ARGUMENTS...: skipped if clean/NAME says that it exited with 0 and without findings since the
# program was linked.
check() {
    [ "$folder/clean/$1" -nt "$2" ] && return 0
    rm -f "$folder/logs/$1".*
    touch "$folder/clean/$1.began"
    valgrind -q --leak-check=full --show-leak-kinds=definite,indirect,possible --error-exitcode=9 \
        --log-file="$folder/logs/$1.%p" "${@:2}" && mv "$folder/clean/$1.began" "$folder/clean/$1"
}
unit() { # PROGRAM SUITE: in a process and a folder of its own
    mkdir -p "$folder/tests/run/$1.$2"
    (cd "$folder/tests/run/$1.$2" && ONLY="$2: " check "$1.$2" "$folder/tests/$1" >>log)
}
run() { # PROBLEM METHOD: in a process of its own, to its very end
    local status table
    for table in --history --nodes; do # a scene without time steps refuses a history
        check "$1.$2" "$folder/mpmlab" run "$1" --method "$2" --cells 8 --set steps=3 --set allow_unstable=1 \
            $table "$folder/$1.$2.t.csv" --particles "$folder/$1.$2.p.csv" >/dev/null 2>&1
        status=$?
        [ $status -eq 2 ] || break
    done
    [ $status -ne 2 ] || echo "$1 $2" >>"$folder/refused"
    [ $status -ne 9 ]
}
export folder
export -f check unit run
each() { xargs -P "$(nproc)" -L 1 bash -c '"$@"' bash "$1"; } # FUNCTION, arguments by line
suites() { # PROGRAM: itself and a suite, a line each
    sed -nE "s/^[a-z_0-9]*\/?test_([a-z_0-9]+):(.*) $1( .*)?\$/$1 \1/p" "$(dirname "$0")/../tests.def"
}
failed=0
units=(core_2d core_3d core_1d wls tools scenes fem) # longest first
# Optimized, with SSE2 vectors, no threads and no FMA, since valgrind emulates each FMA by a slow call.
make -s -j "$(nproc)" BUILD="$folder" ARCH= OMP=-fopenmp-simd WARN=-w \
    OPT='-O3 -ffp-contract=off -fno-math-errno -fno-trapping-math' all "${units[@]/#/$folder/tests/}" || exit 1
# First the runs of the quick studies, without valgrind (the pairs below check such runs); then, under valgrind, what
# turns their rows into tables, verdicts, figures and page.
"$folder/mpmlab" study all --quick --jobs "$(nproc)" --out "$folder/out" || failed=1
check quick "$folder/mpmlab" study all --quick --out "$folder/out" || failed=1
: >"$folder/refused"
for problem in $("$folder/mpmlab" list problems | cut -f 2); do
    "$folder/mpmlab" list methods | cut -f 2 | sed "s/^/$problem /"
done | each run || failed=1
for program in "${units[@]}"; do suites "$program"; done | each unit || failed=1
found=$(find "$folder/logs" -type f -size +0 | wc -l)
echo "valgrind: $(find "$folder/logs" -type f | wc -l) processes, $found with errors or leaks; $(wc -l <"$folder/refused") pairs refused"
find "$folder/logs" -type f -size +0 -exec head -n 12 {} \; | head -n 40
[ "$failed" -eq 0 ] && [ "$found" -eq 0 ]
