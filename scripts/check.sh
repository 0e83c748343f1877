#!/usr/bin/env bash
# The checks that a change passes before it is offered: the order of the house, the format, and
# clang-tidy. Needs clang-format and clang-tidy (Debian: apt-get install clang-format clang-tidy).
set -euo pipefail
usage='usage: scripts/check.sh [--no-tidy] [FILE...]
  --no-tidy  leave out clang-tidy, which takes minutes
  FILE...    C++ files to look at (default: every one in git)'

tidy=yes
files=()
while [ $# -gt 0 ]; do
  case "$1" in
    --no-tidy) tidy=no ;;
    -h | --help) printf '%s\n' "$usage"; exit 0 ;;
    -*) printf 'check.sh: unknown option %s\n%s\n' "$1" "$usage" >&2; exit 2 ;;
    *) files+=("$(realpath -- "$1")") ;;
  esac
  shift
done

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
cd -- "$root"
if [ ${#files[@]} -eq 0 ]; then
  mapfile -d '' -t files < <(git ls-files -z --cached --others --exclude-standard '*.cpp' '*.hpp')
fi
failed=()

cmake -D "SOURCE_DIR=$root" -P tests/architecture/check.cmake || failed+=("order of the house")
clang-format --dry-run -Werror "${files[@]}" || failed+=("format (run clang-format -i)")

if [ "$tidy" = yes ]; then
  cmake --preset ci --log-level=NOTICE
  # Headers are seen through the sources that include them.
  sources=()
  for file in "${files[@]}"; do
    [[ "$file" == *.cpp && "$file" != */install/* ]] && sources+=("$file")
  done
  # Sources include a generated header.
  cmake --build --preset ci --target retiarius_revision >/dev/null
  printf '%s\0' "${sources[@]}" |
    xargs -0 -r -n 1 -P "$(nproc)" clang-tidy -p build/ci --quiet 2> >(grep -v 'warnings generated' >&2) ||
    failed+=("clang-tidy")
fi

if [ ${#failed[@]} -gt 0 ]; then
  printf 'check.sh: failed: %s\n' "${failed[@]}" >&2
  exit 1
fi
printf 'check.sh: all checks passed\n'
