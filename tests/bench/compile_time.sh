#!/bin/sh
# Processor time of `frobc compile`, beside what gcc -O1 takes to compile the C
# that it wrote: the wall follower, and generated programs of 1,000, 10,000 and
# 100,000 lines. The argument is the folder to work in.
set -eu
out=$1/compile_time
frobc=_build/install/default/bin/frobc
generate=_build/default/tests/bench/generate/generate.exe
mkdir -p "$out"
dune build ./tests/bench/generate/generate.exe
gcc -std=c99 -O2 -Wall -Wextra -Werror tests/bench/processor_time.c -o "$out/processor_time"

# Name, program, how often to run frobc and gcc.
measure() {
    value=$("$out/processor_time" "$3" "$frobc" compile "$2" -o "$out")
    reference=$("$out/processor_time" "$4" gcc -std=c99 -O1 -ffp-contract=off \
        -I "$out" -I runtime/include -c "$out/$(basename "$2" .frob).c" -o "$out/object.o")
    ratio=$(awk "BEGIN { printf \"%.3f\", $value / $reference }")
    printf '{"program": "%s", "measure": "compile", "compiler": "frobc", "value": %s, "reference": %s, "ratio": %s, "unit": "ms"}\n' \
        "$1" "$value" "$reference" "$ratio"
}

measure wall_follow examples/wall_follow/wall_follow.frob 20 5
for lines in 1000 10000 100000; do
    "$generate" "$lines" >"$out/lines_$lines.frob"
    measure "lines_$lines" "$out/lines_$lines.frob" 3 1
done
