#!/usr/bin/env bash
# builds.sh FOLDER: the same claims with the same verdicts by every build: native, portable, clang, and neither
# vectors nor threads. Prints a table; status 1 if a build fails or a verdict differs. Many minutes.
set -u
mkdir -p "$1"
folder=$(realpath "$1")
wrong=0
# column N CSV: id and verdict
verdicts() { awk -F'"?,"?' 'NR > 1 { for (k = 1; k <= NF; k++) if ($k ~ /^(PASS|FAIL|DIFFERS|NOT_RUN)$/) print $1, $k }' "$1"; }
count() { verdicts "$1" | grep -c " $2\$"; }
printf '%-9s %7s %6s %6s %6s %8s %9s  %s\n' build seconds rows PASS FAIL DIFFERS NOT_RUN 'verdicts unlike native'
try() { # NAME MAKE-ARGUMENT...
    local name=$1 out=$folder/$1.out start=$SECONDS unlike
    shift
    rm -rf "$out"
    if ! make -s -j "$(nproc)" BUILD="$folder/$name" "$@" all >"$folder/$name.log" 2>&1 ||
        ! "$folder/$name/mpmlab" study all --jobs "$(nproc)" --out "$out" >>"$folder/$name.log" 2>&1; then
        echo "$name: FAILED, see $folder/$name.log"
        wrong=1
        return
    fi
    unlike=$(diff <(verdicts "$folder/native.out/claims.csv") <(verdicts "$out/claims.csv") | grep -c '^>')
    [ "$unlike" -eq 0 ] || wrong=1
    printf '%-9s %7d %6d %6d %6d %8d %9d  %d\n' "$name" $((SECONDS - start)) "$(cat "$out"/*.rows | wc -l)" \
        "$(count "$out/claims.csv" PASS)" "$(count "$out/claims.csv" FAIL)" "$(count "$out/claims.csv" DIFFERS)" \
        "$(count "$out/claims.csv" NOT_RUN)" "$unlike"
    diff <(verdicts "$folder/native.out/claims.csv") <(verdicts "$out/claims.csv") | grep '^[<>]'
}
try native
try portable ARCH=
if command -v clang >/dev/null; then try clang CC=clang OMP=; else echo "SKIPPED clang"; fi
try plain ARCH= OMP=
[ $wrong -eq 0 ]
