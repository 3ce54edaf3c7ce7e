#!/bin/sh
# Processor time of `frobc compile`, beside what gcc -O1 takes to compile the C
# that it wrote: the wall follower, and generated programs of 1,000, 10,000 and
# 100,000 lines. Of these also the memory at most that each line takes, beyond
# that of a program of one line, beside the same of 10,000 lines: where it grows with
# the program as it should, the ratio is 1. The argument is the folder to work in.
set -eu
out=$1/compile_time
frobc=_build/install/default/bin/frobc
generate=_build/default/tests/generated/bench/generate/generate.exe
mkdir -p "$out"
dune build ./tests/generated/bench/generate/generate.exe
gcc -std=c99 -O2 -Wall -Wextra -Werror tests/generated/bench/processor_time.c -o "$out/processor_time"

# Name, program, how often to run frobc and gcc. Leaves the memory in $kilobytes.
measure() {
    set -- "$@" $("$out/processor_time" "$3" "$frobc" compile "$2" -o "$out")
    value=$5 kilobytes=$6
    reference=$("$out/processor_time" "$4" gcc -std=c99 -O1 -ffp-contract=off \
        -I "$out" -I runtime/include -c "$out/$(basename "$2" .frob).c" -o "$out/object.o")
    reference=${reference% *}
    ratio=$(awk "BEGIN { printf \"%.3f\", $value / $reference }")
    printf '{"program": "%s", "measure": "compile", "compiler": "frobc", "value": %s, "reference": %s, "ratio": %s, "unit": "ms"}\n' \
        "$1" "$value" "$reference" "$ratio"
}

a_line() { awk "BEGIN { printf \"%.2f\", ($kilobytes - $base) / $lines }"; }

measure wall_follow examples/wall_follow/wall_follow.frob 20 5

echo 'main = proc x -> x + 1.0' >"$out/one_line.frob"
base=$("$out/processor_time" 1 "$frobc" compile "$out/one_line.frob" -o "$out")
base=${base#* }
memory=
for lines in 1000 10000 100000; do
    "$generate" "$lines" >"$out/lines_$lines.frob"
    measure "lines_$lines" "$out/lines_$lines.frob" 3 1
    memory="$memory $lines:$(a_line)"
    if [ "$lines" = 10000 ]; then usual=$(a_line); fi
done
for size in $memory; do
    awk -v lines="${size%:*}" -v value="${size#*:}" -v usual="$usual" 'BEGIN {
        printf "{\"program\": \"lines_%s\", \"measure\": \"memory a line\", \"compiler\": \"frobc\", ", lines
        printf "\"value\": %s, \"reference\": %s, \"ratio\": %.3f, \"unit\": \"kB\"}\n", value, usual, value / usual }'
done
