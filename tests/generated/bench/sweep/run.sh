#!/bin/sh
# Measures `frobc sweep` on the example wall follower: 10,000 runs of a minute by two workers, its
# overhead beyond the runs themselves, and 20 kills at random moments. figures.py describes the
# output. The arguments are the working folder and, optionally, another number of runs.
set -eu
runs=${2:-10000}
test -z "${SHORT:-}" || runs=${2:-300}
out=$1/sweep
rm -rf "$out"
mkdir -p "$out"
cp examples/wall_follow/wall_follow.frob examples/wall_follow/world.toml "$out"
XDG_CACHE_HOME=$PWD/$out python3 -B tests/generated/bench/sweep/figures.py \
    "$PWD/_build/install/default/bin/frobc" "$out" "$runs"
