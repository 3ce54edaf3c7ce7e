#!/bin/sh
# `frobc sweep` of the example wall follower: 10,000 runs of a minute by two workers; what it costs
# beyond the runs themselves; and 20 kills at random moments. What it prints: figures.py. The first
# argument is the folder to work in; the second, if there is one, another number of runs.
set -eu
out=$1/sweep
rm -rf "$out"
mkdir -p "$out"
cp examples/wall_follow/wall_follow.frob examples/wall_follow/world.toml "$out"
XDG_CACHE_HOME=$PWD/$out python3 -B tests/generated/bench/sweep/figures.py \
    "$PWD/_build/install/default/bin/frobc" "$out" "${2:-10000}"
