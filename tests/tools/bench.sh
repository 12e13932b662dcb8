#!/usr/bin/env bash
# bench.sh: the speed of the step loop, from one run of this machine: ns per particle-step (best and median
# CPU time of interleaved rounds), instructions (callgrind, AVX2 build), ratios to the textbook code, two bare loops
# (their steps alone) and the machine's own bounds, empty space, threads. Writes OUT/t_03_speed.csv and prints it as a table;
# where the instructions of GIMP go (OUT/t_03_instructions.csv); growth with the number of particles
# (OUT/t_03_growth.csv); and what is slower than in the bench that was accepted last
# on this processor (tests/data/bench; ACCEPT=1 puts this one there).
#   BUILD=build OUT=build/out ROUNDS=7 tests/tools/bench.sh
set -u
BUILD=${BUILD:-build} OUT=${OUT:-$BUILD/out} ROUNDS=${ROUNDS:-7}
lab=$BUILD/mpmlab bench=$BUILD/tests/bench avx2=$BUILD/avx2/mpmlab
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir -p "$OUT" || exit 1

mapfile -t methods < <("$lab" list methods | awk -F'\t' '$3 ~ /2/ && $2 != "fem" { print $2 }')
# NAME|RUN; the numbers of steps make each run last about half a second
cases=()
for m in "${methods[@]}"; do cases+=("$m|free_block --method $m --set steps=40"); done
cases+=("mpm-cd|free_block --method mpm --integrator cd --set steps=40"
    "gimp-1e4|free_block --cells 50 --set steps=250" "gimp-1e6|free_block --cells 512 --set steps=20"
    "gimp-run|free_block --set steps=400" "gimp-2-threads|free_block --threads 2 --set steps=40"
    "ring-run|ring --method gimp --cells 64" # with error norms and the work of body forces
    "axis_mms-run|axis_mms --method gimp --cells 48" "plate_vibration-run|plate_vibration --method gimp --cells 96"
    "two_disks-run|two_disks --method gimp --cells 64"
    "gimp-box-15|free_block --set box=15 --set steps=40"
    "gimp-40|sine_bar --method gimp --cells 20 --ppc 2 --cfl .1 --t-end 1" # what a step costs beside its particles
    "gimp-1d|free_block --cells 16384 --set dim=1 --set steps=40"
    "fem-elements|ring --method fem --cells 128 --set steps=100"
    "fem-3d|shell --method fem --cells 16 --set steps=60")
for m in gimp ge_gimp apic wls wls2 ge_wls; do # in 3D: 28^3 cells of 8 particles; GIMP once with 2e6 particles
    cases+=("$m-3d|free_block --method $m --cells 28 --set dim=3 --set steps=4")
done
cases+=("gimp-3d-2e6|free_block --cells 63 --set dim=3 --set steps=2")

pick() { awk -F, -v name="$1" 'NR == 1 { for (k = 1; k <= NF; k++) if ($k == name) at = k } NR == 2 { print $at }'; }
for ((round = 0; round < ROUNDS; round++)); do
    for c in "${cases[@]}"; do
        name=${c%%|*}
        # shellcheck disable=SC2086
        "$lab" run ${c#*|} --quiet >"$work/row.csv" 2>"$work/error" || { cat "$work/error" >&2; exit 1; }
        cp "$work/row.csv" "$work/$name.row"
        awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k }
            NR == 2 { n = $at["elements"] ? $at["elements"] : $at["particles"]
                      n *= $at["steps"] / 1e9
                      print $at["cpu_s"] / n, $at["wall_s"] / n, $at["wall_run_s"] / n }' \
            "$work/row.csv" >>"$work/$name.ns"
    done
    # two processes of one thread at once: what two threads could reach at best here
    for k in 1 2; do
        "$lab" run free_block --set steps=40 --quiet | pick wall_s >"$work/process.$k" &
    done
    wait
    sort -g "$work/process.1" "$work/process.2" | awk 'END { ns = $1 / (65536 * 40) * 1e9; print ns, ns, ns }' >>"$work/two-processes.ns"
    "$bench" twin 128 2 | awk '{ print $2, $2, $2 }' >>"$work/twin.ns"
    for kind in mls gimp; do # as a user would write them
        "$bench" bare $kind 128 40 >"$work/bare" || { echo "bench: the bare $kind loop is wrong" >&2; exit 1; }
        awk '$1 == "bare_ns" { print $2, $2, $2 }' "$work/bare" >>"$work/bare-$kind.ns"
    done
    [ -t 2 ] && printf '\rbench: round %d of %d' $((round + 1)) "$ROUNDS" >&2
done
[ -t 2 ] && echo >&2

