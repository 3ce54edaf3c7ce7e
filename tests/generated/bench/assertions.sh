#!/bin/sh
# Measures the cost of checking an example's assertions: the instructions of its step, counted by
# valgrind, with --asserts=count and with --asserts=off, on the inputs of a run in the simulator.
# Only measures examples with a world: the others are not for a robot. The argument is the working
# folder; with $SHORT, each run takes a second.
set -eu
out=$1/assertions
frobc=_build/install/default/bin/frobc
mkdir -p "$out"
lasts=60s
test -z "${SHORT:-}" || lasts=1s

instructions() { # example, robot, --asserts=…
    valgrind --tool=callgrind --trace-children=yes --callgrind-out-file=/dev/null \
        --toggle-collect="$(basename "$1" .frob)_step" \
        "$frobc" trace "$1" --robot "$2" --asserts="$3" --input "$out/run.csv" \
        --output "$out/output.csv" 2>&1 | awk '/Collected :/ { sum += $4 } END { print sum }'
}

for example in $(grep -l '^ *assert "' examples/*/*.frob | grep -v '\.test\.frob$'); do
    test -e "$(dirname "$example")/world.toml" || continue
    case $example in */line_follow.frob) robot=create ;; *) robot=pioneer ;; esac
    "$frobc" run "$example" --robot $robot --for $lasts --record "$out/run.csv" >"$out/summary"
    reference=$(instructions "$example" $robot off)
    value=$(instructions "$example" $robot count)
    printf '{"program": "%s", "measure": "assertions, instructions", "compiler": "gcc", "value": %s, "reference": %s, "ratio": %s, "unit": "all steps"}\n' \
        "$(basename "$example" .frob)" "$value" "$reference" \
        "$(awk "BEGIN { printf \"%.3f\", $value / $reference }")"
done
