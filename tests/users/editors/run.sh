#!/bin/sh
# Runs an editor on a program, if it is installed: run.sh NAME COMMAND… prints what the user sees.
set -u
here=$(dirname "$0")
name=$1
shift
if ! command -v "$1" >/dev/null 2>&1; then
    echo "$1 is not installed: make test installs it" >&2
    cat "$here/$name.expected"
    exit 0
fi
HOME=$PWD XDG_CACHE_HOME=$PWD/cache XDG_STATE_HOME=$PWD/state XDG_DATA_HOME=$PWD/data \
    timeout 120 "$@" 2>"$name.errors" </dev/null || { echo "status $?"; cat "$name.errors"; }
