# shellcheck shell=bash
# checks.sh: what the tests in shell share; sourced by them. The program under test is $program; the last
# line of each is `verdict`.
passed=0
failed=0

# ok NAME COMMAND...: the command must succeed.
ok() {
    local name=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $name" >&2
    fi
}
# run ARGUMENT...: leaves status, and files out and err.
run() {
    # shellcheck disable=SC2154 # the caller's
    "$program" "$@" >out 2>err
    status=$?
}
lines() { wc -l <"$1"; }
# untimed CSV: the table without its timing columns, which come last.
untimed() { sed 's/\(,[^,]*\)\{4\}$//' "$1"; }
# timeless CSV: a row as `run` prints it, without its timing columns.
timeless() { cut -d, -f1-17,21-28 "$1"; }
same() { cmp -s <(untimed "$1") <(untimed "$2"); }
# failed_well NAME STATUS TEXT: the last `run` must have left this exit status and one line on err with TEXT.
failed_well() {
    ok "$1: status $status, $(head -n 3 err)" test "$status" -eq "$2" -a "$(lines err)" -eq 1
    ok "$1: says '$3', not $(head -n 3 err)" grep -qF -- "$3" err
}
# refused NAME STATUS TEXT ARGUMENT...: that status, no output, one line with the text in it.
refused() {
    local name=$1 want=$2 text=$3
    shift 3
    run "$@"
    failed_well "$name" "$want" "$text"
    ok "$name: no output" test ! -s out
}
# verdict [NAME]: prints the counts; false if anything failed.
verdict() {
    echo "${1:+$1: }$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}
