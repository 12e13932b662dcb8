#!/usr/bin/env bash
# mutants.sh FOLDER [PATTERN]: are the unit tests worth their time? Applies the faults of mutants.list
# one at a time to a copy of the tree below FOLDER and runs the core's tests, which must fail. Only
# faults whose description matches PATTERN, from number FROM on. A fault that no longer applies or compiles is an error.
set -u
mkdir -p "$1"
tree=$(realpath "$1")/tree
pattern=${2:-.}
list=$(realpath "$(dirname "$0")/mutants.list")
root=$(dirname "$(dirname "$list")")
caught=0 total=0 wrong=0
say() { printf '%s\n' "$*"; }

build() { # DIM: its tests, without caring for speed
    make -s -C "$tree" -j"${JOBS:-2}" OPT='-O1 -march=native -Wno-maybe-uninitialized' "build/tests/core_$1d" >"$tree.log" 2>&1
}
green() { # DIM
    (cd "$tree/build/tests" && OMP_WAIT_POLICY=passive timeout "${LIMIT:-120}" "./core_$1d" >"$tree.out" 2>&1)
}

mkdir -p "$tree"
for room in common methods problems fem_ref studies tests; do
    mkdir -p "$tree/$room"
    for file in "$root/$room"/*; do # only what changed, so that a second run builds little
        [ -f "$file" ] && ! cmp -s "$file" "$tree/$room/${file##*/}" && cp "$file" "$tree/$room/"
    done
done
cp "$root/Makefile" "$tree/"
for dim in 1 2; do
    build $dim || { cat "$tree.log"; say "mutants: the tree does not compile"; exit 1; }
    green $dim || { tail -n 30 "$tree.out"; say "mutants: the tests fail without any fault"; exit 1; }
done

while IFS='|' read -r file dim rest; do
    case $file in '' | '#'*) continue ;; esac
    change=${rest%|*} what=${rest##*|}
    grep -q -- "$pattern" <<<"$what" || continue
    total=$((total + 1))
    [ $total -lt "${FROM:-1}" ] && continue
    cp "$tree/$file" "$tree.keep"
    sed -i "$change" "$tree/$file"
    if cmp -s "$tree.keep" "$tree/$file"; then
        wrong=$((wrong + 1))
        say "no longer applies: $file: $what"
        continue
    fi
    verdict=missed
    for d in $dim $((3 - dim)); do
        build "$d" || { verdict='does not compile'; wrong=$((wrong + 1)); break; }
        green "$d" || { verdict=caught; caught=$((caught + 1)); break; }
    done
    say "$(printf '%2d %-16s %s: %s' $total "$verdict" "$file" "$what")"
    cp "$tree.keep" "$tree/$file"
done <"$list"
total=$((total - ${FROM:-1} + 1))
say "mutants: $caught of $total caught"
[ $caught -eq $total ] && [ $wrong -eq 0 ]
