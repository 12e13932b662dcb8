#!/usr/bin/env bash
# sweep.sh PROGRAM FOLDER: sweeps of legitimate options end with a table, orders and a figure, whatever the runs
# did: lost, exactly right, refused in part. Writes below FOLDER only. Prints what failed, then "N passed,
# N failed"; status 1 if any did.
set -u
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$0")/checks.sh"
program=$(realpath "$1")
mkdir -p "$2"
work=$(mktemp -d "$(realpath "$2")/sweep.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
cd "$work" || exit 1

# swept NAME LINES ARGUMENT...: the sweep ends well with so many lines on standard output, and leaves a figure.
swept() {
    local name=$1 want=$2
    shift 2
    run sweep "$@" --out s
    ok "$name: status $status, $(head -n 3 err)" test "$status" -eq 0
    ok "$name: $(lines out) lines" test "$(lines out)" -eq "$want"
    if command -v gnuplot >/dev/null; then figure "$name" "$@"; fi
}
# figure NAME PROBLEM ... [--name NAME]: it was drawn just now.
figure() {
    local file=s/sweep_$2
    [ "${*: -2:1}" = --name ] && file=s/sweep_${*: -1}
    ok "$1: figure" test -s "$file.svg" -a -s "$file.png" -a "$file.svg" -nt "$file.csv"
}
# order SERIES CONDITION: what out says of that curve; o is the order, r the reason
order() { awk -F, -v k="$1" 'NR > 1 && $1 == k { o = $7; r = $9; found = '"$2"' } END { exit !found }' out; }

# Tables, orders, more of the same, other ones
swept "a sweep" 5 squeeze --method gimp,ge_gimp --cells '10:80:*2' --set field=linear,quadratic --ppc 1.3 --jobs 2
ok "a row per combination" test "$(lines s/sweep_squeeze.csv)" -eq 17
ok "orders" awk -F, '$2 == "ge_gimp; quadratic" && $7 > 1.9 && $7 < 2.1 { n++ } END { exit n != 1 }' out
swept "a longer one" 5 squeeze --method gimp,ge_gimp --cells 10,20,40,80,160 --set field=linear,quadratic --ppc 1.3
ok "it runs the rest" test "$(lines s/sweep_squeeze.rows)" -eq 20
ok "without a word" test ! -s err
cp s/sweep_squeeze.csv long.csv
run sweep squeeze --cells 10,20 --ppc '1:2:+.5' --out s --list
ok "list" test "$(lines out)" -eq 6
ok "a list leaves the table" cmp -s long.csv s/sweep_squeeze.csv
bash out >/dev/null
swept "collect" 3 squeeze --cells 10,20 --ppc '1:2:+.5' --collect
ok "its rows" test "$(lines s/sweep_squeeze.csv)" -eq 7
ok "the sweep before it is kept" cmp -s long.csv s/sweep_squeeze-1.csv
ok "with all its files" test -s s/sweep_squeeze-1.json -a -s s/sweep_squeeze-1.orders.csv -a -s s/sweep_squeeze-1.curves.csv
ok "and that is said in one line" test "$(grep -c -- '--name' err)" -eq 1 -a "$(lines err)" -eq 1
cp s/sweep_squeeze.csv short.csv
swept "--name" 2 squeeze --cells 10,20,40 --name own
ok "--name: rows" test "$(lines s/sweep_own.csv)" -eq 4 -a ! -s err
ok "--name leaves the others" cmp -s short.csv s/sweep_squeeze.csv
for name in '' a/b ../a a.b 'a b' "$(printf 'x%.0s' {1..41})"; do
    refused "--name '$name'" 2 "--name: got" sweep squeeze --cells 10 --name "$name"
done
swept "numbers only" 2 bar --cells 8,16 --ppc 2 --t-end .001

# Errors of exactly 0, lost runs, empty cells
swept "errors of exactly 0" 2 block --cells 8,16
ok "say so" order 0 'o == "" && r ~ /exactly 0/'
swept "every run lost" 2 ring --cells 8,12 --cfl 10
ok "say so" order 0 'o == "" && $6 == 2 && r ~ /every run is lost/'
ok "stay in the curves" test "$(lines s/sweep_ring.curves.csv)" -eq 3
swept "one curve lost" 3 ring --cells 8,12 --cfl .3,10 --method wls2
ok "is said of that curve" order 1 'o == "" && $6 == 2'
ok "the other has an order" order 0 'o > 0 && r == "\"\""'
if command -v gnuplot >/dev/null; then
    ok "a lost curve is in the key" grep -q 'cfl 10: every run is lost' s/sweep_ring.svg
    ok "each of its runs is marked, and the mark explained" test "$(grep -c "xlink:href='#gpPt1'" s/sweep_ring.svg)" -eq 3
fi
swept "A from 0" 2 sine_bar --cells 8 --set 'A=0:.04:+.01'
ok "is a sweep of errors" order 0 '$4 == "error_linf"'
ok "its first row has no error" test -z "$(sed -n 2p s/sweep_sine_bar.csv | cut -d, -f12)"
ok "without a slope" order 0 'o == "" && r ~ /above 0/'
swept "an axis with signs" 2 block --cells 8 --set dim=1 --set 'drift_x=-.2:.2:+.1' --set gravity=1 --name signs
ok "has no slope" order 0 'o == "" && r ~ /above 0/'

swept "one run" 2 ring --cells 08 --set steps=2 --name one
swept "numbers with a 0 in front" 2 ring --cells 08,016 --set A=010e-3 --name zeros

swept "some errors of 0" 2 block --cells 8 --set dim=1 --set drift_x=0,.1,.2 --t-end .05 --name some
if command -v gnuplot >/dev/null; then ok "are marked and explained" grep -q '>exactly 0<' s/sweep_some.svg; fi

# What is really run
swept "particles that do not fit" 2 squeeze --cells 7 --ppc .5,.9,1.2,2.2 --name ppc
drawn() {
    paste -d, <(cut -d, -f6 s/sweep_ppc.csv) <(cut -d, -f2 s/sweep_ppc.curves.csv) |
        awk -F, 'NR > 1 { n++; if (($1 - $2) ^ 2 > 1e-16) exit 1 } END { exit n != 4 }'
}
ok "are drawn where they are" drawn
ok "which is not where they were asked for" test "$(cut -d, -f2 s/sweep_ppc.curves.csv | sed -n 2p)" != .5
swept "curves of particles that do not fit" 3 squeeze --cells 7,10 --ppc 1.2,2 --name curves
ok "tell what was asked for and what fitted" order 0 '$2 ~ /^ppc 1.2 .really 1.143 to 1.2.$/'
ok "and no more where all fitted" order 1 '$2 == "ppc 2"'
swept "an end that counts steps" 2 free_block --cells 8,16,32 --set dim=1
ok "gives no order" order 0 'o == "" && r ~ /different times/'
ok "over energies" grep -q energy_drift out
swept "a common end" 2 free_block --cells 8,16,32 --set dim=1 --t-end .01 --name end
ok "gives an order, or energies of both signs" order 0 'o != "" || r ~ /sign/'
swept "the same number of steps" 2 ring --cells 8,12,16 --set steps=4 --name steps
ok "is no common end" order 0 'o == "" && r ~ /different times/'
swept "more steps than t_end has" 2 ring --cells 8,12 --set steps=1000 --name more
ok "say so" grep -q '2 of 2 runs reached t_end' err
swept "no numbers" 2 ring --cells 8 --method gimp,mpm --name methods
ok "no order" order 0 '$3 == "case" && o == ""'

# Pairs that are refused
swept "a refused pair" 2 ring --cells 8,12 --method gimp,ge_gimp --integrator usf --name pair
ok "is left out" test "$(lines s/sweep_pair.csv)" -eq 3 -a "$(cut -d, -f2 s/sweep_pair.csv | sort -u | grep -c ge_gimp)" -eq 0
ok "and said in one line" test "$(lines err)" -eq 1 -a "$(grep -c 'left out 2 of 4 runs.*unstable with ge_gimp' err)" -eq 1
swept "a setting of one method" 2 ring --cells 8 --method gimp,wls2 --set stress=linear,c0 --name setting
ok "leaves out the other" test "$(lines s/sweep_setting.csv)" -eq 3 -a "$(lines err)" -eq 1
swept "a lattice beside a fitted layout" 3 ring --cells 8 --method gimp,wls2 --ppc 4,5 --name layouts
ok "five per cell are for one of them" test "$(lines s/sweep_layouts.csv)" -eq 4
swept "numbers that a lattice does not take" 2 ring --cells 8 --ppc 1:9:+1 --set steps=5 --name squares
ok "are left out" test "$(lines s/sweep_squares.csv)" -eq 4 -a "$(lines err)" -eq 6
refused "all pairs refused" 2 "unstable with ge_gimp" sweep ring --cells 8,12 --method ge_gimp --integrator usf
refused "a value that nothing takes" 2 "liner" sweep squeeze --cells 10,20 --set field=linear,liner
refused "fem projects nothing" 2 "projects nothing" sweep patch --cells 4,8 --method fem

# Where it goes is looked at first
mkdir -p taken/sweep_ring.curves.csv
refused "a folder in a table's place" 1 "sweep_ring.curves.csv" sweep ring --cells 8 --out taken
ok "no run was made" test ! -s taken/sweep_ring.rows
ok "nothing half written is left" test -z "$(find . -name '*.tmp')"
verdict sweep
