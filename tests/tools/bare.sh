#!/usr/bin/env bash
# bare.sh RELEASE [ARCH [COMPILER]]: README's two commands on a machine that has nothing: debootstrap's smallest
# Debian (bookworm, trixie, sid) with gcc, make and git, for amd64 or arm64 (by qemu-user-static), gcc or clang, and
# in it a clone of the commit checked out here. Prints a row of tests/README.md's table; the logs stay. Status 1 if anything
# failed. On a foreign architecture, which is slow, it builds, runs one unit test (fem) and compares rows of the ring
# and the bar with this machine's.
#   BARE    folder for roots and logs (build/bare)       MIRROR  Debian archive (that of this machine's apt)
#   QUICK=  set but empty: the full figures (hours)      KEEP=1  leaves the root that was tried, unmounted
set -u
release=${1:?RELEASE: bookworm, trixie or sid}
own=$(dpkg --print-architecture)
arch=${2:-$own}
compiler=${3:-gcc}
here=$(realpath "$(dirname "$0")/../..")
mkdir -p "${BARE:-$here/build/bare}" || exit 1
folder=$(realpath "${BARE:-$here/build/bare}")
name=$release-$arch
root=$folder/$name-$compiler
log=$root.log
quick=${QUICK---quick}
die() {
    echo "bare: $*" >&2
    exit 1
}

[ "$(id -u)" -eq 0 ] || die "needs root: debootstrap and chroot"
command -v debootstrap >/dev/null || die "no debootstrap here: apt-get install debootstrap"
[[ $compiler =~ ^(gcc|clang)$ ]] || die "compiler $compiler: gcc or clang"
declare -A machine=([arm64]=aarch64 [amd64]=x86_64)
[ -n "${machine[$arch]:-}" ] || die "architecture $arch: amd64 or arm64"
[ "$arch" = "$own" ] || [ -e "/proc/sys/fs/binfmt_misc/qemu-${machine[$arch]}" ] ||
    die "programs for $arch do not run here: apt-get install qemu-user-static, and mount binfmt_misc"
if [ -z "${MIRROR:-}" ]; then # of the packages that apt knows, the archive of the first that are Debian's own
    MIRROR=$(apt-get indextargets --format '$(ORIGIN) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' |
        awk '$1 == "Debian" && $2 == "main" && $3 !~ /security/ { print $3; exit }')
    MIRROR=${MIRROR:-http://deb.debian.org/debian}
fi

unmount() {
    for place in dev/pts proc; do
        mountpoint -q "$root/$place" && umount -l "$root/$place"
    done
}
finish() {
    unmount
    rm -rf "$folder/$name.new"
    [ -n "${KEEP:-}" ] || rm -rf --one-file-system "$root"
}
trap finish EXIT
trap 'exit 130' INT TERM

# The bare root is made once and kept as a tar; what is tried in is a copy, so that nothing is there before `make deps`.
if [ ! -s "$folder/$name.tar" ]; then
    rm -rf --one-file-system "$folder/$name.new"
    debootstrap --variant=minbase --arch="$arch" --include=gcc,make,git "$release" "$folder/$name.new" "$MIRROR" \
        >"$folder/$name.debootstrap.log" 2>&1 || die "debootstrap failed: $(tail -n 1 "$folder/$name.debootstrap.log")"
    tar -C "$folder/$name.new" -cf "$folder/$name.tar.new" . && mv "$folder/$name.tar.new" "$folder/$name.tar" ||
        die "cannot keep $folder/$name.tar"
fi
unmount
rm -rf --one-file-system "$root"
mkdir "$root" && tar -C "$root" -xf "$folder/$name.tar" || die "cannot unpack $folder/$name.tar"
echo 'Acquire::Check-Valid-Until "false";' >"$root/etc/apt/apt.conf.d/snapshot" # archives that stand still will do
git clone -q --no-hardlinks "$here" "$root/mpmlab" || die "cannot clone $here"
mount -t proc proc "$root/proc" && mount -t devpts -o newinstance,ptmxmode=666 devpts "$root/dev/pts" ||
    die "cannot mount /proc and /dev/pts in $root"
: >"$log"

inside() { # COMMAND: as root, in the clone; nothing of this machine's environment goes with it
    echo "\$ $1" >>"$log"
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C ${http_proxy:+http_proxy="$http_proxy"} \
        chroot "$root" bash -c "cd /mpmlab && $1" >>"$log" 2>&1
}
try() { # COMMAND...: sets `result` to ok and seconds, or to FAILED
    local start=$SECONDS
    result=FAILED
    if "$@"; then result="ok, $((SECONDS - start)) s"; else wrong=1; fi
}
# Rows of the ring (2D) and of the bar (1D) without their three columns of time.
rows() { # COMMAND-PREFIX...
    for words in "ring --method "{gimp,wls2,ge_wls,fem} "bar --method "{gimp,wls2}; do
        # shellcheck disable=SC2086 # words
        "$@" build/mpmlab run $words --cells 8 --threads 1 | tail -n 1 | cut -d, -f1-17,21-28
    done
}
agree() { # FILE FILE: the largest difference of their numbers, relative (absolute below 1e-10), or what else differs
    paste -d '\n' "$1" "$2" | awk -F, '
        !/,ok,/ { print "a run is lost"; wrong = 1; exit }
        NR % 2 { n = split($0, a); next }
        NF != n { print "rows unlike"; wrong = 1; exit }
        { for (k = 1; k <= NF; k++) {
            if (a[k] == $k) continue
            if (a[k] !~ /^[-+.0-9]/ || $k !~ /^[-+.0-9]/) { print "column " k ": " a[k] " and " $k; wrong = 1; exit }
            d = a[k] - $k; m = (a[k] > 0 ? a[k] : -a[k]); if (m < 1e-10) m = 1
            if (d < 0) d = -d
            if (d / m > most) most = d / m } }
        END { if (wrong) exit 1; printf "%d rows of ring and bar within %.1g", NR / 2, most; exit !(NR > 1 && most < 1e-10) }'
}

wrong=0
result=
figures=-
try inside "make CC=$compiler deps"
try inside "make -k -j$(nproc) CC=$compiler all"
build=$result
version=$(chroot "$root" "$compiler" --version | head -n 1 | grep -oE '[0-9]+(\.[0-9]+)+' | head -n 1)
if [ "$arch" = "$own" ]; then
    try inside "make CC=$compiler deps test"
    tests="$result: $(awk '$1 == "asserts" { n += $4; bad += $5 }
        /^SKIPPED/ { skipped++ } END { printf "%d asserts, %d failed, %d SKIPPED", n, bad, skipped }' "$log")"
    try inside "make CC=$compiler deps figures QUICK=$quick"
    figures="$result: $(find "$root/mpmlab/build/out" -name '*.svg' 2>/dev/null | wc -l)"
else
    try inside "make -j$(nproc) CC=$compiler build/tests/fem && cd build/tests && ./fem"
    tests="fem: $result"
    (cd "$here" && make -s -j"$(nproc)" all) >>"$log" 2>&1 || die "no build here to compare with"
    (cd "$here" && rows env) >"$log.own"
    rows chroot "$root" env -C /mpmlab >"$log.rows" 2>>"$log"
    tests="$tests; $(agree "$log.own" "$log.rows")" || wrong=1
fi
warnings=$(grep -c 'warning:' "$log")
[ "$warnings" -eq 0 ] || wrong=1
echo "| $release $arch | $compiler ${version:-none} | $build | $warnings | $tests | $figures |"
exit $wrong
