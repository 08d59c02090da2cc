# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# Sourced by ./run and ./check: installs what is missing and configures the build.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

fail() {
  printf 'gonio: %s\n' "$*" >&2
  exit 1
}

package_names() { sed -e 's/#.*//' -e 's/[[:space:]].*//' -e '/^$/d' "$root/scripts/packages-debian.txt"; }

# Also the names that installed packages provide: what is a package in Debian 12 may be a part of another in Debian 13.
installed_names() {
  dpkg-query -W -f '${db:Status-Status}, ${Package}, ${Provides}\n' | sed -n 's/^installed, //p' | tr ',' '\n' |
    sed -e 's/(.*//' -e 's/ //g'
}

# Installs the missing packages of scripts/packages-debian.txt, saying which and what each is for.
install_packages() {
  if ! command -v apt-get >/dev/null 2>&1 || ! command -v dpkg-query >/dev/null 2>&1; then
    printf 'gonio: this is no Debian system, so nothing is installed. Needed are a C++20 compiler, CMake 3.22, Ninja, and\n' >&2
    printf '       the development files of what these Debian packages hold:\n' >&2
    sed -e '/^#/d' -e 's/^/         /' "$root/scripts/packages-debian.txt" >&2
    return 0
  fi
  local missing=() installed name
  installed=$(installed_names)
  while read -r name; do
    grep -qxF "$name" <<<"$installed" || missing+=("$name")
  done < <(package_names)
  [ ${#missing[@]} -eq 0 ] && return 0
  printf 'gonio: installing %d Debian packages that are missing:\n' ${#missing[@]}
  for name in "${missing[@]}"; do sed -n "s/^$name  */  $name: /p" "$root/scripts/packages-debian.txt"; done
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null 2>&1 || fail "sudo is needed to install packages; as root run: apt-get install ${missing[*]}"
    sudo=(sudo)
  fi
  "${sudo[@]}" apt-get update -qq || fail "the package lists could not be updated (is there a network?)"
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" \
    >/dev/null || fail "apt-get could not install: ${missing[*]}"
}

# configure PRESET: configures build/PRESET; its output is shown only when it fails.
configure() {
  command -v cmake >/dev/null 2>&1 || fail "cmake is missing"
  mkdir -p "$root/build"
  local log=$root/build/configure-$1.log
  cmake -S "$root" --preset "$1" -Wno-dev >"$log" 2>&1 ||
    { cat "$log" >&2; fail "the build could not be configured (see above)"; }
}
