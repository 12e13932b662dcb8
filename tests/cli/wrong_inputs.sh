#!/usr/bin/env bash
# wrong_inputs.sh PROGRAM FOLDER: every line of wrong_inputs.txt is refused: that status, nothing on standard
# output, one line of plain text with those words on standard error, and not a file left behind.
set -u
program=$(realpath "$1")
list=$(realpath "$(dirname "$0")/wrong_inputs.txt")
mkdir -p "$2"
work=$(mktemp -d "$(realpath "$2")/wrong.XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir "$work/here"
cd "$work/here" || exit 1
refused=0
failed=0
while IFS= read -r line; do
    case $line in '#'* | '') continue ;; esac
    want=${line%% | *}
    rest=${line#* | }
    text=${rest% | *}
    eval "arguments=(${rest##* | })"
    # shellcheck disable=SC2154 # eval sets it
    timeout 20 "$program" "${arguments[@]}" >../out 2>../err
    status=$?
    if [ $status -eq "$want" ] && [ ! -s ../out ] && [ "$(wc -l <../err)" -eq 1 ] && grep -qF -- "$text" ../err &&
        ! LC_ALL=C grep -q $'[\x01-\x08\x0b-\x1f]' ../err && [ -z "$(ls -A)" ]; then
        refused=$((refused + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $line"$'\n'"  status $status: $(cat ../err)" >&2
    fi
done <"$list"
echo "$refused wrong inputs refused in one line, $failed not"
[ $failed -eq 0 ]
