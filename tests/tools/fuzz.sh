#!/usr/bin/env bash
# fuzz.sh FOLDER NAME...: builds the fuzzers below FOLDER and runs each for SECONDS (60) from what is known.
# Prints one line per reader; status 1 if one found something, which is then in FOLDER/found-NAME-*.
set -u
folder=$1
shift
seconds=${SECONDS_EACH:-60}
have_clang() { echo 'int LLVMFuzzerTestOneInput(void) { return 0; }' |
    clang -fsanitize=fuzzer -x c - -o "$folder/probe" >/dev/null 2>&1; }

mkdir -p "$folder"
folder=$(realpath "$folder")
scratch=$(mktemp -d -p "$([ -w /dev/shm ] && echo /dev/shm || echo "$folder")")
trap 'rm -rf "$scratch"' EXIT
if ! have_clang; then
    echo "SKIPPED fuzz: clang with libFuzzer is not installed"
    exit 0
fi
make -s -j "$(nproc)" CC=clang BUILD="$folder" ARCH= OMP= OPT='-O1 -fno-omit-frame-pointer' \
    SAN='-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined' fuzzers || exit 1

# Every word that means something, for the fuzzer to put together.
words() {
    "$folder/mpmlab" list | cut -f 2
    "$folder/mpmlab" list | grep -v '^study' | cut -f 2 | while read -r name; do
        "$folder/mpmlab" describe "$name" | cut -f 1 | sed 's/$/=/'
        "$folder/mpmlab" describe "$name" | grep -o '([a-z0-9_|]*)' | tr -d '()' | tr '|' '\n'
    done
    "$folder/mpmlab" run --help | grep -oE -- '--[a-z-]+'
}
words | grep -v ' ' | sort -u | sed 's/.*/"&"/' >"$folder/words.dict"

failed=0
for name in "$@"; do
    corpus=$folder/corpus/$name
    mkdir -p "$corpus"
    program=$(realpath "$folder/tests/fuzz_$name")
    seeds=$(realpath "$(dirname "$0")/../fuzz/found/$name")
    if (cd "$scratch" && "$program" -seed=1 -max_total_time="$seconds" -timeout=10 -rss_limit_mb=3000 \
        -max_len=4096 "-dict=$folder/words.dict" -print_final_stats=1 \
        "-artifact_prefix=$folder/found-$name-" "$corpus" "$seeds") >"$folder/$name.log" 2>&1; then
        echo "fuzz $name: $seconds s, $(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/$name.log") inputs, nothing found"
    else
        echo "fuzz $name: FOUND: $(grep -E '^found:|ERROR|runtime error|SUMMARY' "$folder/$name.log" | head -n 1)"
        failed=1
    fi
done
exit $failed
