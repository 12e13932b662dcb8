#!/usr/bin/env bash
# cli.sh PROGRAM FOLDER: drives the program as a user would, wrong inputs and killed studies included.
# Writes below FOLDER only. Prints what failed, then "N passed, N failed"; status 1 if any did.
set -u
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$0")/checks.sh"
program=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
mkdir -p "$2"
work=$(mktemp -d "$(realpath "$2")/cli.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
cd "$work" || exit 1
study=w07_05_squeeze_linear

# Wrong usage of every kind
refused "no command" 2 "COMMAND"
refused "unknown command" 2 "did you mean 'list'" lst
refused "abbreviated command" 2 "did you mean 'describe'" desc
refused "no problem" 2 "PROBLEM" run
refused "unknown problem" 2 "did you mean 'squeeze'" run squeze
refused "two problems" 2 "one problem only" run squeeze squeeze
refused "unknown option" 2 "did you mean '--cells'" run squeeze --cels 3
refused "unknown short option" 2 "unknown option '-x'" run squeeze -x
refused "option without value" 2 "--cells: got nothing" run squeeze --cells
refused "flag with value" 2 "takes no value" run squeeze --quiet=1
refused "unknown method" 2 "did you mean 'gimp'" run squeeze --method gmp
refused "two letters exchanged" 2 "did you mean 'gimp'" run squeeze --method gipm
refused "capital letters" 2 "did you mean 'gimp'" run squeeze --method GIMP
refused "help of an unknown command" 2 "did you mean 'sweep'" help swep
refused "help of two commands" 2 "one command" help run study
refused "unknown integrator" 2 "integrator" run squeeze --integrator xx
refused "unknown setting" 2 "field" run squeeze --set feild=linear
refused "setting without value" 2 "NAME=VALUE" run squeeze --set field
refused "wrong word" 2 "linear" run squeeze --set field=liner
for value in 0 -1 1.5 nan inf 1e8 ten '' ' 1' 0x10; do
    refused "--cells '$value'" 2 "--cells: got '$value'" run squeeze "--cells=$value"
done
for value in 0 -2 nan 1e7; do
    refused "--ppc $value" 2 "--ppc: got '$value'" run squeeze --ppc "$value"
    refused "--cfl $value" 2 "--cfl: got '$value'" run squeeze --cfl "$value"
done
refused "--t-end 0" 2 "--t-end" run squeeze --t-end 0
refused "--threads 0" 2 "1 to 1024" run squeeze --threads 0
refused "--jobs 1.5" 2 "1 to 1024" study all --jobs 1.5
refused "--every alone" 2 "--vtk" run squeeze --every 3
refused "ppc and particles" 2 "particles" run squeeze --ppc 2 --set particles=200
refused "unknown study" 2 "did you mean '$study'" study w07_05_squeeze_liner
refused "no study" 2 "NAME" study
refused "study of an unknown method" 2 "did you mean 'mpm'" study all --method gimp,mmp
refused "list and collect" 2 "both" study all --list --collect
refused "list of a wrong kind" 2 "did you mean 'methods'" list method
refused "describe nothing known" 2 "did you mean 'gimp'" describe gimpp
refused "claims takes no names" 2 "options only" claims all

# Sweeps: lists that are none
for list in 8:128 8:128:2 '8:128:*1' '8:128:*0.5' '8:128:+0' '128:8:*2' '0:8:*2' '8:x:*2' ':8:*2' '8:16:*2:3' '1:1e6:+1' \
    '8,,16' ',' ''; do
    refused "--cells $list" 2 "--cells" sweep squeeze "--cells=$list"
done
refused "sweep of nothing" 2 "PROBLEM" sweep
refused "sweep of an unknown problem" 2 "did you mean 'squeeze'" sweep squeze
refused "sweep of two problems" 2 "one problem only" sweep squeeze bar
refused "sweep of an unknown option" 2 "did you mean '--cells'" sweep squeeze --cels 3
refused "sweep of an unknown method" 2 "did you mean 'gimp'" sweep squeeze --method mpm,gmp
refused "sweep of an unknown setting" 2 "field" sweep squeeze --set feild=linear,quadratic
refused "sweep of a setting without name" 2 "NAME=LIST" sweep squeeze --set =3
refused "sweep of a wrong word" 2 "linear" sweep squeeze --set field=linear,liner
refused "sweep of one option twice" 2 "one list" sweep squeeze --cells 3 --cells 4
refused "sweep of values with spaces" 2 "without spaces" sweep squeeze --set 'field=linear --cells 4'
refused "sweep too large" 2 "at most 100000" sweep squeeze --cells '1:1000:+1' --ppc '1:1000:+1'
refused "sweep, list and collect" 2 "both" sweep squeeze --list --collect

# What there is
run list
ok "list has four columns" awk -F'\t' 'NF != 4 { exit 1 }' out
ok "list has each name once" test "$(cut -f2 out | sort | uniq -d | wc -l)" -eq 0
for kind in methods problems studies integrators; do
    run list $kind
    ok "list $kind" test "$status" -eq 0 -a "$(cut -f1 out | sort -u | wc -l)" -eq 1
done
for name in squeeze gimp cd $study; do
    run describe $name
    ok "describe $name" test "$status" -eq 0 -a -s out -a ! -s err
done
run describe bar
ok "describe a problem: error scale and formula" grep -qP '^errors over\tv0 L/c\t0.01 m$' out
ok "describe a problem: its exact motion" grep -qP '^formula\tu = ' out
ok "describe a problem: the options that act" grep -qP '^strain_update\t' out
ok "describe a problem: law" grep -qP '^material\tneo-Hookean: J sigma = .*\tuniaxial strain, nu = 0$' out
ok "describe a problem: its constants" grep -qP '^material\t10000\tPa\tYoung' out
run describe column
ok "describe a problem: the linear law" grep -qP '^material\tlinear: ' out
run describe free_block
ok "describe a problem: an end in steps" grep -qP '^t_end\t100\tsteps\t' out
run describe squeeze
ok "describe a projection: not those that cannot act" test "$(grep -cP '^(strain_update|steps|stop_growth|refresh)\t' out)" -eq 0
run describe ge_gimp
ok "describe a method: its integrators" grep -qP '^integrators\tcd usl\tdefault cd$' out
ok "describe a method: those with a fresh gradient" grep -qP '^integrators\tuvf musl\twith --set refresh=1$' out
ok "describe a method: the settings that act" grep -qP '^domain\t' out
run describe mpm
ok "describe a method: not those that cannot act" test "$(grep -cP '^(domain|refresh|allow_unstable)\t' out)" -eq 0
run describe wls
ok "describe a method: the layout that it has unless set" grep -qP '^layout\tradial\t' out
run describe tlmpm
ok "describe a method: the frame that it has unless set" grep -qP '^frame\ttotal\t' out
run describe uvf
ok "describe an integrator: methods it is stable with" grep -qP '^methods\t.*gimp' out
for command in "" list describe run study sweep claims; do
    run $command --help
    ok "$command --help" test "$status" -eq 0 -a -s out -a ! -s err
done
run --help
cp out help
for words in help -h; do
    run $words
    ok "$words" cmp -s out help
done
run run --help
cp out help
for words in "help run" "run -h"; do
    run $words
    ok "$words" cmp -s out help
done
run run squeeze --help --nonsense
ok "help beats a wrong option" test "$status" -eq 0
run --version
ok "version" test "$status" -eq 0 -a "$(lines out)" -eq 6
ok "version knows its dimensions and OpenMP" grep -qE '^dimensions 1 2 3|^OpenMP ([0-9]+|none)$' out
ok "version prints the sums of its sources" grep -qE "^sources [0-9]+ \\(runs\\), [0-9]+ \\(studies\\)$" out
run --man
ok "a manual page" grep -q '^\.TH' out
if command -v man >/dev/null; then
    ok "a manual page that troff takes" test "$(man --warnings -l -Tutf8 out 2>&1 >/dev/null | wc -l)" -eq 0
else
    echo "SKIPPED the manual page's syntax: no man"
fi
run study --help
cp out help
run --man
while read -r option _ ; do
    ok "$option is in the manual" grep -qF -- "${option//-/\\-}" out
done < <(grep -oE -- '--[a-z-]+' help)
run --completion
completed() { bash -c "PATH=$(dirname "$program"):\$PATH; source ./out; COMP_WORDS=($1); COMP_CWORD=$2; _mpmlab; echo \${COMPREPLY[*]}"; }
ok "completion of a command" test "$(completed 'mpmlab des' 1)" = describe
ok "completion of an option" test "$(completed 'mpmlab run --cel' 2)" = --cells
ok "completion of a method" test "$(completed 'mpmlab run bar --method ge_g' 4)" = ge_gimp

# run
run run squeeze --cells 50 --method mpm --set field=quadratic
cp out first
ok "a header and a row" test "$status" -eq 0 -a "$(lines out)" -eq 2 -a ! -s err
run run --method=mpm --set=field=quadratic --cells=50 -- squeeze
ok "--opt=value and --" test "$status" -eq 0 -a "$(cut -d, -f1-17 out)" = "$(cut -d, -f1-17 first)"
run run squeeze --csv t.csv
run run squeeze --csv t.csv --ppc 3
ok "--csv appends" test "$(lines t.csv)" -eq 3
printf 'squeeze,gi' >>t.csv
run run squeeze --csv t.csv
ok "--csv after a torn line" test "$status" -eq 0 -a "$(lines t.csv)" -eq 4 -a "$(lines err)" -eq 1
truncate -s -1 t.csv
run run squeeze --csv t.csv --quiet
ok "--csv after a last line without its end" test "$(lines t.csv)" -eq 5 -a ! -s err
echo a,b >other.csv
refused "--csv with other columns" 2 "other columns" run squeeze --csv other.csv
ok "other.csv is as it was" test "$(cat other.csv)" = a,b
refused "--csv nowhere" 1 "no/where.csv" run squeeze --csv no/where.csv
# Places of outputs are looked at before the first step: none of these long runs begins, no row is lost.
touch plain
mkdir folder
long=(run ring --method wls2 --cells 200 --set steps=1000000 --t-end 100)
for option in csv history particles samples errors nodes patches; do
    for place in no/where folder plain/x "$(printf 'x%.0s' {1..250})"; do
        timeout 20 "$program" "${long[@]}" --$option "$place" >out 2>err
        status=$?
        failed_well "--$option ${place:0:20}" 1 "$place: "
    done
done
for place in plain plain/x; do
    timeout 20 "$program" "${long[@]}" --vtk $place >out 2>err
    status=$?
    failed_well "--vtk $place" 1 "plain"
done
refused "--csv a folder" 1 "directory" run squeeze --csv .
for k in 1 2 3 4 5 6 7 8; do "$program" run squeeze --csv many.csv --ppc $k >/dev/null & done
wait
ok "--csv from several at once" test "$(lines many.csv)" -eq 9 -a "$(sort -u many.csv | wc -l)" -eq 9
for command in list --help --version "run squeeze" "describe gimp"; do
    "$program" $command >/dev/full 2>err
    ok "$command into a full disk" test $? -eq 1 -a "$(lines err)" -eq 1
done

# A hand-over: its settings are the row's parameters, which run it again; a row of the first method
words="run ring --cells 8 --method wls2 --then gimp --at .0100 --then-set domain=undeformed"
run $words
cp out then.csv
ok "--then: the row: $(cat err)" test "$status" -eq 0 -a "$(tail -n 1 out | cut -d, -f2)" = wls2
ok "--then: its parameters" grep -qE ';at=0.01;.*;then=gimp;then_domain=undeformed;' out
ok "--then: when it was" grep -q 'gimp from step 28 t=0.01' out
place=a_folder_whose_name_is_longer_than_a_setting
mkdir $place && cp "$here/../data/scans/porous.pgm" $place/
run run scan --cells 16 --method wls2 --set file=$place/porous.pgm --then gimp --at .001 --set steps=200
ok "--then: a long path: $(cat err)" test "$status" -eq 0
run run ring --cells 16 --method wls2 --then gimp --at .005 --set dt=adaptive --history walls.csv
ok "--then: when it was, in adaptive steps" grep -q 'gimp from step 41 t=0.0051' out
ok "--then: walls push on as before" awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) if ($k == "wall1_fx") w = k }
    NR > 2 && NR > 40 && NR < 44 { d = $w - last; if (d < 0) d = -d; if (d > 100) bad = 1; n++ } { last = $w }
    END { exit bad || n != 3 }' walls.csv
