#!/usr/bin/env bash
# deps.sh [-o] PACKAGE...: installs the Debian packages named, those that are missing. With -o they are optional: what
# this release does not have, or cannot install, is
# SKIPPED with apt's reason.
set -u
optional=
if [ "${1:-}" = -o ]; then
    optional=yes
    shift
fi
if ! command -v apt-get >/dev/null; then
    echo "deps: there is no apt-get here; install what these Debian packages hold: $*" >&2
    exit 1
fi
missing=()
for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "deps: need root to install: ${missing[*]}" >&2
        exit 1
    fi
    root=(sudo)
fi
add() {
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get -qq install --yes --no-install-recommends "$@" >/dev/null
}
"${root[@]}" apt-get -qq update || exit 1
if [ -z "$optional" ]; then
    add "${missing[@]}"
    exit
fi
add "${missing[@]}" 2>/dev/null && exit 0
for package in "${missing[@]}"; do
    why=$(add "$package" 2>&1) || echo "SKIPPED $package: ${why##*$'\n'}"
done
