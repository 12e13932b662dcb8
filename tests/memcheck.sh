#!/usr/bin/env bash
# memcheck.sh FOLDER: valgrind over the unit tests and the quick suite, in a build for any processor.
# Prints the counts; status 1 if there is an error or a leak. Many minutes.
set -u
if ! command -v valgrind >/dev/null; then
    echo "SKIPPED valgrind"
    exit 0
fi
mkdir -p "$1"
folder=$(realpath "$1")
rm -rf "$folder/logs" "$folder/out"
mkdir -p "$folder/logs"
check() {
    valgrind -q --leak-check=full --show-leak-kinds=definite,indirect,possible --error-exitcode=9 \
        --log-file="$folder/logs/%p" "$@"
}
units=(core_2d core_3d core_1d wls tools scenes fem) # longest first
make -s -j "$(nproc)" BUILD="$folder" ARCH= OMP= OPT='-O2 -ffp-contract=off' all "${units[@]/#/$folder/tests/}" || exit 1
failed=0
export folder
export -f check
printf '%s\n' "${units[@]}" | xargs -P "$(nproc)" -I UNIT bash -c 'cd "$folder/tests" && check ./UNIT >UNIT.log' || failed=1
for problem in $("$folder/mpmlab" list problems | cut -f 2); do # in one process each, to its very end
    for method in $("$folder/mpmlab" list methods | cut -f 2); do
        check "$folder/mpmlab" run "$problem" --method "$method" --cells 8 --set steps=3 \
            --set allow_unstable=1 --history "$folder/h.csv" --particles "$folder/p.csv" >/dev/null 2>&1
        [ $? -eq 9 ] && failed=1
    done
done
check "$folder/mpmlab" study all --quick --jobs "$(nproc)" --out "$folder/out" || failed=1
found=$(find "$folder/logs" -type f -size +0 | wc -l)
echo "valgrind: $(find "$folder/logs" -type f | wc -l) processes, $found with errors or leaks"
find "$folder/logs" -type f -size +0 -exec head -n 12 {} \; | head -n 40
[ "$failed" -eq 0 ] && [ "$found" -eq 0 ]
