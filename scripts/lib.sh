# SPDX-License-Identifier: GPL-3.0-or-later
# Shared by the scripts beside it; sourced, after `set -euo pipefail`, from anywhere.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

say() { printf '\n== %s\n' "$*"; }

is_installed() { [ "$(dpkg-query -W -f='${Status}' "$1" 2>/dev/null)" = "install ok installed" ]; }

# is_offered PACKAGE: whether apt knows it, or does not know anything yet.
is_offered() {
  ! ls /var/lib/apt/lists/*Packages* >/dev/null 2>&1 || apt-cache show "$1" >/dev/null 2>&1
}

# install_packages LIST…: installs the packages of the lists that are missing, as root or through a
# sudo that does not ask; otherwise prints the line to type and stops. A name with a ? is left out
# where the system has no such package.
install_packages() {
  local missing=() offered=() package
  for package in $(cat "$@"); do
    is_installed "${package%\?}" && continue
    case $package in
      *\?) is_offered "${package%\?}" && missing+=("$package") ;;
      *) missing+=("$package") ;;
    esac
  done
  [ ${#missing[@]} -eq 0 ] && return
  local install="apt-get install -y --no-install-recommends"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if sudo -n true 2>/dev/null; then
      as_root=(sudo)
    else
      printf 'These packages are missing. As root, type\n\n    apt-get update && %s\n\n' "$install ${missing[*]%\?}" >&2
      exit 1
    fi
  fi
  say "installing ${#missing[@]} packages"
  "${as_root[@]}" apt-get update -q
  for package in "${missing[@]}"; do
    case $package in
      *\?) is_offered "${package%\?}" && offered+=("${package%\?}") ;;
      *) offered+=("$package") ;;
    esac
  done
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive $install "${offered[@]}"
}

# build PRESET [TARGET…]: with the further options of CMake in $PELLUCID_CMAKE_OPTIONS.
build() {
  local preset=$1
  shift
  say "building (preset $preset)"
  mkdir -p build
  local log=build/configure-$preset.log
  cmake --preset "$preset" ${PELLUCID_CMAKE_OPTIONS:-} >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
  cmake --build --preset "$preset" ${1:+--target "$@"}
}
