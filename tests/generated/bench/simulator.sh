#!/bin/sh
# Measures the speed of the simulator with the compiled wall follower, compared with bare Box2D: the
# same world, motion and rays, but no program (see sim/bench/main.cc, also for the two ways to cast
# the rays of a cone). Measures the example's single robot, and a thousand robots in one world, in
# simulated seconds per second of one core. The argument is the working folder.
set -eu
out=$1/simulator
example=examples/wall_follow
bench=_build/default/sim/frob-sim-bench
dune build "./sim/frob-sim-bench"

# frobc caches the shared objects that it builds; this one gets a separate cache.
rm -rf "$out"
mkdir -p "$out"
XDG_CACHE_HOME=$PWD/$out _build/install/default/bin/frobc run "$example/wall_follow.frob" --for 1s \
    >"$out/summary"

# Arguments: name, world, and further arguments of the benchmark.
measure() {
    name=$1
    shift
    "$bench" "$out"/frobc/wall_follow-*.so "$@" >"$out/speed"
    awk -v name="$name" '
        /^bare Box2D:/ { reference = $3 }
        /^bare, one look-up per cone:/ { by_cone = $6 }
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

if [ -n "${SHORT:-}" ]; then usual="2 50 1" many="0.2 50 1"; else usual= many="5 50 5"; fi
# shellcheck disable=SC2086
measure wall_follow "$example/world.toml" $usual
# shellcheck disable=SC2086
measure robots_1000 tests/generated/bench/thousand_robots.toml $many
