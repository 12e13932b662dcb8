#!/usr/bin/env bash
# lint.sh: the conventions of the code, checked: format, include rules, lengths, warnings of both compilers.
# Prints what is wrong; a tool that is not installed is SKIPPED. BUILD names a folder for objects.
set -u
BUILD=${BUILD:-build/lint}
wrong=0
complain() {
    echo "lint: $*"
    wrong=1
}
have() {
    command -v "$1" >/dev/null && return
    echo "SKIPPED $1"
    return 1
}
# every ROOM...: the C files of these rooms and of the folders below them; an empty room is a fault.
every() {
    local room
    for room in "$@"; do
        find "$room" -name '*.[ch]' | LC_ALL=C sort | grep . || complain "$room: no C file" >&2
    done
}
rooms=(common methods problems fem_ref studies tests)
mapfile -t sources < <(every "${rooms[@]}")
mapfile -t scripts < <(find tests -name '*.sh')
for room in "${rooms[@]}"; do [[ " ${sources[*]}" == *" $room/"* ]] || complain "$room: an empty room"; done
have clang-format && for file in "${sources[@]}"; do
    clang-format --dry-run -Werror "$file" 2>/dev/null || complain "$file: not as clang-format has it"
done
check() { # DIM, rooms
    cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr \
        --suppress=unknownMacro --suppress=missingInclude --suppress=ctunullpointer --suppress=uninitvar \
        --suppress=legacyUninitvar --suppress=uninitStructMember --suppress=internalAstError \
        --suppress=arrayIndexOutOfBounds `# it does not follow branches on DIM` \
        --error-exitcode=1 -j "$(nproc)" "-DDIM=$1" "${@:2}" || complain "cppcheck, DIM=$1"
}
have shellcheck && { shellcheck -S warning "${scripts[@]}" || complain "shellcheck"; }
have cppcheck && { check 1 common methods; check 2 common methods problems fem_ref studies tests; }

bash tests/tools/rooms.sh || wrong=1
bash tests/tools/test_rooms.sh "$BUILD" || wrong=1

found=$(grep -rnE '#\s*(el)?if.*\bDIM\b' --include='*.[ch]' --exclude-dir=build . | grep -v '^./common/contract/dim\.h') &&
    complain "#if DIM outside common/contract/dim.h"$'\n'"$found"
found=$(every common problems studies |
    xargs grep -nE 'str(n)?cmp *\([^;]*"(mpm|gimp|ge_mpm|ge_gimp|wls|wls2|ge_wls|fem)"') && complain "branches on a method's name"$'\n'"$found"

bash tests/tools/mutants.sh --check || complain "tests/tools/mutants.list"

# Lengths: a function starts at a line in column 0 and ends at a brace in column 0. A page of a study has 200 lines at most.
for file in "${sources[@]}"; do
    case $file in
    studies/w07/*.c | studies/w11/*.c | studies/own/*.c | studies/hard/*.c) most=200 ;;
    *) most=300 ;;
    esac
    awk -v file="$file" -v most=$most '
        /^[{]/ || (/^[a-zA-Z_].*[)] *[{]$/) { start = FNR }
        /^}/ && start { if (FNR - start + 1 > 40) print file ":" start ": " FNR - start + 1 " lines"; start = 0 }
        length($0) > 100 { print file ":" FNR ": wider than 100 columns" }
        END { if (FNR > most) print file ": " FNR " lines, at most " most }' "$file"
done | grep . && complain "too long"

for compiler in gcc clang; do
    have $compiler || continue
    make -s -k -j "$(nproc)" CC=$compiler BUILD="$BUILD/$compiler" OMP= WERROR=-Werror objects >"$BUILD.log" 2>&1 ||
        { complain "$compiler"; head -n 40 "$BUILD.log"; }
done
# Names of public symbols.
[ ! -d "$BUILD/gcc" ] || bash tests/tools/rooms.sh "$BUILD/gcc" || wrong=1
# Calls through pointers: one a stage and chunk, none a particle. The loops over particles hold none at all.
stages() { # object, how many calls through pointers its stages make
    local found
    found=$(objdump -d "$1" | grep -cE 'call +\*')
    [ "$found" -le "$2" ] || complain "$1: $found indirect calls, at most $2 stages of a chunk"
}
if [ -d "$BUILD/gcc/d2" ]; then
    for object in "$BUILD"/gcc/d[12]/methods/{,parts/,wls/}*.o "$BUILD"/gcc/d[12]/common/contract/material.o; do
        case $object in
        */wls/patches.o | *'*'*) ;; # for output: a call per polygon
        *) stages "$object" 0 ;;
        esac
    done
    for d in 1 2; do
        core=$BUILD/gcc/d$d/common/core
        stages "$core/mirror.o" 2 # visits, once a line of symmetry
        stages "$core/solve.o" 1  # repair
        stages "$core/deposit.o" 19 # width and shapes thrice (filters, particles on nodes), lists, payload, body force, assemble, integrate; distance
        stages "$core/gather.o" 21  # width, shapes and lists five times (filters, first moments, hand-over), reach, update
    done
fi

[ $wrong -eq 0 ] && echo "lint: clean"
exit $wrong
