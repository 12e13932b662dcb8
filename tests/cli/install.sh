#!/usr/bin/env bash
# install.sh BUILD FOLDER: make install under a DESTDIR with a space in it; what is there works; uninstall takes it
# all away again. Status 1 and a line if not.
set -u
build=$1
mkdir -p "$2"
root=$(mktemp -d "$(realpath "$2")/install.XXXXXX")
trap 'rm -rf "$root"' EXIT
fail() {
    echo "FAILED: install: $*" >&2
    exit 1
}
make -s install BUILD="$build" DESTDIR="$root/a root" PREFIX=/usr >"$root/log" 2>&1 || fail "$(tail -n 3 "$root/log")"
share="$root/a root/usr/share"
program="$root/a root/usr/bin/mpmlab"
[ -s "$share/man/man1/mpmlab.1" ] || fail "no manual page"
bash -n "$share/bash-completion/completions/mpmlab" || fail "no completion"
(cd "$root" && "$program" study w07_04_squeeze --quick --out results) || fail "a study"
if command -v gnuplot >/dev/null; then
    [ -s "$root/results/quick/w07_04_squeeze.svg" ] || fail "it does not find its plots"
fi
make -s uninstall BUILD="$build" DESTDIR="$root/a root" PREFIX=/usr >"$root/log" 2>&1 || fail "uninstall"
[ -z "$(find "$root/a root" ! -type d)" ] || fail "uninstall leaves $(find "$root/a root" ! -type d | head -n 1)"

# Alone in a folder it says that it has no plots, and leaves numbers and verdicts all the same.
alone=$(mktemp -d)
trap 'rm -rf "$root" "$alone"' EXIT
cp "$build/mpmlab" "$alone/"
"$alone/mpmlab" study w07_04_squeeze --quick --out "$alone/out" 2>"$root/log"
[ $? -eq 1 ] || fail "a program without plots: wrong status"
grep -q 'no folder plots .* w07_04_squeeze is not drawn' "$root/log" || fail "a program without plots does not say so"
[ -s "$alone/out/quick/w07_04_squeeze.csv" ] || fail "a program without plots loses its numbers"
echo "installed and uninstalled"
