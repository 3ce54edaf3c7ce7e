#!/bin/sh
# Replaces Python with venv and pip in tests: an "environment" is a folder with this script, and pip
# only records the names of the packages. If the file `offline` exists, there is no network.
here=$(cd "$(dirname "$0")" && pwd)
case "$1 $2" in
"-m venv")
    [ ! -e "$TOP/no-venv" ] || { echo "Error: the module ensurepip is not available"; exit 1; }
    mkdir -p "$3/bin" "$3/lib" && cp "$0" "$3/bin/python3"
    ;;
"-m pip")
    [ ! -e "$TOP/offline" ] || {
        echo "WARNING: Retrying after connection broken by 'NewConnectionError'" >&2
        exit 1
    }
    [ ! -e "$TOP/hangs" ] || { touch "$TOP/started"; exec sleep 60; }
    shift 5
    printf '%s\n' "$@" >"$here/packages"
    ;;
"-c import sysconfig"*) echo "$here/../lib" ;;
*"from importlib.metadata"*)
    shift 2
    for name in "$@"; do
        grep -qx "$name" "$here/packages" 2>/dev/null || exit 1
        echo "$name 1.0"
    done
    ;;
*"importlib.util"*)
    shift 2
    for name in "$@"; do grep -qx "$name" "$here/packages" 2>/dev/null || exit 1; done
    ;;
*) exit 0 ;;
esac
