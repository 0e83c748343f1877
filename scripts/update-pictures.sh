#!/usr/bin/env bash
# Makes the pictures in docs/pictures again: builds, simulates the whole capture (minutes), draws.
set -euo pipefail
usage='usage: scripts/update-pictures.sh [--no-install] [--run DIR]
  --no-install  do not look for missing Debian packages
  --run DIR     draw this run of missions/capture.toml in place of a new one'

build_options=()
run=
while [ $# -gt 0 ]; do
  case "$1" in
    --no-install) build_options+=("$1") ;;
    --run) [ $# -ge 2 ] || { printf '%s\n' "$usage" >&2; exit 2; }; run="$(realpath -- "$2")"; shift ;;
    -h | --help) printf '%s\n' "$usage"; exit 0 ;;
    *) printf 'update-pictures.sh: unknown option %s\n%s\n' "$1" "$usage" >&2; exit 2 ;;
  esac
  shift
done

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
cd -- "$root"
scripts/build.sh --preset release --target retiarius_program "${build_options[@]}"
program="$root/build/release/program/retiarius"
if [ -z "$run" ]; then
  folder="$(mktemp -d)"
  trap 'rm -rf -- "$folder"' EXIT
  run="$folder/capture"
  "$program" run missions/capture.toml --out "$run" </dev/null
fi
"$program" render "$run" --storyboard --size 1500x1000 --out docs/pictures/capture.png
