#!/bin/sh
# Installs those of the Debian packages in its arguments that are missing, and lists them; runs as
# root or uses sudo.
set -u

# Whether a package, or one that provides it, is installed. (Debian 13 has no elpa-eglot, because
# its Emacs includes Eglot.)
is_installed() {
    dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'ok installed' ||
        dpkg-query -W -f='${db:Status-Status}, ${Provides}\n' 2>/dev/null |
        awk -F ', *' -v package="$1" '
            $1 == "installed" { for (i = 2; i <= NF; i++) { sub(/ .*/, "", $i); if ($i == package) found = 1 } }
            END { exit !found }'
}

missing=
for package in "$@"; do
    is_installed "$package" || missing="$missing $package"
done
[ -z "$missing" ] && exit 0

if ! command -v apt-get >/dev/null 2>&1; then
    # On other systems, only check that the tools are installed.
    absent=
    for tool in ocaml dune menhir gcc g++ clang pkg-config; do
        command -v "$tool" >/dev/null 2>&1 || absent="$absent $tool"
    done
    [ -z "$absent" ] && exit 0
    echo "These programs are missing:$absent." >&2
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
    echo "Installing them needs root rights, and sudo is not installed. Run as root:" >&2
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
    echo "apt-get failed; $log has its complete output." >&2
    exit 1
fi
