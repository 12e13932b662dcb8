#!/usr/bin/env bash
# repeat.sh FOLDER: two clean builds in folders of their own make byte-equal tables, timings apart; and so do
# runs by 1 to 4 threads. Prints the counts; status 1 if anything differs. Minutes.
set -u
mkdir -p "$1"
work=$(mktemp -d "$(realpath "$1")/repeat.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
differ=0
# comparable CSV: without its timing columns, if it has them (they come last). Tables of measured times keep
# errors and work, not what times decide: who is cheapest, and so all of a reach.
comparable() {
    if [[ $1 == *.reach.csv ]]; then
        head -n 1 "$1"
    elif [[ $1 == *.points.csv ]]; then
        cut -d, -f 1-8,11,14,16 "$1"
    elif head -n 1 "$1" | grep -q ',cpu_s,wall_s,ns_per_particle_step,wall_run_s$'; then
        sed 's/\(,[^,]*\)\{4\}$//' "$1"
    else
        cat "$1"
    fi
}
for k in 1 2; do
    make -s -j "$(nproc)" BUILD="$work/build$k" all || exit 1
    "$work/build$k/mpmlab" study all --quick --jobs $k --out "$work/$k" || exit 1
done
tables=0
for file in "$work"/1/quick/*.csv; do
    tables=$((tables + 1))
    cmp -s <(comparable "$file") <(comparable "${file/$work\/1/$work\/2}") && continue
    differ=$((differ + 1))
    echo "differs: $(basename "$file")"
done
names() { (cd "$1" && find . -name '*.csv' | sort); }
cmp -s <(names "$work/1") <(names "$work/2") || { differ=$((differ + 1)); echo "not the same tables"; }
echo "two clean builds: $tables tables, $differ differ"

# run THREADS PROBLEM METHOD: row without timings, and the particles' checksum
run() {
    local particles=$work/$2.$3.$1.csv
    OMP_WAIT_POLICY=passive "$program" run "$2" --method "$3" --threads "$1" --set steps=40 \
        --particles "$particles" 2>/dev/null | tail -n 1 | cut -d, -f 1-17,21-28
    [ ! -e "$particles" ] || cksum <"$particles"
    rm -f "$particles"
}
pair() { # PROBLEM METHOD: a line each of what was run and of what differs
    local one
    "$program" run "$1" --method "$2" --set steps=1 >/dev/null 2>&1 || return 0
    one=$(run 1 "$1" "$2")
    for threads in 2 3 4; do
        [ "$one" = "$(run $threads "$1" "$2")" ] || echo "differs by $threads threads: $1 $2"
    done
    echo "pair: $1 $2"
}
export program=$work/build1/mpmlab work
export -f run pair
for problem in $("$program" list problems | cut -f 2); do
    "$program" list methods | cut -f 2 | sed "s/^/$problem /"
done | xargs -P "$(nproc)" -L 1 bash -c 'pair "$@"' bash >"$work/pairs"
grep '^differs' "$work/pairs" && differ=$((differ + 1))
echo "1 to 4 threads: $(grep -c '^pair' "$work/pairs") pairs of problem and method"
[ $differ -eq 0 ] && [ $tables -gt 0 ] && grep -q '^pair' "$work/pairs"
