#!/usr/bin/env bash
# reach_table.sh [--check README.md] [OUT]: the table "what an error costs" of README.md, from OUT/t_02_work_precision.reach.csv
# (OUT: build/out): on each problem FEM and the cheapest particle method that reach 1e-2, 1e-3, 1e-4. With --check: does
# README's table say the same? Its problems and errors must be those of the file; the method it calls cheapest must cost
# at most SLACK times what the cheapest of the file does, and its ratio to FEM must be the file's within that factor.
# A file of another processor than README names says nothing about it: SKIPPED.
set -eu
SLACK=3 # CPU times of milliseconds differ between runs of the study, most of all beside other programs
readme=
[ "${1:-}" != --check ] || { readme=$2 && shift 2; }
file=${1:-build/out}/t_02_work_precision.reach.csv
[ -s "$file" ] || { echo "SKIPPED: no $file (make figures writes it)" && exit 0; }
processor=$(sed -n 's/^ "processor": "\(.*\)",$/\1/p' "${file%.reach.csv}.json")
[ -z "$readme" ] || grep -qF "one core of ${processor:-?}" "$readme" || { echo "SKIPPED: $file was measured on ${processor:-an unknown processor}" && exit 0; }
table=$(
    awk -F, '
    function ratio_of(x) { return sprintf(x < 99.5 ? "%.2g" : "%.0f", x) }
    function show(x) { return x == "" ? "-" : sprintf("%.3g", x) }
    NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
    $at["target"] == 0.0003 || ($at["how"] != "reached" && $at["how"] != "below") { next }
    {
        key = $at["problem"] " | " $at["target"]
        if (!(key in seen)) { seen[key] = 1; order[++n] = key }
        ms = 1000 * $at["seconds"]
        if ($at["how"] == "reached" && $at["method"] == "fem") fem[key] = ms
        else if ($at["method"] == "ge_wls") { ge[key] = ms; most[key] = $at["how"] == "below" ? "< " : "" }
        if ($at["how"] != "reached" || $at["method"] == "fem" || (key in best && ms >= best[key])) next
        best[key] = ms
        name[key] = sprintf("`%s` (%s, %s, PPC %.3g)", $at["method"], $at["integrator"], $at["layout"], $at["ppc"])
    }
    END {
        for (k = 1; k <= n; k++) {
            key = order[k]
            if (!(key in best)) continue
            ratio = key in fem ? ratio_of(best[key] / fem[key]) : "-"
            other = key in fem && key in ge ? most[key] ratio_of(ge[key] / fem[key]) : "-"
            printf "| %s | %s | %s | %s | %s | %s |\n", key, show(fem[key]), name[key], show(best[key]), ratio, other
        }
    }' "$file"
)
if [ -z "$readme" ]; then
    printf '| problem | error | FEM [ms] | cheapest particle method | [ms] | particle / FEM | GE-WLS / FEM |\n|---|---|---|---|---|---|---|\n%s\n' "$table"
    exit
fi
rows=$(sed -n '/^| problem | error | FEM/,/^$/p' "$readme" | tail -n +3 | grep '^|') || { echo "$readme: no table of what an error costs" && exit 1; }
cut_keys() { cut -d'|' -f2,3 <<<"$1"; }
diff <(cut_keys "$table") <(cut_keys "$rows") || { echo "$readme: other problems and errors than $file" && exit 1; }
paste -d'#' <(echo "$table") <(echo "$rows") | awk -F'#' -v slack="$SLACK" -v readme="$readme" -v file="$file" '
    NR == FNR && FILENAME != "-" { split($0, c, ","); cost[c[1] " " c[2] " " c[3]] = 1000 * c[5]; next }
    {
        split($1, now, " *[|] *"); split($2, said, " *[|] *")
        method = said[5]; gsub(/`| .*/, "", method)
        ms = cost[now[2] " " now[3] " " method]
        if (!(ms > 0 && ms <= slack * now[6])) { printf "%s: %s to %s: %s is not the cheapest of %s (%s)\n", readme, now[2], now[3], method, file, now[5]; bad = 1 }
        sub(/^< /, "", now[8]); sub(/^< /, "", said[8]) # which PPC is the cheapest, and so "<", changes between runs
        for (k = 7; k <= 8; k++)
            if ((now[k] == "-") != (said[k] == "-") || now[k] + 0 > slack * said[k] || said[k] + 0 > slack * now[k]) {
                printf "%s: %s to %s: ratio %s, in %s %s\n", readme, now[2], now[3], said[k], file, now[k]; bad = 1 }
    }
    END { exit bad }' "$file" -
echo "reach_table: $(wc -l <<<"$rows") rows of $readme agree with $file"
