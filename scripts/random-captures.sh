#!/usr/bin/env bash
# Runs random captures under the barrier and checks each for what must never be.
set -euo pipefail
usage='usage: scripts/random-captures.sh COUNT SEED [OPTION...]
  --program FILE  the built program (default: build/ci/program/retiarius)
  --first N       number of the first capture (default: 1)
  --limit SECONDS of processor time for one run (default: 600); 20 times as much by the clock
  --out DIR       missions, and results of runs that went wrong (default: out/random-captures-SEED)
  --self PERCENT  of captures have threads touch threads, which costs many times more (default: 10)
  --keep          keep the results of good runs too
Each capture (scripts/random_capture.py) is run with one thread at low priority. A run is good if
it finishes, or ends with a clear error, and `retiarius check-contact` finds nothing in its frames.
Prints one line a run and a summary; ends with 1 if any run was bad.'

fail() { printf 'random-captures.sh: %s\n%s\n' "$1" "$usage" >&2; exit 2; }
root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
program="$root/build/ci/program/retiarius"
first=1 limit=600 own=10 keep='' out=''
case "${1:-}" in -h | --help) printf '%s\n' "$usage"; exit 0 ;; esac
[ $# -ge 2 ] || fail 'COUNT and SEED are needed'
count="$1" seed="$2"
shift 2
while [ $# -gt 0 ]; do
  case "$1" in
    --keep) keep=yes; shift; continue ;;
    --program | --first | --limit | --self | --out) [ $# -ge 2 ] || fail "$1 needs a value" ;;
    *) fail "unknown option $1" ;;
  esac
  case "$1" in
    --program) program="$2" ;;
    --first) first="$2" ;;
    --limit) limit="$2" ;;
    --self) own="$2" ;;
    --out) out="$2" ;;
  esac
  shift 2
done
for number in "$count" "$seed" "$first" "$limit" "$own"; do
  [[ $number =~ ^[0-9]+$ ]] || fail "$number is no whole number"
done
[ -x "$program" ] || fail "$program cannot be run"
out="${out:-out/random-captures-$seed}"
mkdir -p -- "$out"

# Without the checker a run is only good for having ended.
checks=''
"$program" --help | grep "^ *check-contact " >/dev/null && checks=yes
[ -n "$checks" ] || echo 'This program has no check-contact: runs are not checked.'

good=0 bad=0 refused=0
printf '%6s %6s %7s %6s %5s %5s %8s %7s  %s\n' \
  number nodes step speed frict self radius 'cpu s' outcome
last=$((first + count - 1))
for ((number = first; number <= last; ++number)); do
  folder="$out/$number"
  rm -rf -- "$folder"
  share="$(awk -v percent="$own" 'BEGIN { print percent / 100 }')"
  # shellcheck disable=SC2086  # The fifth argument is there or not.
  read -r nodes step speed friction self radius < <(
    python3 "$root/scripts/random_capture.py" "$folder" "$seed" "$number" "$share" ${checks:+every-step})
  code=0
  (
    ulimit -t "$limit"
    status=0
    nice -n 19 timeout --kill-after=60 $((20 * limit)) "$program" run \
      "$folder/mission.toml" --threads 1 --out "$folder/run" >"$folder/log" 2>&1 </dev/null ||
      status=$?
    times >"$folder/time"  # the last line is that of the children: user, system
    exit "$status"
  ) || code=$?
  took="$(awk 'END { split($1, part, "[ms]"); printf "%.1f", 60 * part[1] + part[2] }' "$folder/time")"
  case "$code" in
    0) outcome=finished ;;
    1) outcome='clear error' ;;
    137 | 152) outcome="SLOWER THAN $limit s" ;;
    124) outcome='HANGS' ;;
    *) outcome="EXIT CODE $code" ;;
  esac
  if [ "$code" -eq 1 ] && ! grep -q 'error' "$folder/log"; then outcome='FAILED WITHOUT A WORD'; fi
  if [ -n "$checks" ] && [ "$code" -le 1 ]; then
    check=0
    nice -n 19 "$program" check-contact "$folder/run" >"$folder/check" 2>&1 || check=$?
    case "$check" in
      0) outcome="$outcome, no violation" ;;
      1) outcome="$outcome, VIOLATIONS" ;;
      *) outcome="$outcome, CHECK FAILED" ;;
    esac
  fi
  printf '%6d %6d %7s %6s %5s %5s %8s %7s  %s\n' \
    "$number" "$nodes" "$step" "$speed" "$friction" "$self" "$radius" "$took" "$outcome"
  case "$outcome" in
    *[A-Z][A-Z]*) bad=$((bad + 1)); continue ;;
    'clear error'*) refused=$((refused + 1)); continue ;;
    *) good=$((good + 1)) ;;
  esac
  [ -n "$keep" ] || rm -rf -- "$folder/run"
done
printf '%d captures: %d finished well, %d ended with a clear error, %d went wrong (see %s)\n' \
  "$count" "$good" "$refused" "$bad" "$out"
[ "$bad" -eq 0 ]
