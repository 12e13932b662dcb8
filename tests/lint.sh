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
# refuse ROOM REASON REGEX: no file of the room may include what the regex matches.
refuse() {
    local found
    found=$(every "$1" | xargs grep -nE "^#include +[\"<]($3)[\">]") && complain "$2"$'\n'"$found"
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
        --suppress=arrayIndexOutOfBounds `# it does not follow branches on DIM` \
        --error-exitcode=1 -j "$(nproc)" "-DDIM=$1" "${@:2}" || complain "cppcheck, DIM=$1"
}
have shellcheck && { shellcheck -S warning "${scripts[@]}" || complain "shellcheck"; }
have cppcheck && { check 1 common methods; check 2 common methods problems fem_ref studies tests; }

# Include rules: who may see whom.
refuse common "common/ knows no method, problem or fem (but by lists)" '.*(methods|problems|fem_ref|studies)/.*\.[ch]'
refuse methods "methods/ knows common/ only, no problem, no other method's .c" \
    '.*(problems|fem_ref|studies)/.*|.*problem\.h|.*\.c'
refuse problems "problems/ sees no Sim, no method" \
    '.*(methods|fem_ref|studies)/.*|.*(sim|scheme|method|step)\.h'
refuse fem_ref "fem_ref/ shares no loop with methods/" '.*(methods|studies)/.*|.*(sim|scheme)\.h'

found=$(grep -rnE '#\s*(el)?if.*\bDIM\b' --include='*.[ch]' --exclude-dir=build . | grep -v '^./common/dim\.h') &&
    complain "#if DIM outside common/dim.h"$'\n'"$found"
found=$(every common problems studies |
    xargs grep -nE 'str(n)?cmp *\([^;]*"(mpm|gimp|ge_mpm|ge_gimp|wls|wls2|ge_wls|fem)"') && complain "branches on a method's name"$'\n'"$found"

bash tests/mutants.sh --check || complain "tests/mutants.list"

# Lengths: a function starts at a line in column 0 and ends at a brace in column 0.
for file in "${sources[@]}"; do
    awk -v file="$file" '
        /^[{]/ || (/^[a-zA-Z_].*[)] *[{]$/) { start = FNR }
        /^}/ && start { if (FNR - start + 1 > 70) print file ":" start ": " FNR - start + 1 " lines"; start = 0 }
        length($0) > 100 { print file ":" FNR ": wider than 100 columns" }
        END { if (FNR > 300) print file ": " FNR " lines" }' "$file"
done | grep . && complain "too long"

for compiler in gcc clang; do
    have $compiler || continue
    make -s -k -j "$(nproc)" CC=$compiler BUILD="$BUILD/$compiler" OMP= WERROR=-Werror objects >"$BUILD.log" 2>&1 ||
        { complain "$compiler"; head -n 40 "$BUILD.log"; }
done
# Calls through pointers: one a stage and chunk, none a particle. The loops over particles hold none at all.
stages() { # object, how many calls through pointers its stages make
    local found
    found=$(objdump -d "$1" | grep -cE 'call +\*')
    [ "$found" -le "$2" ] || complain "$1: $found indirect calls, at most $2 stages of a chunk"
}
if [ -d "$BUILD/gcc/d2" ]; then
    for object in "$BUILD"/gcc/d[12]/methods/*.o "$BUILD"/gcc/d[12]/common/material.o; do
        case $object in
        */wls_patches.o) ;; # for output: a call a polygon
        *) stages "$object" 0 ;;
        esac
    done
    for d in 1 2; do
        stages "$BUILD/gcc/d$d/common/mirror.o" 2 # visits, once a line of symmetry
        stages "$BUILD/gcc/d$d/common/solve.o" 1  # repair
        stages "$BUILD/gcc/d$d/common/deposit.o" 10 # width and shapes twice (filters), payload, body force, assemble; distance
        stages "$BUILD/gcc/d$d/common/gather.o" 11  # width and shapes thrice (filters, first moments), update (one call, two sites by gcc)
    done
fi

[ $wrong -eq 0 ] && echo "lint: clean"
exit $wrong
