#!/bin/sh
# Measures the time from killing a controller until its robot receives a stop command, over 1,000
# kills, eight at a time (see stop_latency.c). The argument is the working folder.
set -eu
out=$1/stop
here=tests/generated/bench/stop
rm -rf "$out"
mkdir -p "$out"
gcc -std=c99 -D_GNU_SOURCE -O2 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
    "$here/stop_latency.c" -o "$out/stop_latency"
XDG_CACHE_HOME=$PWD/$out _build/install/default/bin/frobc build tests/robots/robot/drive.frob -o "$out/drive"
kills=1000
test -z "${SHORT:-}" || kills=24
"$out/stop_latency" "$out/drive" $kills 8