# Instructions of sim_step alone, per particle-step (with the step beyond the end that the ledger takes).
instructions() {
    [ -x "$avx2" ] && command -v valgrind >/dev/null || return
    # shellcheck disable=SC2086
    valgrind --tool=callgrind --toggle-collect=sim_step --callgrind-out-file=/dev/null \
        "$avx2" run $1 --quiet >"$work/count.csv" 2>"$work/count.log"
    awk '/Collected/ { print $NF }' "$work/count.log" |
        awk -v n="$(pick particles <"$work/count.csv")" -v s="$(pick steps <"$work/count.csv")" \
            '{ printf "%.1f", $1 / (n * (s + 1)) }'
}
command -v valgrind >/dev/null || echo "SKIPPED valgrind: no instruction counts" >&2

"$bench" machine >"$work/machine"
value() { awk -v name="$1" '$1 == name { print $2 }' "$work/machine"; }
twin=$(sort -g "$work/twin.ns" | awk 'NR == 1 { print $1 }')
gimp=$(sort -g "$work/gimp.ns" | awk 'NR == 1 { print $1 }')
{
    echo "case,particles,ns_best,ns_median,wall_best,instructions_avx2,ratio_to_gimp,ratio_to_twin,integrator,whole_best"
    for c in "${cases[@]}" "twin|" "bare-mls|" "bare-gimp|" "two-processes|"; do
        name=${c%%|*} n=65536 count='' integrator=-
        if [ "${c#*|}" != "" ]; then
            n=$(pick particles <"$work/$name.row")
            integrator=$(pick integrator <"$work/$name.row")
        fi
        case "$name" in gimp-* | *-run | *-3d | fem-* | twin | bare-* | two-*) ;; *) count=$(instructions "${c#*|} --set steps=4") ;; esac
        sort -g "$work/$name.ns" | awk -v name="$name" -v n="$n" -v count="$count" -v gimp="$gimp" -v twin="$twin" \
            -v integrator="$integrator" '
            { cpu[NR] = $1; if (NR == 1 || $2 < wall) wall = $2; if (NR == 1 || $3 < whole) whole = $3 }
            END { printf "%s,%d,%.4g,%.4g,%.4g,%s,%.4g,%.4g,%s,%.4g\n", name, n, cpu[1], cpu[int((NR + 1) / 2)], wall,
                  count, cpu[1] / gimp, cpu[1] / twin, integrator, whole }'
    done
    # what the machine could do at best: about 500 flops and 350 bytes per particle-step of GIMP in 2D
    awk -v fma="$(value fma_gflops)" -v gbs="$(value copy_gbs)" -v gimp="$gimp" -v twin="$twin" 'BEGIN {
        printf "bound-flops,65536,%.4g,,,,%.4g,%.4g,-,\n", 500 / fma, 500 / fma / gimp, 500 / fma / twin
        printf "bound-bytes,65536,%.4g,,,,%.4g,%.4g,-,\n", 350 / gbs, 350 / gbs / gimp, 350 / gbs / twin }'
} >"$work/t_03_speed.csv"
mv "$work/t_03_speed.csv" "$OUT/t_03_speed.csv" || exit 1
column -s, -t "$OUT/t_03_speed.csv" 2>/dev/null || cat "$OUT/t_03_speed.csv"

awk -F, '{ wall[$1] = $5 }
    $1 ~ /-run$/ { printf "%s: whole run %g ns per particle-step, step loop %g, ratio %.3f\n", $1, $10, $5, $10 / $5 }
    END { printf "two threads: %.2f times as fast; two processes of one thread do %.2f times the work of one\n",
          wall["gimp"] / wall["gimp-2-threads"], 2 * wall["gimp"] / wall["two-processes"] }' "$OUT/t_03_speed.csv"

# Where the instructions of a step of GIMP go, by the function that they are compiled into; the ledger, which comes
# after each step, stands in the sum and not in instructions_avx2.
if [ -x "$avx2" ] && command -v callgrind_annotate >/dev/null; then
    valgrind --tool=callgrind --toggle-collect=sim_step --toggle-collect=ledger_motion --toggle-collect=ledger_strain \
        --callgrind-out-file="$work/calls" "$avx2" run free_block --set steps=39 --quiet >"$work/count.csv" 2>"$work/count.log"
    callgrind_annotate --auto=no --threshold=100 "$work/calls" |
        awk -v n="$(pick particles <"$work/count.csv")" -v steps=40 '
            function part(f) {
                if (f ~ /^(ledger|sum)_|^add_(motion|points|strain)$|stored_energy/) return "ledger"
                if (f ~ /shape|fit_slopes/) return "shapes"
                if (f ~ /^(deposit|clear|pack)_/) return "deposit"
                if (f ~ /^(gather|inspect)_/) return "gather"
                if (f ~ /^(solve|mirror|record|row)_/) return "solve"
                if (f ~ /^(material|chunk|strain)_|_payload$|_update$/) return "stress and update"
                if (f ~ /sort|^(permute|find_|cut_blocks|cell_order|touch_rows|widen)/) return "sort"
                return "rest" }
            !/%\)/ { next }
            { count = $1; gsub(",", "", count); sub(/^[^)]*\) */, ""); sub(/ \[.*/, ""); sub(/.*:/, "") }
            /PROGRAM TOTALS/ { all = count; next }
            { sum[part($0)] += count; named += count }
            END { print "part,instructions,share"
                  sum["rest"] += all - named
                  k = split("deposit,gather,shapes,solve,stress and update,sort,ledger,rest", name, ",")
                  for (i = 1; i <= k; i++) printf "%s,%.1f,%.3f\n", name[i], sum[name[i]] / (n * steps), sum[name[i]] / all
                  printf "sum,%.1f,1\n", all / (n * steps) }' >"$work/t_03_instructions.csv"
    mv "$work/t_03_instructions.csv" "$OUT/t_03_instructions.csv" || exit 1
    column -s, -t "$OUT/t_03_instructions.csv" 2>/dev/null || cat "$OUT/t_03_instructions.csv"
