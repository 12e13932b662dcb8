#!/usr/bin/env bash
# builds.sh FOLDER: the same claims with the same verdicts by every build: native, portable, clang, and neither
# vectors nor threads. Prints a table; status 1 if a build, a study or a claim fails, or a verdict differs. An hour;
# interrupted, it goes on where it was (and its seconds are those of the last time).
set -u
mkdir -p "$1"
folder=$(realpath "$1")
export folder
wrong=0
# FILE: id and verdict of every claim
verdicts() { awk -F'"?,"?' 'NR > 1 { for (k = 1; k <= NF; k++) if ($k ~ /^(PASS|FAIL|DIFFERS|NOT_RUN)$/) print $1, $k }' "$1"; }
count() { verdicts "$1" | grep -c " $2\$"; }
builds=(native portable)
if command -v clang >/dev/null; then builds+=(clang); else echo "SKIPPED clang"; fi
builds+=(plain)
declare -A arguments=([native]='' [portable]='ARCH=' [clang]='CC=clang OMP=' [plain]='ARCH= OMP=')
for name in "${builds[@]}"; do
    # shellcheck disable=SC2086 # words
    make -s -j "$(nproc)" BUILD="$folder/$name" ${arguments[$name]} all >"$folder/$name.log" 2>&1 || wrong=1
done
studies() { # NAME: one job each, since timed studies run one case at a time
    local start=$SECONDS
    rm -f "$folder/$1.out/claims.csv" # rows of the same program stay: an interrupted check goes on
    "$folder/$1/mpmlab" study all --out "$folder/$1.out" >>"$folder/$1.log" 2>&1
    echo "$? $((SECONDS - start))" >"$folder/$1.end"
}
export -f studies
printf '%s\n' "${builds[@]}" | xargs -P "$(nproc)" -L 1 bash -c 'studies "$1"' bash
printf '%-9s %7s %6s %6s %6s %8s %9s  %s\n' build seconds rows PASS FAIL DIFFERS NOT_RUN 'verdicts unlike native'
for name in "${builds[@]}"; do
    out=$folder/$name.out
    read -r status seconds <"$folder/$name.end"
    [ "$status" -eq 0 ] || wrong=1
    if [ ! -s "$out/claims.csv" ]; then
        echo "$name: FAILED, see $folder/$name.log"
        wrong=1
        continue
    fi
    unlike=$(diff <(verdicts "$folder/native.out/claims.csv") <(verdicts "$out/claims.csv") | grep -c '^>')
    [ "$unlike" -eq 0 ] || wrong=1
    printf '%-9s %7d %6d %6d %6d %8d %9d  %d\n' "$name" "$seconds" "$(cat "$out"/*.rows | wc -l)" \
        "$(count "$out/claims.csv" PASS)" "$(count "$out/claims.csv" FAIL)" "$(count "$out/claims.csv" DIFFERS)" \
        "$(count "$out/claims.csv" NOT_RUN)" "$unlike"
    diff <(verdicts "$folder/native.out/claims.csv") <(verdicts "$out/claims.csv") | grep '^[<>]'
done
[ $wrong -eq 0 ]
