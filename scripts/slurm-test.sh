#!/usr/bin/env bash
# Runs a small campaign through a real Slurm on this machine (munged, slurmctld and two slurmd, each
# a node), kills and requeues a task, and compares the database with that of a local run.
# Needs slurm-wlm and munge (Debian), and root.
set -euo pipefail
usage='usage: scripts/slurm-test.sh [PROGRAM]
  PROGRAM  the retiarius to test (default: build/ci/program/retiarius)'
case "${1:-}" in -h | --help) printf '%s\n' "$usage"; exit 0 ;; esac

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
program="$(realpath -- "${1:-$root/build/ci/program/retiarius}")"
for needed in munged slurmctld slurmd sbatch squeue scontrol; do
  command -v "$needed" >/dev/null || { printf 'slurm-test.sh: skipped: there is no %s\n' "$needed"; exit 77; }
done

work="$(mktemp -d)"
chmod 755 "$work"
pids=()
cleanup() {
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  for pid in "${pids[@]}"; do
    for _ in $(seq 50); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
  done
  rm -rf -- "$work"
}
trap cleanup EXIT
wait_for() { # DESCRIPTION COMMAND...: until it succeeds, five minutes at most
  local what="$1"; shift
  for _ in $(seq 3000); do "$@" >/dev/null 2>&1 && return; sleep 0.1; done
  printf 'slurm-test.sh: %s did not come about\n' "$what" >&2
  tail -n 20 "$work"/*.log >&2 || true
  exit 1
}

# munge: a key and a socket of its own.
mkdir "$work/munge"
dd if=/dev/urandom of="$work/munge/key" bs=128 count=1 status=none
chmod 400 "$work/munge/key"
chmod 755 "$work/munge"
if id munge >/dev/null 2>&1; then chown -R munge "$work/munge"; fi
munge_options=(--foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket"
  --pid-file="$work/munge/pid" --log-file="$work/munge/log" --seed-file="$work/munge/seed")
if id munge >/dev/null 2>&1; then
  setpriv --reuid=munge --regid=munge --clear-groups munged "${munge_options[@]}" &
else
  munged "${munge_options[@]}" &
fi
pids+=($!)
wait_for "munge's socket" test -S "$work/munge/socket"

host="$(hostname)"
cat >"$work/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=17000
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
SchedulerParameters=bf_interval=1,requeue_setup_env_fail
StateSaveLocation=$work/state
SlurmctldPidFile=$work/slurmctld.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdPidFile=$work/slurmd-%n.pid
SlurmdLogFile=$work/slurmd-%n.log
SlurmdSpoolDir=$work/spool-%n
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=[17001-17002] CPUs=2
PartitionName=all Nodes=n[1-2] Default=YES MaxTime=60 State=UP
CONF
mkdir "$work/state" "$work/spool-n1" "$work/spool-n2"
export SLURM_CONF="$work/slurm.conf"
slurmctld -D -f "$work/slurm.conf" >/dev/null 2>&1 &
pids+=($!)
for node in n1 n2; do
  slurmd -D -N "$node" -f "$work/slurm.conf" >/dev/null 2>&1 &
  pids+=($!)
done
both_idle() { [ "$(sinfo -h -N -o '%t' | grep -c idle)" = 2 ]; }
wait_for "two idle nodes" both_idle

# Runs of a fifth of a second: long enough for a task to be caught at work.
cp "$root/tests/campaign/small-mission.toml" "$work/m.toml"
cat >"$work/c.toml" <<'CAMPAIGN'
mission = "m.toml"
set = ["net.mesh = 0.125", 'contact.method = "modified-mass"', 'phase[0].until = "time >= 0.8"']
[plan]
design = "sobol"
runs = 60
seed = 1
[[variable]]
set = "target.position[0]"
distribution = "uniform"
low = -0.3
high = 0.3
[[variable]]
set = "target.spin_deg"
distribution = "cone"
half_angle_deg = 90
length = 100
CAMPAIGN

cd "$work"
"$program" campaign run c.toml --jobs 2 --out local --quiet
"$program" campaign run c.toml --out cluster --engine slurm --batch 15 --submit
# One task is killed as a failing node would, one is put back into the queue.
running() { squeue -h -t R | grep -q .; }
wait_for "a running task" running
sleep 1
job="$(squeue -h -t R -o '%i' | head -n 1)"
scontrol requeue "$job"
printf 'requeued %s\n' "$job"
task="$(squeue -h -t R -o '%i' | tail -n 1)"
if [ -n "$task" ] && scancel --signal=KILL --full "$task"; then printf 'killed %s\n' "$task"; fi
done_all() { ! squeue -h | grep -q .; }
wait_for "the end of all tasks" done_all
"$program" campaign status c.toml --out cluster
# A killed task is Slurm's to report; what it lacks is done by submitting again.
"$program" campaign run c.toml --out cluster --engine slurm --batch 15 --submit >/dev/null
sleep 1
wait_for "the end of all tasks" done_all
"$program" campaign collect c.toml --out cluster --csv cluster.csv
"$program" campaign collect c.toml --out local --csv local.csv
cmp local.csv cluster.csv
[ "$(wc -l <cluster.csv)" = 61 ]
# Runs that fail are all alike: equal rows of these would show little.
finished="$(grep -c ',finished,' cluster.csv || true)"
if [ "$finished" -lt 54 ]; then
  printf 'slurm-test.sh: no more than %s of 60 runs finished\n' "$finished" >&2
  exit 1
fi
printf 'slurm-test.sh: 60 runs on two nodes, equal to the local ones; %s finished\n' "$finished"