else
    echo "SKIPPED valgrind: no instructions by function" >&2
fi

# Slower than accepted: instructions by more than 1 %, or CPU time over the textbook code's by more than 15 %.
processor=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)
accepted=tests/data/bench/$(tr -c 'A-Za-z0-9\n' _ <<<"${processor:-unknown}").csv
if [ "${ACCEPT:-}" ]; then
    mkdir -p "${accepted%/*}" && cp "$OUT/t_03_speed.csv" "$accepted" || exit 1
elif [ -r "$accepted" ]; then
    awk -F, 'FNR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
        NR == FNR { count[$1] = $at["instructions_avx2"]; ratio[$1] = $at["ratio_to_twin"]; next }
        count[$1] && $at["instructions_avx2"] > 1.01 * count[$1] {
            printf "slower: %s, %g instructions, %g accepted\n", $1, $at["instructions_avx2"], count[$1]; n++ }
        ratio[$1] && $at["ratio_to_twin"] > 1.15 * ratio[$1] {
            printf "slower: %s, %g of the textbook code\047s time, %g accepted\n", $1, $at["ratio_to_twin"], ratio[$1]; n++ }
        END { printf "%d of %d numbers slower than accepted\n", n, 2 * (FNR - 1) }' "$accepted" "$OUT/t_03_speed.csv"
else
    echo "no bench of this processor (${processor:-unknown}) was accepted yet: ACCEPT=1 make bench keeps this one"
fi

# ns of CPU and of wall clock, the better of two runs, against the number of particles; 1 and 2 threads.
{
    echo "method,dim,threads,particles,cpu_ns,wall_ns"
    for dim in 1 2 3; do
        case $dim in 1) sizes=(512 8192 131072 2097152) ppc=2 ;; 2) sizes=(16 64 256 1024) ppc=4 ;; *) sizes=(5 16 50 80) ppc=8 ;; esac
        for m in $("$lab" list methods | awk -F'\t' -v dim=$dim '$3 ~ dim && $2 != "fem" { print $2 }'); do
            for size in "${sizes[@]}"; do
                n=$((ppc * size ** dim)) steps=$((400000 / (ppc * size ** dim) + 2))
                [ $n -gt 300000 ] && [ "$m" != gimp ] && continue # seconds each
                for threads in 1 2; do
                    for _ in first again; do
                        "$lab" run free_block --method "$m" --set dim=$dim --cells "$size" --ppc $ppc --threads $threads \
                            --set steps=$steps --quiet 2>>"$work/error" >"$work/row.csv" || continue
                        awk -F, -v m="$m" -v d=$dim -v t=$threads 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k }
                            NR == 2 { n = $at["particles"] * $at["steps"]
                                printf "%s,%d,%d,%d,%.4g,%.4g\n", m, d, t, $at["particles"], 1e9 * $at["cpu_s"] / n,
                                       1e9 * $at["wall_s"] / n }' "$work/row.csv"
                    done | sort -t, -k6,6g | head -n 1
                done
            done
            [ -t 2 ] && printf '\rbench: growth in %dD, %s    ' $dim "$m" >&2
        done
    done
} >"$work/t_03_growth.csv"
[ -t 2 ] && echo >&2
mv "$work/t_03_growth.csv" "$OUT/t_03_growth.csv" || exit 1
command -v gnuplot >/dev/null || { echo "SKIPPED gnuplot: no figure T-3" >&2; exit 0; }
for name in t_03_speed t_03_growth; do
    for fmt in svg png; do
        gnuplot -e "$("$BUILD/tests/palette") fmt='$fmt'; out='$work/figure'; dir='$OUT'; name='$name'; csv='$OUT/$name.csv'; plots='plots';
            bytes=$(value copy_gbs); flops=$(value fma_gflops)" \
            plots/own/$name.gp && [ -s "$work/figure" ] && mv "$work/figure" "$OUT/$name.$fmt" || exit 1
    done
done
