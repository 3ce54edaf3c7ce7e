#!/bin/sh
# Installs the Debian packages among the arguments that are missing, and says
# which; as root or through sudo.
set -u

missing=
for package in "$@"; do
    if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed'; then
        missing="$missing $package"
    fi
done
[ -z "$missing" ] && exit 0

if ! command -v apt-get >/dev/null 2>&1; then
    # Another system: what counts is that the tools are there.
    absent=
    for tool in ocaml dune menhir gcc g++ clang pkg-config; do
        command -v "$tool" >/dev/null 2>&1 || absent="$absent $tool"
    done
    [ -z "$absent" ] && exit 0
    echo "Missing here:$absent." >&2
    echo "This is not a Debian system (no apt-get), so install them yourself, with the OCaml" >&2
    echo "libraries menhirLib, cmdliner, alcotest and qcheck, and the C++ libraries Box2D 2.4," >&2
    echo "toml++ and cairo, and the C library libwebsockets; then run make again." >&2
    exit 1
fi

if [ "$(id -u)" -eq 0 ]; then
    as_root=
elif command -v sudo >/dev/null 2>&1; then
    as_root=sudo
else
    echo "These Debian packages are missing:$missing." >&2
    echo "Installing them takes root rights, and there is no sudo here. Run as root:" >&2
    echo "    apt-get install$missing" >&2
    exit 1
fi

echo "Installing Debian packages:$missing"
export DEBIAN_FRONTEND=noninteractive
log=$(mktemp)
if $as_root apt-get update >"$log" 2>&1 &&
    $as_root apt-get install -y --no-install-recommends $missing >>"$log" 2>&1; then
    rm -f "$log"
else
    tail -n 20 "$log" >&2
    echo "apt-get failed; the whole of what it said is in $log." >&2
    exit 1
fi
