#!/bin/sh
# usage: slurm.sh FOLDER : runs a sweep as an array of jobs under Slurm, with the frobc on PATH; the
# table must be that of a single machine. Runs Slurm's two daemons as the current user, on the
# loopback interface; their output goes to FOLDER. Stops only these daemons.
#
# The host needs neither systemd nor munge nor cgroups, because slurm.conf names plugins that do
# without them. Such a Slurm trusts everyone who can connect to it, so it is for tests only.
set -eu
PATH=$PATH:/usr/sbin
if test -z "$(find /usr/lib -name auth_none.so)" || test -z "$(find /usr/lib -name cred_none.so)"; then
    echo "ok   a sweep as an array of jobs (left out: $(slurmctld -V) is without auth/none, cred/none)"
    exit 0
fi
mkdir -p "$1"
out=$(cd "$1" && pwd)
rm -rf "${out:?}"/*
mkdir "$out/state" "$out/spool" "$out/work"
user=$(id -un)
port=$((20000 + $$ % 20000))

cat >"$out/slurm.conf" <<CONF
ClusterName=frob
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
StateSaveLocation=$out/state
SlurmdSpoolDir=$out/spool
SlurmctldPidFile=$out/slurmctld.pid
SlurmdPidFile=$out/slurmd.pid
SlurmctldLogFile=$out/slurmctld.log
SlurmdLogFile=$out/slurmd.log
SlurmdParameters=config_overrides
NodeName=here NodeHostname=$(hostname) NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=here Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$out/slurm.conf"

daemons=
finish() {
    status=$?
    scancel --user="$user" >"$out/scancel.log" 2>&1 || true
    for daemon in $daemons; do kill "$daemon" 2>/dev/null || true; done
    wait
    if [ $status -ne 0 ]; then
        tail -n 20 "$out"/slurmctld.log "$out"/slurmd.log "$out"/work/*.told || true
        echo "FAIL a sweep as an array of jobs under Slurm; see $out"
    fi
    exit $status
}
trap finish EXIT
trap 'exit 1' INT TERM HUP

slurmctld -D >"$out/slurmctld.out" 2>&1 &
daemons="$daemons $!"
slurmd -D -N here >"$out/slurmd.out" 2>&1 &
daemons="$daemons $!"
for _ in $(seq 120); do
    sinfo --noheader --format=%T >"$out/sinfo" 2>&1 && grep -q '^idle$' "$out/sinfo" && break
    sleep 0.5
done
grep -q '^idle$' "$out/sinfo" || { echo "the node does not come up: $(cat "$out/sinfo")"; exit 1; }

cd "$out/work"
cat >follow.frob <<'FROB'
import Robot
import Trial
import WallFollow

param gap :: Distance = 0.3[m]

main :: (HasSonar i, DiffDrive o) => Program i o
main = reactimateRobot (wallFollow1 gap)

trial "keeps off" = Trial { world = "room.toml", lasts = 30[s], seeds = 1 `to` 200, judge = keepsOff }

keepsOff :: SF Truth Verdict
keepsOff = proc t -> neverTouches t where
    error = meanOf (t.clearance - gap)
FROB
cat >gaps.toml <<'PLAN'
program = "follow.frob"
robots = ["pioneer"]
[params]
gap = "0.2[m] to 0.4[m], 3 steps"
PLAN
frobc sweep gaps.toml --rows alone --table alone.csv >alone.told

# The job's number in the array selects its shard.
array() {
    timeout 300 sbatch --quiet --wait --array="$1" --output=job-%a.told \
        --wrap 'frobc sweep gaps.toml --jobs 1 --shard $SLURM_ARRAY_TASK_ID/8'
}

# A lost job must be reported; submitting the same array again must perform its runs and no others.
array 1-7
if frobc sweep gaps.toml --merge >merge.told 2>&1; then
    echo "a table although a shard is missing"
    exit 1
fi
grep -q '75 of 600 runs are missing' merge.told
array 1-8
frobc sweep gaps.toml --merge >merge.told
cmp gaps.csv alone.csv
test "$(cat gaps.rows/*.rows | wc -l)" -eq 600
echo "ok   a sweep as an array of jobs under $(slurmctld -V)"
