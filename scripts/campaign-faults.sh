#!/usr/bin/env bash
# Disturbs a campaign: kills workers, coordinators and MPI ranks at random, fills its file system,
# and makes its files unreadable; then compares its database with that of an undisturbed one.
set -euo pipefail
usage='usage: scripts/campaign-faults.sh [--kills N] [--seed N] [PROGRAM]
  --kills N  how many processes are killed (default: 100)
  --seed N   of the random choices (default: 1)
  PROGRAM    the retiarius to test (default: build/ci/program/retiarius)
Needs python3, and root for the small file system.'

kills=100 seed=1
while [ $# -gt 0 ]; do
  case "$1" in
    --kills) kills="$2"; shift ;;
    --seed) seed="$2"; shift ;;
    -h | --help) printf '%s\n' "$usage"; exit 0 ;;
    -*) printf 'campaign-faults.sh: unknown option %s\n%s\n' "$1" "$usage" >&2; exit 2 ;;
    *) break ;;
  esac
  shift
done
root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
program="$(realpath -- "${1:-$root/build/ci/program/retiarius}")"
work="$(mktemp -d)"
cleanup() { umount "$work/small" 2>/dev/null || true; rm -rf -- "$work"; }
trap cleanup EXIT
cd "$work"

cp "$root/tests/campaign/small-mission.toml" m.toml
cat >c.toml <<'CAMPAIGN'
mission = "m.toml"
set = 'phase[0].until = "time >= 0.1"'
[plan]
design = "sobol"
runs = 6000
seed = 1
[[variable]]
set = "target.position[0]"
distribution = "uniform"
low = -0.3
high = 0.3
[limits]
attempts = 1000
CAMPAIGN

run="$program campaign run c.toml --quiet"
$run --out whole --jobs 2
$program campaign collect c.toml --out whole --csv whole.csv >/dev/null
# Runs that fail are all alike: equal rows of these would show little.
finished="$(grep -c ',finished,' whole.csv || true)"
if [ "$finished" -lt 5400 ]; then
  printf 'campaign-faults.sh: no more than %s of 6000 runs finished\n' "$finished" >&2
  exit 1
fi
has_mpi=no
if command -v mpirun >/dev/null && $program --version | grep -q 'MPI  *Open MPI'; then has_mpi=yes; fi

# Every other round under mpirun; in each, some workers die, then the coordinator, a rank or mpirun.
python3 - "$program" "$kills" "$seed" "$has_mpi" <<'PYTHON'
import os, random, signal, subprocess, sys, time
program, kills, seed, mpi = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4] == "yes"
random.seed(seed)
environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
command = [program, "campaign", "run", "c.toml", "--quiet", "--out", "hurt"]

def children(pid):
    try:
        return [int(c) for c in open(f"/proc/{pid}/task/{pid}/children").read().split()]
    except OSError:
        return []

def kill(pid):
    try:
        os.kill(pid, signal.SIGKILL)
        return 1
    except ProcessLookupError:
        return 0

count = {"worker": 0, "coordinator": 0, "rank": 0, "mpirun": 0}
rounds = 0
while sum(count.values()) < kills:
    rounds += 1
    ranks = mpi and rounds % 2 == 0
    args = ["mpirun", "--oversubscribe", "-n", "3"] + command if ranks else command + ["--jobs", "2"]
    main = subprocess.Popen(args, env=environment, stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL)
    for _ in range(random.randint(1, 3)):
        time.sleep(random.uniform(0.1, 0.4))
        coordinators = children(main.pid) if ranks else [main.pid]
        workers = [w for c in coordinators for w in children(c)]
        if workers and sum(count.values()) < kills:
            count["worker"] += kill(random.choice(workers))
    if sum(count.values()) < kills and main.poll() is None:
        coordinators = children(main.pid) if ranks else []
        if coordinators and random.random() < 0.7:
            count["rank"] += kill(random.choice(coordinators))
        else:
            count["mpirun" if ranks else "coordinator"] += kill(main.pid)
            for left in coordinators:  # what mpirun leaves behind, ends by itself or is ended
                kill(left)
    try:
        if main.wait(timeout=120) == 0 and sum(count.values()) < kills:
            print("all runs were done before the kills were", file=sys.stderr)
            sys.exit(1)
    except subprocess.TimeoutExpired:
        main.kill()
        print("the campaign hangs", file=sys.stderr)
        sys.exit(1)
print("killed:", ", ".join(f"{n} {what}s" for what, n in count.items()))
PYTHON
$program campaign resume c.toml --out hurt --jobs 2 --quiet
$program campaign collect c.toml --out hurt --csv hurt.csv >/dev/null
cmp whole.csv hurt.csv
printf 'kills: nothing lost, nothing twice, rows as undisturbed\n'

# A full file system: a clear error, what is done is intact, and it goes on once there is room.
mkdir small
if mount -t tmpfs -o size=256k tmpfs small 2>/dev/null; then
  if $run --out small/o --jobs 2 2>full.err; then printf 'a full disk went unnoticed\n' >&2; exit 1; fi
  grep -qi 'full' full.err || { cat full.err >&2; exit 1; }
  $program campaign status c.toml --out small/o
  mount -o remount,size=64m small
  $run --out small/o --jobs 2
  $program campaign collect c.toml --out small/o --csv full.csv >/dev/null
  cmp whole.csv full.csv
  umount small
  printf 'full disk: %s; rows as undisturbed after it\n' "$(head -c 300 full.err)"
else
  printf 'full disk: skipped, no file system can be mounted here\n'
fi

# A shard that is torn or unreadable is named.
cp -r whole torn
shard="$(ls torn/shards/*.sqlite | head -n 1)"
printf 'nothing of a database, whatever its name may say' >"$shard"
rm -f "$shard-journal"
if $program campaign collect c.toml --out torn 2>torn.err; then exit 1; fi
grep -q "$shard" torn.err
rm "$shard"
$run --out torn --jobs 2
$program campaign collect c.toml --out torn --csv torn.csv >/dev/null
cmp whole.csv torn.csv
printf 'torn shard: named; its runs were done again\n'