run run ring --cells 8 --method wls2 --set then_domain=undeformed --set then=gimp --set at=0.01
ok "--then: by its parameters again" cmp -s <(timeless out) <(timeless then.csv)
run $words --threads 2
ok "--then: by two threads" cmp -s <(timeless out) <(timeless then.csv)
run run ring --cells 8 --method gimp --then gimp --at .01
cp out twice.csv
run run ring --cells 8 --method gimp
ok "--then the same method: the same error" test "$(tail -n 1 out | cut -d, -f12 | cut -c1-12)" = "$(tail -n 1 twice.csv | cut -d, -f12 | cut -c1-12)"
run run hanging_bar --method wls2 --then gimp --at inverted
ok "--at inverted goes on" test "$(tail -n 1 out | cut -d, -f10)" -gt 250
run run ring --cells 8 --then mpm --at J=.01
ok "--at J that never comes" grep -q 'never handed over to mpm' out

# Studies: whole, resumed, killed, two at once
mkdir plotless # no gnuplot there: figures are not what is asked
PATH=$work/plotless "$program" study all --quick --method ge_mpm --out lines >out 2>err
ok "all studies: a line each" test "$(grep -cE '^mpmlab: [a-z0-9_]+: (done|failed)' err)" -eq "$("$program" list studies | wc -l)"
"$program" study $study --quick >out 2>err
ok "quick study: $(cat err)" test $? -eq 0 -a -s build/out/quick/$study.csv -a ! -s out
ok "quick gives no verdicts" test ! -e build/out/quick/claims.csv
run study $study --out a --jobs 2
ok "study: $(cat err)" test "$status" -eq 0 -a ! -s out
ok "its files" test -s a/$study.csv -a -s a/$study.json -a -s a/claims.csv -a -s a/index.html
ok "timings last" grep -q 'cpu_s,wall_s,ns_per_particle_step,wall_run_s$' <(head -n 1 a/$study.csv)
size=$(stat -c %s a/$study.rows)
cp a/$study.csv before.csv
run study $study --out a
ok "done is done" test "$(stat -c %s a/$study.rows)" -eq "$size"
ok "and leaves the same table" cmp -s before.csv a/$study.csv

