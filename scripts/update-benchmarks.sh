#!/usr/bin/env bash
# Measures this machine and writes benchmarks/results/MACHINE/: tables (CSV) and their pictures.
set -euo pipefail
usage='usage: scripts/update-benchmarks.sh [OPTION...] [ROWS...]
  ROWS            family threads flights missions opponents; default: all of them
  --full          the long form: 100 steps, 5 repeats, flights of 10 segments a piece, the capture
                  mission; without it some six minutes on an idle machine
  --machine NAME  folder of the results (default: made from the processor and the host)
  --no-install    do not look for missing Debian packages
  --build DIR     programs that are already built (default: build/bench, which is built)
Leave the machine idle. One thread computes but where rows are about two. The results of the rows
that are not asked for stay; the pictures are drawn again from all.'

full=no machine='' build='' install_options=()
rows=()
while [ $# -gt 0 ]; do
  case "$1" in
    --full) full=yes ;;
    --machine) [ $# -ge 2 ] || { printf '%s\n' "$usage" >&2; exit 2; }; machine="$2"; shift ;;
    --build) [ $# -ge 2 ] || { printf '%s\n' "$usage" >&2; exit 2; }; build="$2"; shift ;;
    --no-install) install_options=(no) ;;
    -h | --help) printf '%s\n' "$usage"; exit 0 ;;
    family | threads | flights | missions | opponents) rows+=("$1") ;;
    *) printf 'update-benchmarks.sh: unknown argument %s\n%s\n' "$1" "$usage" >&2; exit 2 ;;
  esac
  shift
done
[ ${#rows[@]} -gt 0 ] || rows=(family threads flights missions opponents)

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
cd -- "$root"
if [ -z "$build" ]; then
  build=build/bench
  [ ${#install_options[@]} -gt 0 ] || scripts/install-packages.sh
  opponents=OFF
  case " ${rows[*]} " in *" opponents "*) opponents=ON ;; esac
  cmake --preset release -B "$build" -DRETIARIUS_OPPONENTS="$opponents" -DRETIARIUS_TESTS=OFF \
    --log-level=NOTICE
  targets=(retiarius_program)
  [ "$opponents" = OFF ] || targets+=(retiarius-bench)
  cmake --build "$build" --parallel "$(nproc)" --target "${targets[@]}"
fi
program="$build/program/retiarius"

if [ -z "$machine" ]; then
  model="$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo 2>/dev/null | head -n 1)"
  machine="$(printf '%s' "${model:-$(uname -m)}" | tr -cs 'A-Za-z0-9\n' '-' | sed 's/^-//; s/-$//' |
    tr '[:upper:]' '[:lower:]')"
fi
results="benchmarks/results/$machine"
mkdir -p -- "$results"
# One thread for the opponents too: CHOLMOD's loops heed only the second.
export OPENBLAS_NUM_THREADS=1 OMP_THREAD_LIMIT=1

long() { [ "$full" = yes ]; }

family() {
  options=(--repeats 3)
  long && options=()
  "$program" bench family --threads 1 --csv "$results/step-time.csv" "${options[@]}"
  cp -- "$results/step-time.csv" benchmarks/results/step-time.csv  # what the verification draws
}

threads() {
  options=(--steps 20 --repeats 1)
  long && options=()
  "$program" bench threads --csv "$results/threads.csv" "${options[@]}"
}

flights() {
  options=(--segments '2,4')
  long && options=(--segments '2,4,10' --references)
  "$program" bench flights --threads 1 --csv "$results/flights.csv" "${options[@]}"
}

# One file of several missions: the heading of the first, a line each.
# shellcheck disable=SC2094  # the test of the size comes before the writing
missions() {
  part="$results/missions.part"
  : >"$results/missions.csv"
  mission() {
    "$program" bench mission --csv "$part" "$@"
    if [ -s "$results/missions.csv" ]; then tail -n 1 -- "$part"; else cat -- "$part"; fi \
      >>"$results/missions.csv"
    rm -f -- "$part"
  }
  mission --threads 1 --mission missions/stiff-capture.toml --set integrator.method=auto
  if long; then
    mission --threads 1 --mission missions/stiff-capture.toml
    mission --threads 2 --mission missions/capture.toml
  fi
}

opponents() {
  options=('--benchmark_filter=step|flight/.*segments:(2|4)')
  long && options=()
  "$build/benchmarks/opponents/retiarius-bench" --benchmark_out="$results/opponents.csv" \
    --benchmark_out_format=csv "${options[@]}"
}

for row in "${rows[@]}"; do
  printf '\n%s\n' "$row"
  "$row"
done
/usr/bin/python3 benchmarks/plot_results.py "$results"
printf '\nWritten: %s\n' "$results"
