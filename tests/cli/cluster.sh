#!/usr/bin/env bash
# cluster.sh PROGRAM FOLDER: studies/README.md's lines for a study spread over hosts by GNU parallel and over a Slurm
# array, tried for real: parallel on this host, slurmd as the only node of a cluster of its own. Their tables
# must be those of a plain run. Prints "N passed, N failed"; what is not installed is SKIPPED. Daemons are
# stopped by the pids they wrote.
set -u
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$0")/checks.sh"
program=$(realpath "$1")
mkdir -p "$2"
work=$(mktemp -d "$(realpath "$2")/cluster.XXXXXX")
slurm=$work/slurm
study=(w07_13_sine_bar --quick --method "gimp,ge_gimp")
table=quick/w07_13_sine_bar.csv
finish() {
    for name in slurmd slurmctld munged; do
        [ -s "$slurm/$name.pid" ] && kill "$(cat "$slurm/$name.pid")"
    done 2>/dev/null
    for ((k = 0; k < 50; k++)); do # they take their pid files away as they end
        compgen -G "$slurm/*.pid" >/dev/null || break
        sleep 0.1
    done
    rm -rf "$work"
}
trap finish EXIT
trap 'exit 130' INT TERM
cd "$work" || exit 1

# collected NAME: the study's folder NAME has all rows, and they are the right ones
collected() {
    local before after
    before=$(find "$1" -path '*.collect/*.csv' | wc -l)
    ok "$1: one file per case: $before of $cases" test "$before" -eq "$cases"
    "$program" study "${study[@]}" --out "$1" --collect
    ok "$1: collect" cmp -s <(untimed "plain/$table") <(untimed "$1/$table")
    after=$(wc -l <"$1/quick/w07_13_sine_bar.rows")
    ok "$1: collect ran nothing again" test "$after" -eq "$cases"
}
"$program" study "${study[@]}" --out plain || exit 1
cases=$(($(wc -l <plain/$table) - 1))

if command -v parallel >/dev/null; then
    "$program" study "${study[@]}" --out hosts --list | parallel --will-cite -S 2/: --workdir "$PWD" >/dev/null
    ok "parallel: status" test "${PIPESTATUS[1]}" -eq 0
    collected hosts
else
    echo "SKIPPED parallel: not installed"
fi

slurm_start() {
    local host control=$((20000 + RANDOM % 20000))
    host=$(hostname -s)
    mkdir -p "$slurm"/{state,spool}
    chmod 755 "$work"
    install -d -o munge -g munge -m 755 "$slurm/munge"
    cat >"$slurm/slurm.conf" <<EOF
ClusterName=local
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$slurm/munge/munge.socket
SlurmctldPort=$control
SlurmdPort=$((control + 1))
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/spool
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.pid
SlurmctldLogFile=$slurm/slurmctld.log
SlurmdLogFile=$slurm/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
$(slurmd -C | head -n 1 | sed "s/^NodeName=[^ ]*/NodeName=$host NodeAddr=127.0.0.1/") State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
EOF
    runuser -u munge -- munged --socket="$slurm/munge/munge.socket" --pid-file="$slurm/munge/munged.pid" \
        --log-file="$slurm/munge/munged.log" --seed-file="$slurm/munge/munged.seed" || return 1
    ln -s munge/munged.pid "$slurm/munged.pid"
    export SLURM_CONF=$slurm/slurm.conf
    slurmctld -f "$SLURM_CONF" && slurmd -f "$SLURM_CONF" || return 1
    for ((k = 0; k < 100; k++)); do
        sinfo -h -o %T 2>/dev/null | grep -q idle && return 0
        sleep 0.2
    done
    return 1
}

if ! command -v slurmd >/dev/null || ! command -v munged >/dev/null; then
    echo "SKIPPED slurm: not installed"
elif [ "$(id -u)" -ne 0 ]; then
    echo "SKIPPED slurm: its daemons need root here"
elif ! slurm_start 2>"$work/slurm.err"; then
    echo "SKIPPED slurm: its daemons do not start here: $(tail -n 1 "$work/slurm.err")"
else
    "$program" study "${study[@]}" --out array --list >cases
    sbatch --wait --output=/dev/null --array=1-"$(wc -l <cases)" \
        --wrap 'eval "$(sed -n ${SLURM_ARRAY_TASK_ID}p cases)"' >sbatch.out
    ok "slurm: status" test $? -eq 0
    collected array
fi
verdict cluster