mkdir b
head -c $((size / 2)) a/$study.rows >b/$study.rows
run study $study --out b
ok "resumes from a torn journal" cmp -s <(untimed a/$study.csv) <(untimed b/$study.csv)
ok "and doubles no row" test "$(cut -f1 b/$study.rows | cut -c19- | sort | uniq -d | wc -l)" -eq 0

# stopped SIGNAL FOLDER: starts the study and sends it the signal once it has rows.
stopped() {
    "$program" study $study --out "$2" --jobs 2 >/dev/null 2>err &
    for ((k = 0; k < 100000; k++)); do [ -s "$2/$study.rows" ] && break; done
    kill "-$1" $!
    wait $!
    status=$?
} 2>/dev/null
all=$(($(lines a/$study.csv) - 1))

stopped KILL c
ok "killed by SIGKILL: status $status" test "$status" -eq 137
ok "half way, at $(lines c/$study.rows) rows" test "$(lines c/$study.rows)" -lt "$all"
run study $study --out c
ok "resumes after SIGKILL" cmp -s <(untimed a/$study.csv) <(untimed c/$study.csv)
ok "and kept its rows" test "$(lines c/$study.rows)" -eq "$all"

for signal in INT TERM; do
    stopped $signal $signal
    ok "SIG$signal: status $status, $(cat err)" test "$status" -eq 130 -a "$(lines err)" -eq 1
    ok "SIG$signal makes no table" test ! -e $signal/$study.csv
    run study $study --out $signal
    ok "SIG$signal keeps the rows" test "$(lines $signal/$study.rows)" -eq "$all"
