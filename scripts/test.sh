#!/usr/bin/env bash
# Installs what is missing, builds with warnings as errors, and runs every test.
set -euo pipefail
usage='usage: scripts/test.sh [--preset ci|asan|debug|release] [--no-install] [-- CTEST OPTION...]
  --preset NAME  what to build and test, in build/NAME (default: ci; asan leaves out slow tests)
  --no-install   do not look for missing Debian packages
  -- ...         further options of ctest, such as -R net or -LE slow'

preset=ci
build_options=()
while [ $# -gt 0 ]; do
  case "$1" in
    --preset) [ $# -ge 2 ] || { printf '%s\n' "$usage" >&2; exit 2; }; preset="$2"; shift ;;
    --preset=*) preset="${1#--preset=}" ;;
    --no-install) build_options+=("$1") ;;
    -h | --help) printf '%s\n' "$usage"; exit 0 ;;
    --) shift; break ;;
    *) printf 'test.sh: unknown option %s\n%s\n' "$1" "$usage" >&2; exit 2 ;;
  esac
  shift
done

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
cd -- "$root"
scripts/build.sh --preset "$preset" "${build_options[@]}"
exec ctest --preset "$preset" --parallel "$(nproc)" "$@" </dev/null
