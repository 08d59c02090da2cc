#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/check_in_debian.sh 12|13 [--run] [--check] [--package] [--pip] [--keep] [-- COMMAND ...]: makes a minimal system of
# that release of Debian from nothing, clones this commit into it, and tries there what a user does:
#   --run      ./run to the editor's window on a virtual display, with nothing on the error output
#   --check    ./check
#   --package  scripts/package.sh; the package is checked, installed, started from its desktop file and removed
#   --pip      pip install . in a fresh virtual environment; python -m gonio
# Without these options: --run and --check. Each prints its time. --keep leaves the system, and uses one that is there (with
# this commit and the builds of the last time); COMMAND runs in the clone, after the others. Needs root, and here debootstrap,
# xvfb, x11-utils and imagemagick. The bare system is kept in ${XDG_CACHE_HOME:-~/.cache}/gonio, as are Debian's packages;
# DEBIAN_MIRROR names another mirror. The commands inside the system are for its own shell:
# shellcheck disable=SC2016
set -eu
# shellcheck source=scripts/setup.sh
. "$(dirname "$0")/setup.sh"

case "${1:-}" in
  12) suite=bookworm ;;
  13) suite=trixie ;;
  *) fail "usage: scripts/check_in_debian.sh 12|13 [--run] [--check] [--package] [--pip] [--keep] [-- COMMAND ...]" ;;
esac
release=$1
shift
steps=() keep=
while [ $# -gt 0 ]; do
  case "$1" in
    --run | --check | --package | --pip) steps+=("${1#--}") ;;
    --keep) keep=1 ;;
    --) shift; break ;;
    *) fail "check_in_debian.sh: unknown option $1" ;;
  esac
  shift