done

"$program" study $study --out d >/dev/null 2>&1 &
run study $study --out d
wait
ok "two at once" cmp -s <(untimed a/$study.csv) <(untimed d/$study.csv)
ok "two at once double no row" test "$(lines d/$study.rows)" -eq "$all"

run study $study --out e --method mpm
ok "one method only" test "$(cut -d, -f2 e/$study.csv | sort -u | tr '\n' ' ')" = "method mpm "
run claims --out e
ok "and no verdict on it" grep -q '^NOT_RUN' out
run study $study --out f --list
ok "list: one command per case" test "$(lines out)" -eq "$all"
head -n 3 out >three
ok "commands run as they are" bash -c 'bash ./three >/dev/null'
run study $study --out f --collect
ok "collect" cmp -s <(untimed a/$study.csv) <(untimed f/$study.csv)
ok "collect ran only the rest" test "$(lines f/$study.rows)" -eq "$all"

# Other options of run
run run squeeze --set repeat=2
ok "repeat is part of the key only" grep -q 'repeat=2' out
run run sine_bar --cells 10 --errors e.csv
ok "--errors" awk -F, 'NR > 1 && $4 > m { m = $4 } END { exit !(NR == 21 && m > 0) }' e.csv
refused "--errors without an exact motion" 2 "exact" run squeeze --errors e.csv
run run ring --method wls2 --cells 8 --set steps=1 --patches c.csv
ok "--patches" awk -F, 'NR == 1 { ok = $0 == "cell,k,x,y,cut" } NF == 5 && $5 == 1 { n++ } END { exit !(ok && n > 20) }' c.csv
refused "--patches of a method without polygons" 2 "polygons" run ring --method gimp --cells 8 --set steps=1 --patches c.csv
for problem in free_block block; do
    run run $problem --cells 8 --set steps=200
    ok "$problem: steps beyond a counted end are made" test "$(tail -n 1 out | cut -d, -f10)" -eq 200
