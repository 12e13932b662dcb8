#!/usr/bin/env bash
# faults.sh PROGRAM FOLDER [KILLS [long]]: breaks everything around the program: kills, full and read-only disks,
# two at once, a gnuplot that fails or hangs, closed streams, a foreign locale, little memory.
# Writes below FOLDER only. Prints what failed, then "N passed, N failed"; status 1 if any did.
set -u
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$0")/checks.sh"
program=$(realpath "$1")
kills=${3:-8}
long=${4:-}
mkdir -p "$2"
work=$(mktemp -d "$(realpath "$2")/faults.XXXXXX")
disk=$work/disk
mounted=
clean_up() {
    [ -n "$mounted" ] && umount -l "$disk"
    rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 130' INT TERM
cd "$work" || exit 1
many=w07_05_squeeze_linear # some thousand short rows
few=w07_04_squeeze

not_running() { ! grep -q '^State:[[:space:]]*[^Z[:space:]]' "/proc/$1/status" 2>/dev/null; }
keys() { cut -f1 "$1" | cut -c19-; }
doubled() { keys "$1" | sort | uniq -d | wc -l; }

"$program" study $many --out whole --jobs 2 2>err || { cat err; exit 1; }
"$program" study $few --quick --out whole 2>err || { cat err; exit 1; }
all=$(($(lines whole/$many.csv) - 1))

# SIGKILL at random times: every row that was ever whole stays as it was, none comes twice.
seconds=$( { TIMEFORMAT=%R; time "$program" study $many --out timed --jobs 2 2>/dev/null >&2; } 2>&1)
hits=0
lost=0
twice=0
differ=0
for ((tries = 0; hits < kills && tries < 5 * kills; tries++)); do
    touch killed.rows
    [ -e killed/$many.rows ] && cp killed/$many.rows killed.rows
    "$program" study $many --out killed --jobs 2 >/dev/null 2>&1 &
    sleep "$(awk -v s="$seconds" -v r=$RANDOM 'BEGIN { print 0.9 * s * r / 32768 }')"
    kill -KILL $! 2>/dev/null
    wait $! 2>/dev/null
    [ $? -eq 137 ] && hits=$((hits + 1))
    [ -e killed/$many.rows ] || continue
    lost=$((lost + $(comm -23 <(sort killed.rows) <(sort killed/$many.rows) | wc -l)))
    twice=$((twice + $(doubled killed/$many.rows)))
    [ "$(lines killed/$many.rows)" -lt "$all" ] && continue
    run study $many --out killed
    [ "$status" -eq 0 ] && same whole/$many.csv killed/$many.csv && [ "$(lines killed/$many.rows)" -eq "$all" ] ||
        differ=$((differ + 1))
    rm -rf killed killed.rows
done
run study $many --out killed
ok "after $hits kills the table is the same" same whole/$many.csv killed/$many.csv
ok "and $differ tables between" test $differ -eq 0
ok "$hits of $kills kills hit" test $hits -eq "$kills"
ok "$lost rows lost" test $lost -eq 0
ok "$twice rows doubled" test $twice -eq 0
ok "no row too many" test "$(lines killed/$many.rows)" -eq "$all"
ok "kills leave nothing half written" test -z "$(find killed -name '*.tmp*')"
echo "$hits kills by SIGKILL, $lost rows lost, $twice doubled"

# A journal torn and scribbled on in many places
mkdir torn
awk 'NR % 7 == 3 { print substr($0, 1, 50); next } NR % 11 == 5 { printf "%s", $0; next } { print }' \
    whole/$many.rows >torn/$many.rows
head -c 3000 /dev/urandom >>torn/$many.rows
run study $many --out torn
ok "a scribbled journal: $(cat err)" test "$status" -eq 0 -a ! -s err
ok "gives the same table" same whole/$many.csv torn/$many.csv

# Full disk: nothing torn is left, and with room again the study goes on.
if [ "$(id -u)" -eq 0 ] && mkdir "$disk" && mount -t tmpfs -o size=200k tmpfs "$disk" 2>/dev/null; then
    mounted=yes
    run study $many --out "$disk"
    failed_well "full disk" 1 "No space left on device"
    run study $few --quick --out "$disk"
    failed_well "full from the start" 1 "No space left on device"
    run run bar --set steps=3 --csv "$disk/t.csv" --cells 20 --history "$disk/h.csv" --particles "$disk/p.csv"
    failed_well "run on a full disk" 1 "No space left on device"
    ok "no half table" test ! -s "$disk/t.csv" -a ! -e "$disk/p.csv"
    ok "nothing half written" test -z "$(find "$disk" -name '*.tmp*')"
    mount -o remount,size=20m "$disk"
    run study $many --out "$disk"
    ok "goes on with room: $(cat err)" test "$status" -eq 0
    ok "to the same table" same whole/$many.csv "$disk/$many.csv"
    mount -o remount,ro "$disk"
    run study $many --out "$disk"
    failed_well "read-only disk" 1 "Read-only file system"
    run run squeeze --csv "$disk/new.csv"
    failed_well "run on a read-only disk" 1 "Read-only file system"
    ok "no row is printed for a table that cannot be written" test ! -s out
    run claims --out "$disk"
    failed_well "claims on a read-only disk" 1 "Read-only file system"
    umount "$disk" && mounted=
else
    echo "SKIPPED disks of their own: no right to mount"
fi
(ulimit -f 16 && exec "$program" study $many --out limited >out 2>err)
status=$?
failed_well "file size limit" 1 "limited/$many.rows: "
run study $many --out limited
ok "goes on without the limit" same whole/$many.csv limited/$many.csv
mkdir -m 555 closed
if [ "$(id -u)" -ne 0 ]; then
    run study $few --quick --out closed/x
    failed_well "a folder without permission" 1 "Permission denied"
fi

# Two at once: the same study, and different ones that share claims.csv
for _ in 1 2 3; do "$program" study $many --out shared --jobs 2 >/dev/null 2>&1 & done
"$program" study w07_11_bar_history --out shared >/dev/null 2>&1 &
"$program" study w07_03_degenerate --out shared >/dev/null 2>&1 &
wait
ok "three at once: the same table" same whole/$many.csv shared/$many.csv
ok "no row too many" test "$(lines shared/$many.rows)" -eq "$all" -a "$(doubled shared/$many.rows)" -eq 0
for figure in W07-3 W07-5 W07-11; do
    ok "claims of $figure are in the shared list" grep -q "^$figure\.[^,]*,$figure,.*,\(PASS\|DIFFERS\|FAIL\)," shared/claims.csv
done

# gnuplot: fails, draws nothing, hangs; the numbers are there all the same
mkdir -p fake
fake() {
    printf '#!/bin/sh\n%s\n' "$1" >fake/gnuplot
    chmod +x fake/gnuplot
}
with_fake() {
    PATH=$work/fake:$PATH "$program" "$@" >out 2>err
    status=$?
}
fake 'echo "line 7: undefined variable: x" >&2; exit 1'
with_fake study $few --quick --out figures
failed_well "gnuplot fails" 1 "line 7: undefined variable: x"
ok "the table is there" same whole/quick/$few.csv figures/quick/$few.csv
fake 'exit 0'
with_fake study $few --quick --out figures
failed_well "gnuplot draws nothing" 1 "gnuplot drew nothing"
fake 'kill -SEGV $$'
with_fake study $few --quick --out figures
failed_well "gnuplot crashes" 1 "gnuplot failed"
for signal in INT TERM HUP; do
    fake "sleep 300 & echo \$! >$work/pid; wait"
    rm -f pid
    PATH=$work/fake:$PATH "$program" study $few --quick --out figures >out 2>err &
    for ((k = 0; k < 500; k++)); do [ -s pid ] && break || sleep 0.02; done
    kill -$signal $!
    wait $!
    status=$?
    failed_well "SIG$signal while gnuplot hangs" 130 "interrupted"
    sleep 0.1
    ok "nothing of gnuplot is left" not_running "$(cat pid)"
done
ok "no half figure" test -z "$(find figures -name '*.tmp*' -o -name '*.svg' -o -name '*.png')"
if [ -n "$long" ]; then
    with_fake study $few --quick --out figures
    failed_well "gnuplot hangs" 1 "did not end within 120 s"
fi
if command -v gnuplot >/dev/null; then
    run study $few --quick --out figures
    ok "a good gnuplot draws it later" test "$status" -eq 0 -a -s figures/quick/$few.svg
fi

# No terminal, closed streams, signals that the parent ignored
setsid "$program" study $few --quick --out alone </dev/null >out 2>err
ok "no terminal: $(cat err)" test $? -eq 0 -a ! -s out -a ! -s err
if command -v script >/dev/null; then
    script -qec "'$program' study $many --out terminal --jobs 2" /dev/null </dev/null >out
    ok "a terminal shows progress" grep -qE "$many \[[# ]+\] [0-9]+/$all" out
    ok "and gets the same table" same whole/$many.csv terminal/$many.csv
fi
"$program" study $few --quick --out closed0 <&- >&- 2>&-
ok "all streams closed" same whole/quick/$few.csv closed0/quick/$few.csv
ok "and no message is in the journal" cmp -s <(keys whole/quick/$few.rows) <(keys closed0/quick/$few.rows)
"$program" run squeeze --csv t.csv >&- 2>err
status=$?
failed_well "standard output closed" 1 "standard output"
ok "the row is in the table" test "$(lines t.csv)" -eq 2
"$program" run squeeze --set nonsense=1 --csv t2.csv 2>&-
ok "standard error closed" test $? -eq 2 -a ! -e t2.csv
timeout 60 env --ignore-signal=CHLD "$program" study $few --quick --out ignored --jobs 2 2>err
ok "SIGCHLD ignored by the parent: $(cat err)" same whole/quick/$few.csv ignored/quick/$few.csv

# A run that is told to stop: a row, its history to the last full instant, no line in a table; the history is the
# beginning of the whole run's.
"$program" run bar --t-end 4 --set steps=200 --history whole.history >/dev/null 2>&1
for signal in INT TERM HUP; do
    "$program" run bar --t-end 4 --history stopped.history --csv stopped.csv --particles stopped.particles >out 2>err &
    sleep 0.2
    kill -$signal $!
    wait $!
    status=$?
    failed_well "SIG$signal to a run" 130 "interrupted: step "
    done=$(tail -n 1 out | cut -d, -f10)
    ok "SIG$signal: its row" test "$(tail -n 1 out | cut -d, -f17)" = interrupted -a "$(lines out)" -eq 2
    ok "SIG$signal: its history" test "$(lines stopped.history)" -eq $((done + 2)) -a "$done" -gt 0
    ok "SIG$signal: which is the whole run's" cmp -s <(head -n 150 whole.history) <(head -n 150 stopped.history)
    ok "SIG$signal: its particles" test "$(lines stopped.particles)" -eq 81
    ok "SIG$signal: no row in a table" test ! -e stopped.csv
done
"$program" run free_block --cells 700 >out 2>err &
sleep 0.1
kill -INT $!
sleep 0.02
kill -INT $!
wait $!
status=$?
failed_well "SIGINT twice" 130 "interrupted"
ok "SIGINT twice: at once" test ! -s out

# Tables of a program whose rows had fewer columns
run run bar --set steps=1 --csv older.csv
cut -d, -f1-28 older.csv >old.csv
run run bar --set steps=1 --csv old.csv
ok "an older table keeps its columns" test "$(awk -F, '{ print NF }' old.csv | tr '\n' ' ')" = "28 28 28 "
cut -d, -f1-20 older.csv >old.csv
run run bar --set steps=1 --csv old.csv
failed_well "a table of other columns" 2 "other columns"

# Decimal commas
ok "setlocale is not called" bash -c "! nm -D --undefined-only '$program' | grep -w setlocale"
if command -v localedef >/dev/null && mkdir locale && localedef -i de_DE -f UTF-8 locale/de_DE.UTF-8 2>/dev/null; then
    LOCPATH=$work/locale LC_ALL=de_DE.UTF-8 "$program" study $few --quick --out german >out 2>err
    ok "decimal commas: the same table" same whole/quick/$few.csv german/quick/$few.csv
    for ending in svg var; do
        [ -e whole/quick/$few.$ending ] || continue
        ok "decimal commas: the same .$ending" cmp -s whole/quick/$few.$ending german/quick/$few.$ending
    done
else
    echo "SKIPPED decimal commas: no locale can be made here"
fi

# Paths
for path in "two words" $'a\ttab' '-dash' '$(touch x)' 'quote"s' '*' 'ümlaut'; do
    run study $few --quick --out "$path"
    ok "--out '$path': $(cat err)" same whole/quick/$few.csv "./$path/quick/$few.csv"
    run run squeeze --csv "$path/own table.csv" --particles="$path/p p.csv"
    ok "--csv below '$path': $(cat err)" test "$status" -eq 0 -a -s "./$path/own table.csv" -a -s "./$path/p p.csv"
done
run study $few --quick --out "$(printf 'x%.0s' {1..300})"
failed_well "a name too long" 1 "File name too long"
run run squeeze --csv "$(printf 'x/%.0s' {1..3000})t.csv"
failed_well "a path too long" 1 "File name too long"

# Memory limits, from too little to start a run to enough for it: a row, or one line
if nm "$program" 2>/dev/null | grep -q __asan_init; then
    echo "SKIPPED memory limits: the address sanitizer needs terabytes of addresses"
else
    rows=0
    crashes=0
    for ((limit = 12000; limit < 400000; limit = limit * 3 / 2)); do
        for command in "run ring --cells 200 --set steps=1" "run bar --set particles=400000 --cells 20000 --set steps=1" \
            "run ring --method fem --cells 200 --set steps=1" "run squeeze --cells 200000 --particles p.csv"; do
            # shellcheck disable=SC2086 # words
            (ulimit -v $limit && exec "$program" $command >out 2>err)
            status=$?
            if [ $status -eq 0 ] && [ "$(lines out)" -eq 2 ]; then
                rows=$((rows + 1))
            elif [ $status -eq 127 ] && grep -q 'shared libraries' err; then
                continue # the program itself does not fit
            elif [ $status -ne 1 ] || [ "$(lines err)" -ne 1 ] || [ -s out ]; then
                crashes=$((crashes + 1))
                echo "  ulimit -v $limit, $command: status $status, $(head -n 2 err)" >&2
            fi
        done
    done
    ok "memory limits: $rows rows, $crashes crashes" test $crashes -eq 0 -a $rows -gt 0
    (ulimit -v 60000 && exec "$program" study $few --quick --out tight >out 2>err)
    status=$?
    ok "a study in little memory: $(cat err)" test $status -le 1 -a "$(lines err)" -le 1
fi

ok "nothing half written is left" test -z "$(find . -name '*.tmp')"
verdict
