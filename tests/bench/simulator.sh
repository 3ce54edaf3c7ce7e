#!/bin/sh
# Speed of the simulator with a compiled controller, beside the same world
# with the same rays and no controller: simulated seconds per second.
set -eu
out=$1
_build/install/default/lib/frobc/frob-sim-bench examples/wall_follow/world.toml
