#!/usr/bin/env bash
# A Slurm cluster of one node on this machine, for tests of job scripts: munged, slurmctld and slurmd of Debian's slurm-wlm,
# all below FOLDER, without systemd and without changing /etc. Needs root.
# Usage: tools/scripts/slurm/cluster.sh start FOLDER     prints a line to be evaluated: export SLURM_CONF=...
#        tools/scripts/slurm/cluster.sh stop FOLDER
# Status 77 and the reason where such a cluster cannot run.
set -euo pipefail

skip() {
  printf 'slurm: skipped: %s\n' "$*" >&2
  exit 77
}
usage() { sed -n '4,6s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
[[ $# == 2 && ($1 == start || $1 == stop) ]] || usage
folder=$(realpath -m "$2")

stop() {
  local name pid
  for name in slurmd slurmctld munged; do
    [[ -s $folder/$name.pid ]] || continue
    pid=$(<"$folder/$name.pid")
    kill "$pid" 2>/dev/null || continue
    for ((i = 0; i < 100; ++i)); do
      kill -0 "$pid" 2>/dev/null || break
      sleep 0.1
    done
    kill -9 "$pid" 2>/dev/null || true
  done
}
if [[ $1 == stop ]]; then
  stop
  exit 0
fi

for program in munged slurmctld slurmd sbatch scontrol; do
  command -v "$program" >/dev/null || skip "found no $program, wanted Debian's slurm-wlm and munge (tools/setup.sh --with slurm)"
done
((EUID == 0)) || skip "found user $(id -un), wanted root: slurmd starts jobs as other users"

mkdir -p "$folder"/{state,spool,log}
chmod 755 "$folder"
(umask 077; head -c 1024 /dev/urandom >"$folder/munge.key")
# Ports of this folder's own, so that a cluster of the machine goes on undisturbed.
port=$((20000 + $(cksum <<<"$folder" | cut -d' ' -f1) % 20000))
host=$(hostname -s)
cat >"$folder/slurm.conf" <<CONF
ClusterName=tumble_test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$folder/munge.sock
CryptoType=crypto/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=2,bf_interval=2,batch_sched_delay=1,sched_min_interval=100000
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/filetxt
JobCompLoc=$folder/jobs.txt
JobAcctGatherType=jobacct_gather/none
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd.log
MaxArraySize=10001
MaxJobCount=20000
MinJobAge=86400
RequeueExit=75
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm.conf

fail() {
  stop
  skip "$1; $(tail -n 3 "$2" 2>/dev/null | tr '\n' ' ')"
}
munged --force --key-file="$folder/munge.key" --socket="$folder/munge.sock" --pid-file="$folder/munged.pid" \
  --log-file="$folder/log/munged.log" --seed-file="$folder/munge.seed" --num-threads=2 >"$folder/log/munged.out" 2>&1 ||
  fail "munged does not start" "$folder/log/munged.out"
slurmctld >"$folder/log/slurmctld.out" 2>&1 || fail "slurmctld does not start" "$folder/log/slurmctld.out"
slurmd >"$folder/log/slurmd.out" 2>&1 || fail "slurmd does not start" "$folder/log/slurmd.out"
for ((i = 0; i < 150; ++i)); do
  state=$(sinfo -h -o %T 2>/dev/null || true)
  if [[ $state == idle ]]; then
    printf 'export SLURM_CONF=%q\n' "$SLURM_CONF"
    exit 0
  fi
  sleep 0.2
done
fail "the node is ${state:-not known} after 30 s, wanted idle" "$folder/log/slurmctld.log"
