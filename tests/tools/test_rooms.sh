#!/usr/bin/env bash
# test_rooms.sh FOLDER: the house rules can fail. In a copy of the tree below FOLDER a forbidden include planted in
# each room turns rooms.sh red, and one changed byte in each room changes the sums of sources that --version prints.
# Prints what failed, then "N passed, N failed"; status 1 if any did.
set -u
root=$(realpath "$(dirname "$0")/../..")
mkdir -p "$1"
tree=$(mktemp -d "$(realpath "$1")/rooms.XXXXXX")
trap 'rm -rf "$tree"' EXIT
unset MAKEFLAGS MFLAGS MAKEOVERRIDES
passed=0 failed=0
ok() { # WHAT COMMAND...
    if "${@:2}"; then passed=$((passed + 1)); else failed=$((failed + 1)) && echo "FAILED: rooms: $1" >&2; fi
}
cp -r "$root"/{Makefile,common,methods,problems,fem_ref,studies,plots,tests} "$tree/"
cd "$tree" || exit 1
red() { ! bash tests/tools/rooms.sh >log 2>&1 && grep -q "$1" log; }
sums() { make -s build/facts.h && grep -E 'SOURCES|STUDIES' build/facts.h; }
changes() { # FILE: another byte at its end
    local before after
    before=$(sums)
    cp "$1" keep
    printf '\n' >>"$1"
    after=$(sums)
    mv keep "$1"
    [ -n "$before" ] && [ "$before" != "$after" ]
}
ok "the tree as it is" bash tests/tools/rooms.sh
mapfile -t rooms < <(sed -n 's/^\([a-z_0-9/]*\):.*/\1/p' tests/tools/rooms.txt)
for room in "${rooms[@]}"; do
    file=$(find "$room" -maxdepth 1 -name '*.[ch]' | LC_ALL=C sort | head -n 1)
    cp "$file" keep_source
    echo '#include "tests/check.h"' >>"$file"
    ok "$room: a forbidden include" red "$file may not include tests/check.h"
    mv keep_source "$file"
    ok "$room: a changed byte" changes "$file"
done
ok "plots: a changed byte" changes plots/style.gp
echo '#include "table.h"' >>common/base/fault.h # which table.h includes
ok "a circle of includes" red "circle"
sed -i '$d' common/base/fault.h
mkdir studies/attic && echo >studies/attic/old.c
ok "a folder without a line in rooms.txt" red "not in rooms.txt: studies/attic"
rm -r studies/attic
mv problems kept
mkdir problems
ok "an empty room" red "problems: no C file"
# shellcheck disable=SC2016
ok "an empty room has no sum" bash -c '! make -s build/facts.h 2>/dev/null'
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
