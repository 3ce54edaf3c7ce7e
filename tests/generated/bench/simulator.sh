#!/bin/sh
# Speed of the simulator with the compiled wall follower, beside bare Box2D: the
# same world, motion and rays, and no program (see sim/bench/main.cc, also for
# the two ways to cast the rays of a cone). Of the example's one robot, and of a
# thousand in one world; in simulated seconds per second of one core. The argument
# is the folder to work in.
set -eu
out=$1/simulator
example=examples/wall_follow
bench=_build/default/sim/frob-sim-bench
dune build "./sim/frob-sim-bench"

# frobc keeps the shared objects that it makes; here it has a cache for this one.
rm -rf "$out"
mkdir -p "$out"
XDG_CACHE_HOME=$PWD/$out _build/install/default/bin/frobc run "$example/wall_follow.frob" --for 1s \
    >"$out/summary"

# Name, world, and what else the bench is to know.
measure() {
    name=$1
    shift
    "$bench" "$out"/frobc/wall_follow-*.so "$@" >"$out/speed"
    awk -v name="$name" '
        /^bare Box2D:/ { reference = $3 }
        /^bare, a look-up a cone:/ { by_cone = $6 }
        /^with the program:/ { value = $4 }
        function row(measure, reference) {
            printf "{\"program\": \"%s\", \"measure\": \"%s\", \"compiler\": \"gcc\", ", name, measure
            printf "\"value\": %s, \"reference\": %s, \"ratio\": %.3f, \"unit\": \"s/s\"}\n", \
                value, reference, value / reference
        }
        END {
            row("simulator", reference)
            row("simulator, rays by cone", by_cone)
        }' "$out/speed"
}

measure wall_follow "$example/world.toml"
measure robots_1000 tests/generated/bench/thousand_robots.toml 5 50 5
