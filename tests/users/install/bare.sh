#!/bin/sh
# usage: bare.sh BUILD SUITE... : installs the wheel in BUILD/wheel, as a user would, in a bare
# Debian of each suite, which has Python with pip but no compiler; and drives a simulated robot with
# it. ARCHITECTURE=arm64 does so for another architecture, if qemu-user is installed, without a limit
# on the time; these systems also have gcc, because the wheel contains a compiler only for x86-64. Must run as root, because it creates the systems with debootstrap, in BUILD/bare. Their
# network has no interface, so pip can only use the packages in BUILD/bare/index.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$1
shift
[ "$(id -u)" = 0 ] || { echo "bare.sh: creating bare systems requires root" >&2; exit 2; }
bare=$build/bare
architecture=${ARCHITECTURE:-$(dpkg --print-architecture)}
[ "$architecture" = "$(dpkg --print-architecture)" ] && limit=60 || limit=100000
packages=python3,python3-pip,python3-venv
[ "$architecture" = amd64 ] || packages=$packages,gcc,libc6-dev
mkdir -p "$bare/index"
rm -f "$bare/index"/frobc-*.whl
cp "$build"/wheel/frobc-*.whl "$bare/index"

# Creates a system, or reuses one that an earlier call completed.
create() { # SUITE
    [ ! -e "$bare/$1.complete" ] || return 0
    rm -rf "${bare:?}/$1"
    echo "Creating a bare $1 in $bare/$1"
    debootstrap --arch="$architecture" --variant=minbase --include="$packages" "$1" "$bare/$1" \
        >"$bare/$1.log" 2>&1 || { tail "$bare/$1.log" >&2; exit 1; }
    # python3-pip recommends a compiler, but debootstrap installs no recommended packages.
    for program in cc gcc clang tcc as ld; do
        [ "$architecture" = amd64 ] || break
        ! chroot "$bare/$1" sh -c "command -v $program" || { echo "$1 has $program" >&2; exit 1; }
    done
    chroot "$bare/$1" useradd --create-home user
    touch "$bare/$1.complete"
}

# numpy's wheels depend on the architecture.
[ "$architecture" != arm64 ] && platform= ||
    platform="--platform manylinux2014_aarch64 --platform manylinux_2_28_aarch64"
for suite in "$@"; do
    create "$suite"
    version=$(chroot "$bare/$suite" python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')
    python3 -m pip download --quiet --disable-pip-version-check --only-binary=:all: \
        --python-version "$version" $platform --dest "$bare/index" numpy cma mcap
    rm -rf "$bare/$suite/home/user" "$bare/$suite/index"
    cp -R "$bare/index" "$bare/$suite/index"
    cp "$here/inside.sh" "$here/page.py" "$here/foreign.py" "$bare/$suite/"
    chroot "$bare/$suite" sh -c 'mkdir /home/user && chown user: /home/user && chmod -R a+rX /index'
    # shellcheck disable=SC2016 # the inner shell expands $0
    unshare --mount --pid --net --fork sh -c '
        mount -t proc proc "$0/proc"
        mount -t tmpfs -o mode=1777 tmpfs "$0/dev/shm"
        ip link set lo up 2>/dev/null || python3 -c "
import fcntl, socket, struct
s = socket.socket()
fcntl.ioctl(s, 0x8914, struct.pack(\"16sh14x\", b\"lo\", 0x49))"
        exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin chroot "$0" \
            su user -c "LIMIT=$1 exec sh /inside.sh"' "$bare/$suite" "$limit" ||
        { echo "FAIL $suite" >&2; exit 1; }
    echo "ok   $suite"
done