done
run run ring --cells 8 --set steps=1000
ok "steps beyond t_end: $(cat err)" grep -q "steps: got '1000', but t_end = 0.02 was reached after 54 steps" err
run run ring --cells 8 --set steps=54
ok "all the steps there are" test "$status" -eq 0 -a ! -s err
run study t_02_work_precision --quick --out t --list
ok "a timed study says so" grep -q 'one after the other' err

# Paths and machines that are not as they should be
run study $study --quick --out "a folder's \$HOME; x"
ok "a path with spaces: $(cat err)" test "$status" -eq 0
if command -v gnuplot >/dev/null; then
    ok "and its figure" test -s "a folder's \$HOME; x/quick/$study.svg"
fi
mkdir empty
PATH=$work/empty "$program" study $study --quick --out g >out 2>err
ok "no gnuplot: status 0, one line" test $? -eq 0 -a "$(lines err)" -eq 1 -a -s g/quick/$study.csv
refused "out below a file" 1 "t.csv" study $study --out t.csv/x
run claims --out a
ok "claims" test "$status" -eq 0 -o "$status" -eq 3
ok "one line per claim" test "$(lines out)" -eq $(($(lines a/claims.csv) - 1))
sed -i '2s/mpm/mpn/' a/$study.csv
run claims --out a
ok "a table that was edited is not judged" grep -q '^NOT_RUN.*not the one' out

