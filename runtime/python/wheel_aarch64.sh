#!/bin/sh
# usage: wheel_aarch64.sh BUILD PACKAGE... : builds the wheel for 64-bit ARM in BUILD/aarch64/wheel.
# Run it in the top folder of the project, as root. Debian has no OCaml compiler that runs on one
# architecture and produces code for another. So the script builds everything, with the Debian
# packages in its arguments, in a Debian 12 for 64-bit ARM, which qemu-user emulates. The first build
# takes about an hour. If SHORT is not empty, the script only checks that the system can build a host.
set -eu
build=$1/aarch64
shift
[ "$(id -u)" = 0 ] || { echo "wheel_aarch64.sh: creating a Debian system requires root" >&2; exit 2; }
system=$build/system
if [ "$(uname -m)" != aarch64 ] && [ ! -e /proc/sys/fs/binfmt_misc/qemu-aarch64 ]; then
    echo "This kernel does not run programs for 64-bit ARM: install qemu-user-static and binfmt-support" >&2
    exit 2
fi
mkdir -p "$build"
if [ ! -e "$build/complete" ]; then
    rm -rf "$system"
    echo "Creating a Debian 12 for 64-bit ARM in $system; see $build/system.log"
    debootstrap --arch=arm64 --variant=minbase bookworm "$system" >"$build/system.log" 2>&1
    cp /etc/apt/apt.conf.d/* "$system/etc/apt/apt.conf.d/" 2>/dev/null || true
    touch "$build/complete"
fi
cp /etc/resolv.conf "$system/etc/"
[ ! -e /etc/pip.conf ] || cp /etc/pip.conf "$system/etc/"

# Runs a command in the system, with its own /proc.
inside() {
    # shellcheck disable=SC2016 # the inner shell expands the parameters
    unshare --mount --pid --fork sh -c '
        system=$1; shift
        mount -t proc proc "$system/proc"
        exec env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin DUNE_PROFILE=optimized \
            SOURCE_DATE_EPOCH="$SOURCE_DATE_EPOCH" chroot "$system" "$@"' inside "$system" "$@"
}
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || date +%s)}
export SOURCE_DATE_EPOCH
inside sh -c 'apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "$@"' \
    install make git ca-certificates "$@" >>"$build/system.log" 2>&1
# It trusts the same certificates as this computer, for a company's proxy.
cp -L /etc/ssl/certs/ca-certificates.crt "$system/etc/ssl/certs/"

# Unchanged sources keep their times, so that dune builds only what has changed.
mkdir -p "$system/src"
git ls-files -z | tar --null --files-from=- --create --file=- | tar -x -C "$system/src" --file=-
if [ -n "${SHORT:-}" ]; then
    inside sh -c 'cd /src && dune build runtime/frob-trace && _build/default/runtime/frob-trace --help 2>&1 | grep usage'
    exit 0
fi
inside sh -c 'cd /src && dune build @install && sh runtime/python/wheel.sh /src/_build'
rm -rf "$build/wheel"
cp -R "$system/src/_build/wheel" "$build/wheel"
echo "the wheel: $(ls "$build"/wheel/frobc-*.whl)"
