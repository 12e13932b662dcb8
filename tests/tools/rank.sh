#!/usr/bin/env bash
# rank.sh PROGRAM FOLDER: runs study T-2 twice and compares what methods cost to reach each error: wherever two
# methods are more than 20 % apart in the first run, they must stand in the same order in the second. Prints
# every pair that changed places. Needs a machine with nothing else to do: CPU times of a shared core are not its
# methods'.
set -u
program=$(realpath "$1")
mkdir -p "$2"
work=$(mktemp -d "$(realpath "$2")/rank.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
for run in 1 2; do
    "$program" study t_02_work_precision --out "$work/$run" || exit 1
done
awk -F, '
    FNR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
    $at["how"] == "reached" || $at["how"] == "below" {
        place = $at["problem"] " to " $at["target"]
        if (NR == FNR) { n[place]++; method[place, n[place]] = $at["method"] }
        seconds[NR == FNR ? 1 : 2, place, $at["method"]] = $at["seconds"]
    }
    END {
        for (place in n) for (a = 1; a <= n[place]; a++) for (b = 1; b <= n[place]; b++) {
            p = method[place, a]; q = method[place, b]
            first = seconds[1, place, q] / seconds[1, place, p]
            if (first <= 1.2 || !((2, place, p) in seconds) || !((2, place, q) in seconds)) continue
            pairs++
            second = seconds[2, place, q] / seconds[2, place, p]
            if (second >= 1) continue
            changed++
            printf "FAILED: %s: %s over %s was %.2f, is %.2f\n", place, q, p, first, second
        }
        printf "rank: %d pairs more than 20 %% apart, %d changed places\n", pairs, changed
        exit changed > 0
    }' "$work"/1/t_02_work_precision.reach.csv "$work"/2/t_02_work_precision.reach.csv
