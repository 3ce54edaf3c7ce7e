#!/bin/sh
# Time of `frobc compile`, best of three, beside what gcc -O1 takes to compile
# the C that it wrote: the wall follower, and generated programs of 1,000,
# 10,000 and 100,000 lines. The argument is the folder to work in.
set -eu
out=$1
frobc=_build/install/default/bin/frobc
generate=_build/default/tests/bench/generate/generate.exe
mkdir -p "$out/compile_time"
dune build "./tests/bench/generate/generate.exe"

# Milliseconds of the fastest of $1 runs of the rest.
best() {
    runs=$1
    shift
    fastest=
    while [ "$runs" -gt 0 ]; do
        start=$(date +%s%N)
        "$@"
        took=$(($(date +%s%N) - start))
        if [ -z "$fastest" ] || [ "$took" -lt "$fastest" ]; then fastest=$took; fi
        runs=$((runs - 1))
    done
    awk "BEGIN { printf \"%.1f\", $fastest / 1e6 }"
}

measure() {
    name=$1
    file=$2
    value=$(best 3 "$frobc" compile "$file" -o "$out/compile_time")
    reference=$(best 1 gcc -std=c99 -O1 -ffp-contract=off -I "$out/compile_time" -I runtime/include \
        -c "$out/compile_time/$(basename "$file" .frob).c" -o "$out/compile_time/object.o")
    ratio=$(awk "BEGIN { printf \"%.3f\", $value / $reference }")
    printf '{"program": "%s", "measure": "compile", "compiler": "frobc", "value": %s, "reference": %s, "ratio": %s, "unit": "ms"}\n' \
        "$name" "$value" "$reference" "$ratio"
}

measure wall_follow examples/wall_follow/wall_follow.frob
for lines in 1000 10000 100000; do
    "$generate" "$lines" >"$out/compile_time/lines_$lines.frob"
    measure "lines_$lines" "$out/compile_time/lines_$lines.frob"
done
