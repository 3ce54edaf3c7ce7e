#!/bin/sh
# What it costs to watch the assertions of an example: the instructions of its step, counted by
# valgrind, with --asserts=count beside --asserts=off, on the inputs of a run in the simulator.
# The argument is the folder to work in.
set -eu
out=$1/assertions
frobc=_build/install/default/bin/frobc
mkdir -p "$out"

instructions() { # example, --asserts=…
    valgrind --tool=callgrind --trace-children=yes --callgrind-out-file=/dev/null \
        --toggle-collect="$(basename "$1" .frob)_step" \
        "$frobc" trace "$1" --robot pioneer --asserts="$2" --input "$out/run.csv" \
        --output "$out/output.csv" 2>&1 | awk '/Collected :/ { sum += $4 } END { print sum }'
}

for example in $(grep -l '^ *assert "' examples/*/*.frob); do
    "$frobc" run "$example" --robot pioneer --for 60s --record "$out/run.csv" >"$out/summary"
    reference=$(instructions "$example" off)
    value=$(instructions "$example" count)
    printf '{"program": "%s", "measure": "assertions, instructions", "compiler": "gcc", "value": %s, "reference": %s, "ratio": %s, "unit": "all steps"}\n' \
        "$(basename "$example" .frob)" "$value" "$reference" \
        "$(awk "BEGIN { printf \"%.3f\", $value / $reference }")"
done
