#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/slurm_workflow.sh [GONIOTOOL]: runs all workflows on three bundled materials through a Slurm of one node, kills two
# jobs in their middle, and compares the results with those of a local run byte for byte (as root, on Debian 12; some
# minutes). The Slurm has its own folder, ports and MUNGE socket; one that is already installed is neither used nor changed.
set -eu
# shellcheck source=scripts/setup.sh
. "$(dirname "$0")/setup.sh"
goniotool=$(realpath "${1:-$root/build/release/app/goniotool/goniotool}")
[ -x "$goniotool" ] || fail "$goniotool: not found; build it, or name it"
[ "$(id -u)" -eq 0 ] || fail "the daemons of Slurm need root"
for program in snakemake sbatch slurmctld slurmd munged; do
  command -v "$program" >/dev/null 2>&1 || { "$root/scripts/install_workflow_tools.sh" --slurm; break; }
done

folder=$(mktemp -d "${TMPDIR:-/tmp}/gonio-slurm.XXXXXX")
chmod 755 "$folder"
export SLURM_CONF=$folder/slurm.conf
node=gonio

stop() {
  local name process
  [ ! -e "$folder/slurmctld.pid" ] || scancel --quiet --user=root 2>/dev/null || true
  for name in slurmd slurmctld munged; do
    [ -e "$folder/$name.pid" ] || continue
    process=$(cat "$folder/$name.pid")
    while kill "$process" 2>/dev/null; do sleep 0.2; done
  done
}
trap stop EXIT

# wait_for SECONDS TEXT COMMAND ...: until the command succeeds.
wait_for() {
  local seconds=$1 text=$2
  shift 2
  for _ in $(seq $((seconds * 5))); do
    if "$@"; then return 0; fi
    sleep 0.2
  done
  fail "$text did not happen within $seconds s; logs are in $folder"
}

start_slurm() {
  local memory
  memory=$(awk '/MemAvailable/ {print int($2 / 1024)}' /proc/meminfo)
  mkdir "$folder/state" "$folder/spool"
  cat >"$SLURM_CONF" <<CONF
ClusterName=gonio
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmctldPort=36817
SlurmdPort=36818
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
KillWait=5
ReturnToService=2
NodeName=$node NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$memory
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
  (umask 077 && head -c 1024 /dev/urandom >"$folder/munge.key")
  munged --socket="$folder/munge.socket" --key-file="$folder/munge.key" --pid-file="$folder/munged.pid" \
    --log-file="$folder/munged.log" --seed-file="$folder/munged.seed"
  slurmctld -f "$SLURM_CONF"
  slurmd -f "$SLURM_CONF" -N "$node"
  wait_for 60 "starting the node" node_is_idle
  printf 'gonio: Slurm %s runs in %s: %s\n' "$(sinfo --version | cut -d' ' -f2)" "$folder" "$(sinfo --noheader)"
}

node_is_idle() { [ "$(sinfo --noheader --format=%t 2>/dev/null)" = idle ]; }

# run NAME PROFILE: all workflows in the folder NAME.
run() {
  mkdir "$folder/$1"
  (cd "$folder/$1" && exec snakemake -s "$root/workflows/Snakefile" --profile "$root/workflows/profiles/$2" \
    --configfile "$root/tests/workflows/small.yaml" --config goniotool="$goniotool" out=out \
    "materials=['library:sgd/chrome', 'library:sgd/blue-fabric', 'library:sgd/gold-metallic-paint']") >"$folder/$1.log" 2>&1
}

# running RULE: sets `job` to a job of the rule that has run for a few seconds.
running() {
  job=$(squeue --noheader --states=RUNNING --name="gonio-$1" --format="%A %M" |
    awk '{split($2, t, ":"); if (t[1] > 0 || t[2] >= 4) {print $1; exit}}')
  [ -n "$job" ]
}

start_slurm
run slurm slurm &
workflow=$!
wait_for 120 "a training" running train_fold
first=$job
scancel "$first"
printf 'gonio: the training that is job %s was cancelled\n' "$first"
still_running() { running train_fold && [ "$job" -gt "$first" ]; }
wait_for 120 "a second training" still_running
scancel --signal=KILL --full "$job"
printf 'gonio: the training that is job %s was killed\n' "$job"
wait "$workflow" || { tail -n 40 "$folder/slurm.log" >&2; fail "the workflow failed; logs are in $folder"; }
restarts=$(grep -c "Trying to restart job" "$folder/slurm.log" || true)
jobs=$(grep -c "Submitted job" "$folder/slurm.log")
[ "$restarts" -ge 2 ] || fail "the killed jobs were not repeated; logs are in $folder"
printf 'gonio: the workflow finished: %s jobs were submitted, of which %s repeated a killed one\n' "$jobs" "$restarts"

run local local || { tail -n 40 "$folder/local.log" >&2; fail "the local run failed"; }
diff -r --exclude=log --exclude=checkpoints "$folder/local/out" "$folder/slurm/out" || fail "the results differ: see $folder"
printf 'gonio: %s files are equal byte for byte to those of a local run\n' \
  "$(cd "$folder/slurm/out" && find . -type f ! -path './log/*' | wc -l)"
stop
rm -rf "$folder"
