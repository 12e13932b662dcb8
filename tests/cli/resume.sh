#!/usr/bin/env bash
# resume.sh PROGRAM FOLDER: runs that are killed go on from their checkpoint to the bits of the whole run: the row
# without its timings, history and particles. Torn and foreign checkpoints. Writes below FOLDER only.
set -u
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$0")/checks.sh"
program=$(realpath "$1")
mkdir -p "$2"
work=$(mktemp -d "$(realpath "$2")/resume.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
cd "$work" || exit 1
export OMP_WAIT_POLICY=passive

# outcome NAME ARGUMENT...: runs it; leaves NAME.row, NAME.history, NAME.particles, and the microseconds it took.
outcome() {
    local name=$1 began=${EPOCHREALTIME/[.,]/}
    shift
    "$program" run "$@" --quiet --history "$name.history" --particles "$name.particles" >out 2>err
    status=$?
    took=$((${EPOCHREALTIME/[.,]/} - began))
    timeless out >"$name.row"
}
alike() { cmp -s "$1.row" "$2.row" && cmp -s "$1.history" "$2.history" && cmp -s "$1.particles" "$2.particles"; }

# killed ARGUMENT...: waits for the second checkpoint, then for half the time of the uninterrupted run, then kills by
# SIGKILL: sums are no longer zero by then, so that a checkpoint without one of them is noticed.
killed() {
    rm -f state state.1 part.history
    "$program" run "$@" --quiet --history part.history --checkpoint state --every-s 1e-9 >/dev/null 2>err &
    while [ ! -e state.1 ] && kill -0 $!; do :; done
    sleep "$(printf '%d.%06d' $((took / 2000000)) $((took / 2 % 1000000)))"
    kill -KILL $!
    wait $!
} 2>/dev/null
# part N FILE: makes FILE anew, of the first N bytes of `newest`. (Writing into it could change two files: after a kill
# state and state.1 may be one.)
part() { head -c "$1" newest >torn && mv torn "$2"; }

kills=0
while read -r words; do
    # shellcheck disable=SC2086
    outcome whole $words
    ok "$words: $(cat err)" test $status -eq 0
    # shellcheck disable=SC2086
    killed $words
    ok "killed $words: a checkpoint" test -s state
    [ -e part.history ] || kills=$((kills + 1))
    # shellcheck disable=SC2086
    outcome resumed $words --resume state --threads 2
    ok "resumed $words: $(cat err)" alike whole resumed
done <<'END'
bar --t-end .01
bar --method mpm --integrator musl --t-end .01
sine_bar --method wls2
ring --cells 12 --method wls2 --then gimp --at .004
ring --cells 12 --method wls --then ge_gimp --at .018
ring --cells 12 --method wls2 --then ge_gimp --at 1e-6
ring --cells 16 --method fem
ring --cells 12 --method fem --set traction=1
hanging_bar --cells 8 --method ge_gimp
disk_impact --cells 12 --method ge_wls --set steps=80
vortex --cells 10 --method apic
axis_mms --cells 12 --method fmpm
cantilever --cells 6 --method wls2 --set steps=80
shell --cells 6 --method wls
shell --cells 6 --method fem
free_block --cells 8 --set dim=3 --method bspline
free_block --cells 16 --method gimp --integrator usf
sliding_block --cells 8 --set mu=0.1 --method gimp+apic
two_disks --method wls2 --t-end .8
collinear_bars --method cpdi2 --cells 50
burst_ring --cells 12 --method wls2 --then gimp --at rupture
burst_ring --cells 12 --method wls2 --then gimp --at rupture --set strength=.001
END
ok "most were killed before their end: $kills of 22" test $kills -gt 11

# The newest is torn, missing, another run's, another program's or none
words="ring --cells 12 --method gimp"
# shellcheck disable=SC2086
outcome whole $words
# shellcheck disable=SC2086
killed $words
cp state newest
cp state.1 second
part 3000 state
run run $words --resume state --history resumed.history --particles resumed.particles
timeless out >resumed.row
ok "torn: the one before" alike whole resumed
ok "torn: says so: $(cat err)" grep -qx 'mpmlab: state is no whole checkpoint; resumed from state.1' err
rm state
# shellcheck disable=SC2086
outcome resumed $words --resume state
ok "missing: the one before" alike whole resumed
part 3000 state
part 2000 state.1
refused "both torn" 2 "no whole checkpoint, and state.1 is no whole checkpoint" run $words --resume state
cp newest state
refused "another run's" 2 "a checkpoint of another run: run ring" run ring --cells 13 --resume state
refused "another run's method" 2 "a checkpoint of another run" run ring --cells 12 --method mpm --resume state
sed '2s/^......../00000000/' newest >body
bytes=$(($(stat -c %s body) - 9))
head -c $bytes body >state
gzip -c state | tail -c 8 | od -An -N4 -tx4 --endian=little | tr -d ' ' >sum && cat sum >>state # CRC-32
refused "another program's" 2 "another build" run $words --resume state
byte=$((RANDOM % bytes))
{ head -c $byte newest; tail -c +$((byte + 1)) newest | head -c 1 | tr '\000-\377' '\001-\377\000'; tail -c +$((byte + 2)) newest; } >state
cp second state.1
# shellcheck disable=SC2086
outcome resumed $words --resume state
ok "byte $byte changed: the one before" alike whole resumed
"$program" run $words --checkpoint bare --every-s 1e-9 >/dev/null 2>&1
refused "a checkpoint without history" 2 "a run with no --history" run $words --resume bare --history resumed.history

# The points that a history follows are those of the checkpoint.
rm -f state state.1
"$program" run $words --history whole.history --probe .7,.7 --checkpoint state --every-s 1e-9 >/dev/null 2>&1
for probes in "" "--probe .2,.9" "--probe .7,.7 --probe .2,.9"; do
    refused "history with ${probes:-no probe}" 2 "a run with other points of --probe" \
        run $words --history resumed.history $probes --resume state.1
done
run run $words --history resumed.history --probe .7,.7 --resume state.1
ok "the same probe: $(cat err)" cmp -s whole.history resumed.history
run run $words --resume state.1
ok "no history, no probe: $(cat err)" test $status -eq 0
mkfifo pipe.1
refused "a FILE.1 that is a pipe" 2 "where FILE.1 is free or a checkpoint" run $words --checkpoint pipe
ln -f state state.1 # as a kill between two renamings leaves them
run run $words --resume state --checkpoint state
ok "two names of one state: $(cat err)" test $status -eq 0
refused "the state is overwritten by an output" 2 "another path than the state of --resume" \
    run $words --resume state --history ./state.1
echo mine >bare.1
refused "a FILE.1 that is no checkpoint" 2 "where FILE.1 is free or a checkpoint" run $words --checkpoint bare
ok "is left alone" grep -qx mine bare.1
ln -s real link
run run $words --checkpoint link --every-s 1e-9
ok "a checkpoint through a link: $(cat err)" test -L link -a -s real -a -s real.1 -a ! -e link.1
run run $words --resume link
ok "resumes: $(cat err)" test $status -eq 0

# Told to stop, a run leaves a checkpoint, and snapshots go on
words="bar --t-end 1"
"$program" run $words --vtk shots --every 10000 >out 2>err
(cd shots && sha256sum -- *) >whole.sums
rm -rf shots state state.1
"$program" run $words --vtk shots --every 10000 --history part.history --checkpoint state >out 2>err &
while [ ! -e shots/particles_010000.vtp ] && kill -0 $!; do :; done
sleep .01
kill -TERM $!
wait $!
status=$?
ok "told to stop: $(cat err)" test $status -eq 130 -a -s state
# shellcheck disable=SC2086
outcome whole $words
ok "a snapshot of the instant at which it stopped" test "$(find shots -name 'particles_*' ! -name '*0000.vtp' | wc -l)" -eq 1
for other in "--vtk shots" "--vtk shots --every 9999" "--vtk shots --every .001s"; do
    refused "resumed with $other" 2 "a run with another --every" run $words $other --resume state --history h
done
refused "resumed without --vtk" 2 "a run with --vtk" run $words --resume state --history h
mkdir none
touch shots/particles_040001.vtp shots/cells_000007.vtp shots/particles_000001.vtp # of other runs
refused "resumed into another folder" 2 "--vtk: got 'none', takes the folder" run $words --vtk none --every 10000 \
    --resume state --history h
"$program" run $words --vtk shots --every 10000 --resume state --checkpoint state --history resumed.history \
    --particles resumed.particles >out 2>err
timeless out >resumed.row
ok "resumed: $(cat err)" alike whole resumed
ok "other files are left alone" rm shots/particles_040001.vtp shots/cells_000007.vtp shots/particles_000001.vtp
ok "its snapshots" bash -c 'cd shots && sha256sum -- * | cmp -s - ../whole.sums'
# A kill between naming a file and renaming it leaves state.PID.tmp or state.1.PID.tmp, which no run reads.
ok "nothing else half written is left" test -z "$(find . -name '*.tmp' ! -name 'state.*')"
verdict
