#!/usr/bin/env bash
# Installs what is missing, builds, and runs the whole capture mission into out/capture/.
set -euo pipefail
usage='usage: scripts/demo.sh [--no-install] [-- RUN OPTION...]
  --no-install  do not look for missing Debian packages
  -- ...        further options of retiarius run, such as --threads 4
Results go to out/capture/, or to out/capture-2/, out/capture-3/ ... where that exists.'

build_options=()
while [ $# -gt 0 ]; do
  case "$1" in
    --no-install) build_options+=("$1") ;;
    -h | --help) printf '%s\n' "$usage"; exit 0 ;;
    --) shift; break ;;
    *) printf 'demo.sh: unknown option %s\n%s\n' "$1" "$usage" >&2; exit 2 ;;
  esac
  shift
done

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
cd -- "$root"
scripts/build.sh --preset release --target retiarius_program "${build_options[@]}"

# Results of earlier calls stay.
out=out/capture
number=1
while [ -e "$out" ]; do
  number=$((number + 1))
  out="out/capture-$number"
done
mkdir -p out

status=0
build/release/program/retiarius run missions/capture.toml --out "$out" "$@" </dev/null || status=$?
if [ -e "$out/report.html" ]; then
  printf 'Results: %s\nReport:  %s\n' "$root/$out" "$root/$out/report.html"
else
  printf 'demo.sh: the run left no report (exit code %d).\n' "$status" >&2
  [ "$status" -ne 0 ] || status=1
fi
exit "$status"
