#!/usr/bin/env bash
# Builds the fuzz targets with clang and runs them one after another, each on one core.
set -euo pipefail
usage='usage: scripts/fuzz.sh [SECONDS | RUNSx] [TARGET...]
  SECONDS  of each target (default: 60)
  RUNSx    executions of each target instead, such as 100000x
  TARGET   such as mission or stl (default: all)
What libFuzzer finds worth keeping goes to build/fuzz/found/TARGET, crashes to build/fuzz/crashes.
A crash: build/fuzz/fuzz/fuzz_TARGET FILE repeats it.'

limit=60
case "${1:-}" in
  -h | --help) printf '%s\n' "$usage"; exit 0 ;;
  [0-9]*) limit="$1"; shift ;;
esac
case "$limit" in
  *[!0-9x]* | x* | *x?*) printf 'fuzz.sh: %s is no limit\n%s\n' "$limit" "$usage" >&2; exit 2 ;;
  *x) bound="-runs=${limit%x}" ;;
  *) bound="-max_total_time=$limit" ;;
esac

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
cd -- "$root"
cmake --preset fuzz --log-level=NOTICE
cmake --build --preset fuzz
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
  for program in build/fuzz/fuzz/fuzz_*; do
    [ -x "$program" ] && [ -f "$program" ] && targets+=("${program##*/fuzz_}")
  done
fi

# Inputs that the project has anyway, and the words of the target's language.
seeds() {
  case "$1" in
    mission) find missions -maxdepth 1 -name '*.toml' ;;
    campaign) find missions/campaigns -name '*.toml' 2>/dev/null || true ;;
    network) find tests/net/data -name '*.net' ;;
    obj) find missions -maxdepth 1 -name '*.obj' ;;
  esac
}
dictionary() {
  case "$1" in
    mission | campaign | override | trigger) printf 'fuzz/mission.dict' ;;
    network | obj | stl) printf 'fuzz/shapes.dict' ;;
    *) printf 'fuzz/records.dict' ;;
  esac
}

mkdir -p build/fuzz/crashes
failed=()
for target in "${targets[@]}"; do
  found="build/fuzz/found/$target"
  own="build/fuzz/seeds/$target"
  mkdir -p "$found" "$own" "fuzz/corpus/$target"
  seeds "$target" | while read -r file; do cp -- "$file" "$own/"; done
  log="build/fuzz/$target.log"
  # Input above 4 kB and allocations above 512 MB are no input of this kind; one that takes longer
  # than 10 s hangs.
  if nice -n 19 "build/fuzz/fuzz/fuzz_$target" "$bound" -max_len=4096 -timeout=10 \
    -malloc_limit_mb=512 -rss_limit_mb=2048 -print_final_stats=1 \
    -dict="$(dictionary "$target")" -artifact_prefix="build/fuzz/crashes/$target-" \
    "$found" "fuzz/corpus/$target" "$own" >"$log" 2>&1; then
    sed -n 's/^stat::number_of_executed_units: *\([0-9]*\)/\1 executions/p' "$log" |
      sed "s/^/$target: /"
  else
    failed+=("$target")
    printf '%s: failed, see %s\n' "$target" "$log" >&2
    grep -m1 -E 'ERROR: |terminate|what\(\)|runtime error' "$log" >&2 || true
  fi
done
if [ ${#failed[@]} -gt 0 ]; then
  printf 'fuzz.sh: failed: %s\n' "${failed[*]}" >&2
  exit 1
fi
