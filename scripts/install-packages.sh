#!/usr/bin/env bash
# Installs the Debian packages of packages.txt that are missing, as root or through sudo; does
# nothing where all are there.
set -euo pipefail
here="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
# A line "PACKAGE unless COMMAND" names what may have come from elsewhere: it is installed only where
# there is no such command.
packages=()
while read -r package unless command; do
  [ -n "$package" ] || continue
  [ "$unless" = unless ] && command -v "$command" >/dev/null && continue
  packages+=("$package")
done <"$here/packages.txt"

fail() {
  printf 'install-packages: %s\n' "$@" >&2
  exit 1
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  fail "this system has no apt; the packages are named here as Debian 12 names them." \
    "Install what corresponds to: ${packages[*]}" \
    "then call the script again with --no-install."
fi

installed="$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null || true)"
missing=()
for package in "${packages[@]}"; do
  grep -qxF "installed $package" <<<"$installed" || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

command_by_hand="apt-get install --no-install-recommends ${missing[*]}"
as_root=(env DEBIAN_FRONTEND=noninteractive)
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null ||
    fail "packages are missing, and this is neither root nor is there sudo. As root, run:" \
      "$command_by_hand"
  # A password can be asked for at a terminal only.
  sudo=(sudo)
  [ -t 0 ] && [ -z "${CI:-}" ] || sudo+=(-n)
  "${sudo[@]}" true ||
    fail "packages are missing, and sudo refuses. As root, run:" "$command_by_hand"
  as_root=("${sudo[@]}" "${as_root[@]}")
fi

apt_options=(-qq -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0)
log="$(mktemp)"
trap 'rm -f -- "$log"' EXIT
printf 'Installing %s\n' "${missing[*]}"
# The package lists of a fresh machine may be absent or out of date; without network those that
# are there may still do.
"${as_root[@]}" apt-get "${apt_options[@]}" update </dev/null >"$log" 2>&1 ||
  { cat -- "$log" >&2; printf 'install-packages: the package lists could not be updated.\n' >&2; }
if ! "${as_root[@]}" apt-get "${apt_options[@]}" install -y --no-install-recommends \
    "${missing[@]}" </dev/null >"$log" 2>&1; then
  cat -- "$log" >&2
  fail "apt-get could not install the packages; its messages are above. As root, run:" \
    "$command_by_hand" \
    "Retiarius is built and tested on Debian 12; an older release may lack some of them."
fi
