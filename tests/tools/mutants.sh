#!/usr/bin/env bash
# mutants.sh FOLDER [PATTERN]: do the tests see faults? Builds the tests below FOLDER, applies the faults of
# mutants.list (those whose line matches PATTERN) one at a time to a copy of that tree, rebuilds what the
# fault touches and runs the trials that the list names until one fails, as one must. JOBS faults at once.
# mutants.sh --check: only whether every fault still applies. One that does not is an error, as is a trial that
# has no test, fails without a fault or does not compile.
set -u
root=$(realpath "$(dirname "$0")/../..")
list=$root/tests/tools/mutants.list jobs=${JOBS:-2} pattern=${2:-.}
file=() trials=() change=() what=()
say() { printf '%s\n' "$*"; }

wrong=0
while IFS='|' read -r path trial rest; do
    case $path in '' | '#'*) continue ;; esac
    sed=${rest%|*} about=${rest##*|}
    grep -q -- "$pattern" <<<"$path|$trial|$rest" || continue
    file+=("$path") trials+=("$trial") change+=("$sed") what+=("$about")
    [ -f "$root/$path" ] || { wrong=1 && say "mutants: no such file: $path: $about" && continue; }
    sed "$sed" "$root/$path" | cmp -s - "$root/$path" && wrong=1 && say "mutants: no longer applies: $path: $about"
done <"$list"
[ $wrong -eq 0 ] && [ ${#file[@]} -gt 0 ] || { say "mutants: $list is out of date"; exit 1; }
[ "$1" = --check ] && say "mutants: ${#file[@]} faults apply" && exit 0

mkdir -p "$1"
folder=$(realpath "$1") base=$folder/base
export CCACHE_DIR=${CCACHE_DIR:-$folder/ccache} CCACHE_NOHASHDIR=1
cc=gcc && command -v ccache >/dev/null && cc='ccache gcc'

build() { # TREE, how many jobs, programs: without caring for speed, debuggers or warnings
    CCACHE_BASEDIR=$1 make -s -C "$1" -j"$2" CC="$cc" OPT='-O1 -g0 -march=native' WARN=-w \
        "${@:3}" >"$1.log" 2>&1
}
run() { # TREE, program or program:part of "suite: test"
    local only=()
    [ "$2" = "${2#*:}" ] || only=("ONLY=${2#*:}")
    (cd "$1/build/tests" && env "${only[@]}" OMP_WAIT_POLICY=passive timeout "${LIMIT:-120}" \
        "./${2%%:*}" >"$1.out" 2>&1)
}
try() { # number of a fault, TREE: prints one line
    local tree=$2 verdict=missed trial seconds=$SECONDS
    rm -rf "$tree" && cp -a "$base" "$tree"
    sed -i "${change[$1]}" "$tree/${file[$1]}"
    while read -r -d, trial; do
        build "$tree" 1 "build/tests/${trial%%:*}" || { verdict=broken && break; }
        run "$tree" "$trial"
        case $? in
        0) ;;
        124) verdict=timeout && break ;; # not seen: the machine may be slow
        *) verdict=caught && break ;;
        esac
    done <<<"${trials[$1]},"
    say "$(printf '%-7s %2d %3d s  %s: %s' "$verdict" $(($1 + 1)) $((SECONDS - seconds)) "${file[$1]}" "${what[$1]}")"
}

mkdir -p "$base"
find "$base" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
tar -C "$root" --exclude=./build --exclude=./.git -cf - . | tar -C "$base" -xf - # times are kept
mapfile -t all < <(printf '%s\n' "${trials[@]}" | tr , '\n' | sort -u)
mapfile -t programs < <(printf 'build/tests/%s\n' "${all[@]%%:*}" | sort -u)
build "$base" "$jobs" "${programs[@]}" || { tail "$base.log"; say "mutants: the tree does not compile"; exit 1; }
for trial in "${all[@]}"; do
    run "$base" "$trial"
    case $? in
    0) ;;
    2) say "mutants: $trial: no such test" && exit 1 ;;
    *) tail -n 30 "$base.out" && say "mutants: $trial fails without any fault" && exit 1 ;;
    esac
done

for ((w = 0; w < jobs; w++)); do
    for ((k = w; k < ${#file[@]}; k += jobs)); do try "$k" "$folder/tree.$w"; done >"$folder/verdicts.$w" &
done
wait
sort -k2n "$folder"/verdicts.* | sed '/^caught/!s/^/-> /'
caught=$(cat "$folder"/verdicts.* | grep -c ^caught)
say "mutants: $caught of ${#file[@]} caught in $SECONDS s"
[ "$caught" -eq ${#file[@]} ]