done
[ ${#steps[@]} -gt 0 ] || [ $# -gt 0 ] || steps=(run check)

[ "$(id -u)" -eq 0 ] || fail "check_in_debian.sh needs root, for chroot and mount"
for program in debootstrap Xvfb xwininfo import; do
  command -v "$program" >/dev/null || fail "$program is missing: apt-get install debootstrap xvfb x11-utils imagemagick"
done

# Mounts and processes vanish with this one, however it ends; the system sees its own processes alone.
if [ -z "${GONIO_CHECK_MOUNTS:-}" ]; then
  options=("${steps[@]/#/--}")
  [ -z "$keep" ] || options+=(--keep)
  GONIO_CHECK_MOUNTS=private exec unshare --mount --pid --fork --kill-child "$0" "$release" "${options[@]}" -- "$@"
fi

mirror=${DEBIAN_MIRROR:-http://deb.debian.org}
cache=${XDG_CACHE_HOME:-$HOME/.cache}/gonio
system=$cache/debian-$release
base=$cache/debian-$release-base.tar
results=$root/build/debian-$release
mkdir -p "$cache/packages-$release/partial" "$results"

# timed WHAT COMMAND ...: a line with the seconds on the clock, also in results/times.txt.
timed() {
  local what=$1 begin=$SECONDS
  shift
  "$@" || fail "Debian $release: $what failed"
  printf 'Debian %s: %s: %d s\n' "$release" "$what" $((SECONDS - begin)) | tee -a "$results/times.txt"
}

bootstrap() {
  local made=$cache/debian-$release-base
  rm -rf "$made"
  debootstrap --variant=minbase --include=ca-certificates,git "$suite" "$made" "$mirror/debian" >"$results/debootstrap.log" 2>&1 ||
    { tail -n 20 "$results/debootstrap.log" >&2; return 1; }
  cat >"$made/etc/apt/sources.list" <<END
deb $mirror/debian $suite main
deb $mirror/debian $suite-updates main
deb $mirror/debian-security $suite-security main
END
  # How this machine reaches the mirror; not what it does after an installation.
  apt-config dump Acquire | grep -v IndexTargets >"$made/etc/apt/apt.conf.d/90host" || true
  tar -C "$made" -cf "$base.part" . && mv "$base.part" "$base"
  rm -rf "$made"
}

inside() {
  chroot "$system" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 TERM="${TERM:-dumb}" \
    ${DISPLAY:+DISPLAY="$DISPLAY"} XDG_RUNTIME_DIR=/run/user/0 LIBGL_ALWAYS_SOFTWARE=1 bash -c "cd /src/gonio && $1"
}

# Until a window of that title is there, or the process ends. window PROCESS PICTURE
window() {
  until xwininfo -root -tree 2>/dev/null | grep -q '"[^"]*Gonio[^"]*"'; do
    kill -0 "$1" 2>/dev/null || return 1
    sleep 1
  done
  sleep 15  # the picture is there, and messages that follow it
  kill -0 "$1" 2>/dev/null && import -window root "$2"
}

# shown NAME COMMAND: COMMAND starts the editor, which shows a window and writes nothing on the error output.
shown() {
  inside "exec $2" >"$results/$1.out" 2>"$results/$1.err" &
  local process=$!
  window $process "$results/$1.png" || { cat "$results/$1.out" "$results/$1.err" >&2; return 1; }
  # The editor itself, a child of the shell that started it; or the process that it was started by may have ended.
  pkill -P $process || true
  kill $process 2>/dev/null || true
  wait $process 2>/dev/null || true
  # apt's own word about a system without apt-utils.
  sed -i '/^gonio: installing/d; /^debconf: delaying package configuration/d' "$results/$1.err"
  [ ! -s "$results/$1.err" ] || { cat "$results/$1.err" >&2; return 1; }
}

step_run() { shown run "./run library:merl-copy/gold-metallic-paint"; }
step_check() { inside ./check >"$results/check.log" 2>&1 || { tail -n 60 "$results/check.log" >&2; return 1; }; }

install_quietly() { inside "DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $* >/dev/null"; }

step_package() {
  inside scripts/package.sh >"$results/package.log" 2>&1 || { tail -n 40 "$results/package.log" >&2; return 1; }
  install_quietly lintian appstream desktop-file-utils libgtk-3-bin shared-mime-info man-db
  inside 'lintian --allow-root --fail-on error build/package/gonio_*.deb' >"$results/lintian.log" 2>&1 ||
    { cat "$results/lintian.log" >&2; return 1; }
  inside 'find / -xdev -path /src -prune -o -path /var -prune -o -path /root -prune -o -path /tmp -prune -o -print | sort' >"$results/before.txt"
  install_quietly './build/package/gonio_*.deb'
  # Gonio has no page on the web, of which the appstreamcli of Debian 13 warns.
  inside 'desktop-file-validate /usr/share/applications/gonio.desktop && metainfo=/usr/share/metainfo/org.gonio.gonio.metainfo.xml &&
    { appstreamcli validate --no-net $metainfo || appstreamcli validate --no-net --override=url-homepage-missing=info $metainfo; }' \
    >"$results/metainfo.log" || { cat "$results/metainfo.log" >&2; return 1; }
  inside 'man -w gonio goniotool && cd / && goniotool --version && python3 -c "import gonio; print(gonio.__version__)"' || return 1
  # gtk-launch starts the program and ends.
  shown package "bash -c 'gtk-launch gonio.desktop && sleep 1 && while pidof gonio >/dev/null; do sleep 1; done'" || return 1
  inside 'kill $(pidof gonio) 2>/dev/null; DEBIAN_FRONTEND=noninteractive apt-get purge -y -qq gonio >/dev/null' || return 1
  inside 'find / -xdev -path /src -prune -o -path /var -prune -o -path /root -prune -o -path /tmp -prune -o -print | sort' >"$results/after.txt"
  ! grep -i gonio "$results/after.txt"
}

step_pip() {
  inside '. scripts/setup.sh && install_packages' >/dev/null
  install_quietly python3-venv python3-pip python3-setuptools python3-wheel
  inside 'rm -rf /tmp/venv && python3 -m venv --system-site-packages /tmp/venv && /tmp/venv/bin/pip install --no-build-isolation --no-deps . &&
    cd /tmp && /tmp/venv/bin/python -m gonio --version && /tmp/venv/bin/python -c "import gonio; print(gonio.__file__, gonio.__version__)"' \
    >"$results/pip.log" 2>&1 || { tail -n 40 "$results/pip.log" >&2; return 1; }
}

[ -n "$keep" ] || rm -rf "$system"
if [ ! -d "$system" ]; then
  [ -f "$base" ] || timed "debootstrap" bootstrap
  mkdir -p "$system"
  tar -C "$system" -xf "$base"
fi
cp /etc/resolv.conf "$system/etc/resolv.conf"
mkdir -p -m 700 "$system/run/user/0"  # of the session, as on every desktop
mkdir -p "$system/src" "$system/var/cache/apt/archives"
mount --bind "$cache/packages-$release" "$system/var/cache/apt/archives"
mount -t proc proc "$system/proc"
mount --rbind /dev "$system/dev"
mount -t tmpfs tmpfs "$system/dev/shm"
if [ -d "$system/src/gonio/.git" ]; then
  git -C "$system/src/gonio" fetch -q "$root" HEAD
  git -C "$system/src/gonio" checkout -q --force --detach FETCH_HEAD
else
  git clone -q --no-hardlinks "$root" "$system/src/gonio"
fi

# A display of this machine, as a user has one: the system itself needs none.
exec {display}<>"$results/display"
Xvfb -displayfd "$display" -screen 0 1600x1000x24 -nolisten tcp >"$results/xvfb.log" 2>&1 &
server=$!
trap 'kill $server 2>/dev/null; [ -n "$keep" ] || { umount -R "$system/dev" "$system/proc" "$system/var/cache/apt/archives" && rm -rf "$system"; }' EXIT
until [ -s "$results/display" ]; do kill -0 $server && sleep 0.2; done
DISPLAY=:$(cat "$results/display")
export DISPLAY

: >"$results/times.txt"
[ ${#steps[@]} -eq 0 ] || for step in "${steps[@]}"; do timed "$step" "step_$step"; done
[ $# -eq 0 ] || inside "$*"
