#!/usr/bin/env bash
# Installs what is missing, configures a preset and builds it with all processors.
set -euo pipefail
usage='usage: scripts/build.sh [--preset release|debug|asan|ci] [--target NAME] [--no-install]
  --preset NAME  what to build, into build/NAME (default: release)
  --target NAME  one target only, such as retiarius_program (default: all)
  --no-install   do not look for missing Debian packages'

preset=release
install=yes
target_options=()
while [ $# -gt 0 ]; do
  case "$1" in
    --preset) [ $# -ge 2 ] || { printf '%s\n' "$usage" >&2; exit 2; }; preset="$2"; shift ;;
    --preset=*) preset="${1#--preset=}" ;;
    --target) [ $# -ge 2 ] || { printf '%s\n' "$usage" >&2; exit 2; }; target_options=(--target "$2"); shift ;;
    --no-install) install=no ;;
    -h | --help) printf '%s\n' "$usage"; exit 0 ;;
    *) printf 'build.sh: unknown option %s\n%s\n' "$1" "$usage" >&2; exit 2 ;;
  esac
  shift
done

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
cd -- "$root"
[ "$install" = no ] || scripts/install-packages.sh

# A compiler process needs up to 1.5 GB.
jobs="$(nproc)"
memory_kb="$(awk '/^MemTotal:/ {print $2}' /proc/meminfo 2>/dev/null || true)"
if [ -n "$memory_kb" ]; then
  most=$((memory_kb / 1500000))
  [ "$most" -ge 1 ] || most=1
  [ "$jobs" -le "$most" ] || jobs="$most"
fi

cmake --preset "$preset" --log-level=NOTICE
cmake --build --preset "$preset" --parallel "$jobs" "${target_options[@]}"
