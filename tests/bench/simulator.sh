#!/bin/sh
# Speed of the simulator with the compiled wall follower, beside bare Box2D:
# the same world, motion and rays, and no program (see sim/bench/main.cc). In
# simulated seconds per second. The argument is the folder to work in.
set -eu
out=$1/simulator
example=examples/wall_follow
bench=_build/default/sim/frob-sim-bench
dune build "./sim/frob-sim-bench"

# frobc keeps the shared objects that it makes; here it has a cache for this one.
rm -rf "$out"
mkdir -p "$out"
XDG_CACHE_HOME=$out _build/install/default/bin/frobc run "$example/wall_follow.frob" --for 1s \
    >"$out/summary"

"$bench" "$out"/frobc/wall_follow-*.so "$example/world.toml" >"$out/speed"
awk '
    /^bare Box2D:/ { reference = $3 }
    /^with the program:/ { value = $4 }
    END {
        printf "{\"program\": \"wall_follow\", \"measure\": \"simulator\", \"compiler\": \"gcc\", "
        printf "\"value\": %s, \"reference\": %s, \"ratio\": %.3f, \"unit\": \"s/s\"}\n", \
            value, reference, value / reference
    }' "$out/speed"
