#!/usr/bin/env bash
# coverage.sh FOLDER: which lines and which public functions the tests execute (gcov). Lists the functions they do
# not; a page of all lines is made if lcov is there. Study workers end without a word, so runs are made by `run`.
set -u
if ! command -v gcov >/dev/null; then
    echo "SKIPPED gcov"
    exit 0
fi
mkdir -p "$1"
folder=$(realpath "$1")
find "$folder" -name '*.gcda' -delete
make -s -j "$(nproc)" BUILD="$1" ARCH= OMP= OPT='-O1 -fno-inline -Wno-maybe-uninitialized' SAN=--coverage test >"$folder/test.log" 2>&1 ||
    { tail -n 5 "$folder/test.log"; exit 1; }
program=$folder/mpmlab
for problem in $("$program" list problems | cut -f 2); do
    for method in $("$program" list methods | cut -f 2); do
        for integrator in cd uvf musl usl usf; do
            "$program" run "$problem" --method "$method" --integrator $integrator --cells 8 --ppc 4 --set steps=3 \
                --set allow_unstable=1 --nodes "$folder/n.csv" --particles "$folder/p.csv" --history "$folder/h.csv" >/dev/null 2>&1
        done
    done
done
"$program" study all --quick --out "$folder/out" >/dev/null 2>&1 # its checks use what pages share
find "$folder" -name '*.gcno' ! -path '*/tests/*' | while read -r notes; do
    gcov -t -b "$notes" 2>/dev/null # dimensions share sources: summed up below
done >"$folder/all.gcov"
awk -F: '$1 ~ /#####|=====|[0-9]/ && $2 ~ /[0-9]/ && $2 + 0 > 0 {
        key = file ":" $2; seen[key] = 1; if ($1 ~ /[0-9]/) run[key] = 1 }
    $2 ~ /^ *0$/ && $3 == "Source" { file = $4 }
    END { for (k in seen) { n++; r += k in run } printf "lines: %d of %d executed, %.1f %%\n", r, n, 100 * r / n }' \
    "$folder/all.gcov"
grep -oE "^function [A-Za-z_0-9]+ called [0-9]+" "$folder/all.gcov" | awk '$4 > 0 { print $2 }' | sort -u >"$folder/called"
find "$folder" -name '*.o' ! -path '*/tests/*' ! -name 'engine.o' -exec nm --defined-only {} + |
    awk '$2 == "T" { print $3 }' | sort -u >"$folder/public"
find "$folder"/d[0-9] -path '*common/engine.o' -exec nm --defined-only {} + | awk '$2 == "T" { print $3 }' >>"$folder/public"
echo "public functions: $(sort -u "$folder/public" | wc -l), not executed: $(comm -23 "$folder/public" "$folder/called" | wc -l)"
comm -23 "$folder/public" "$folder/called" | sed 's/^/  /'
if command -v lcov >/dev/null; then
    lcov -q --capture --directory "$folder" --output-file "$folder/lcov.info" 2>/dev/null &&
        genhtml -q --output-directory "$folder/page" "$folder/lcov.info" 2>/dev/null && echo "$folder/page/index.html"
fi
