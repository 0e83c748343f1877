#!/usr/bin/env bash
# Runs every verification case in its full form and writes docs/verification.md and its figures.
set -euo pipefail
usage='usage: scripts/update-verification.sh [--no-install] [-- VERIFY OPTION...]
  --no-install  do not look for missing Debian packages
  -- ...        further options of retiarius verify, such as --threads 2
The page itself is left in out/verification/verification.html. Where a case misses its bound nothing
in docs/ changes, and the exit code is 1.'

build_options=()
while [ $# -gt 0 ]; do
  case "$1" in
    --no-install) build_options+=("$1") ;;
    -h | --help) printf '%s\n' "$usage"; exit 0 ;;
    --) shift; break ;;
    *) printf 'update-verification.sh: unknown option %s\n%s\n' "$1" "$usage" >&2; exit 2 ;;
  esac
  shift
done

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
cd -- "$root"
scripts/build.sh --preset release --target retiarius_program "${build_options[@]}"

out=out/verification
rm -rf -- "$out/figures"
# The portable kernels give the same digits on every processor.
build/release/program/retiarius verify --kernels portable --out "$out" "$@" </dev/null

rm -rf -- docs/verification
mkdir -p docs/verification
cp -- "$out"/figures/*.svg docs/verification/
sed 's|](figures/|](verification/|' "$out/verification.md" >docs/verification.md
printf 'Written: %s\n' docs/verification.md