# Snapshots, opened by VTK's own reader
/usr/bin/python3 -c 'import vtkmodules.vtkIOXML' 2>/dev/null && vtk=1 || vtk=0
[ $vtk = 1 ] || echo "SKIPPED reading snapshots: no VTK for /usr/bin/python3 (make deps-extra)"
vtk_read() { /usr/bin/python3 "$here/vtk_read.py" "$@" >"read" 2>&1; }
for method in gimp fem wls2; do
    run run disk_impact --method $method --cells 16 --vtk snap/$method --every 40 --particles last.csv --samples all.csv
    ok "--vtk $method: $(cat err)" test "$status" -eq 0 -a -s snap/$method/particles.pvd
    [ $method = fem ] || ok "samples of $method are its particles" cmp -s last.csv all.csv
    [ $vtk = 1 ] && ok "VTK reads what $method wrote" vtk_read snap/$method last.csv
done
if [ $vtk = 1 ]; then
    ok "VTK finds cut cells" grep -q '^cells.*cut.1.=0..1' read
    last=$(ls snap/wls2/particles_*.vtp | tail -n 1)
    sed -i '/Name="mass"/s/offset="[0-9]*"/offset="0"/' "$last"
    ok "a wrong offset is noticed" bash -c '! /usr/bin/python3 "$0"/vtk_read.py snap/wls2 last.csv >/dev/null' "$here"
    head -c 3000 "$last" >short && mv short "$last"
    ok "a torn file is noticed" bash -c '! /usr/bin/python3 "$0"/vtk_read.py snap/wls2 >/dev/null' "$here"
fi
run run bar --vtk snap/time --every .001s --set steps=150 --quiet
ok "--every a time: 0, .001, .002, .003 and the end" test "$status" -eq 0 -a "$(grep -c '<DataSet' snap/time/particles.pvd)" -eq 5
ok "--every a time: the first step that reaches it" grep -q 'timestep="0.001"' snap/time/particles.pvd
ok "the grid at the start" test -s snap/time/nodes_000000.vtp
# A stream goes on where it is, also if it is a file.
"$program" run bar --set steps=150 --history /proc/self/fd/1 >both 2>err
"$program" run bar --set steps=150 --history h.csv >out
ok "history and row: $(cat err)" test "$(lines both)" -eq 154 -a "$(lines h.csv)" -eq 152
ok "in one stream" cmp -s <(cat h.csv out | timeless /dev/stdin) <(timeless both)
ln -s /proc/self/fd/1 stream
"$program" run bar --set steps=150 --history stream >through 2>err
ok "through a link: $(cat err)" cmp -s <(timeless both) <(timeless through)
refused "a stream to read from" 1 "Bad file descriptor" run bar --history /dev/fd/0 </dev/null
refused "a state cannot be read back" 2 "--checkpoint: got '/proc/self/fd/1'" run bar --checkpoint /proc/self/fd/1
refused "nor a history" 2 "--history: got '/proc/self/fd/1'" run bar --history /proc/self/fd/1 --checkpoint state
run run bar --set steps=150
cp out plain.csv
run run bar --set steps=150 --vtk snap/time --every 1
ok "snapshots change nothing" cmp -s <(timeless out) <(timeless plain.csv)
for every in 0s -1s s nans 1x 0.5; do
    refused "--every $every" 2 "--every: got '$every'" run bar --vtk snap/time "--every=$every"
done
refused "--vtk below a file" 1 "t.csv" run disk_impact --vtk t.csv/x
run run squeeze --cells 10 --vtk snap/squeeze --particles last.csv --quiet
ok "--vtk of a projection" test "$status" -eq 0 -a -s snap/squeeze/particles.pvd -a -s snap/squeeze/nodes_000000.vtp
[ $vtk = 1 ] && ok "VTK reads it" vtk_read snap/squeeze last.csv

ok "nothing half written is left" test -z "$(find . -name '*.tmp')"
verdict
