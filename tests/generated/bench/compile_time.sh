#!/bin/sh
# Measures the processor time of `frobc compile`, compared with that of gcc -O1 on the generated C,
# for the wall follower and for generated programs of 1,000, 10,000 and 100,000 lines. For the
# latter it also measures the peak memory per line, minus that of a one-line program, compared with
# the same figure for 10,000 lines; a ratio of 1 means that memory grows linearly. The argument is
# the working folder.
set -eu
out=$1/compile_time
frobc=_build/install/default/bin/frobc
generate=_build/default/tests/generated/bench/generate/generate.exe
mkdir -p "$out"
dune build ./tests/generated/bench/generate/generate.exe
gcc -std=c99 -O2 -Wall -Wextra -Werror tests/generated/bench/processor_time.c -o "$out/processor_time"

# Arguments: name, program, number of runs of frobc and of gcc. Sets $kilobytes to the peak memory.
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
sizes="1000 10000 100000" middle=10000
test -z "${SHORT:-}" || sizes="100 1000" middle=1000
memory=
for lines in $sizes; do
    "$generate" "$lines" >"$out/lines_$lines.frob"
    measure "lines_$lines" "$out/lines_$lines.frob" 3 1
    memory="$memory $lines:$(a_line)"
    if [ "$lines" = $middle ]; then usual=$(a_line); fi
done
for size in $memory; do
    awk -v lines="${size%:*}" -v value="${size#*:}" -v usual="$usual" 'BEGIN {
        printf "{\"program\": \"lines_%s\", \"measure\": \"memory a line\", \"compiler\": \"frobc\", ", lines
        printf "\"value\": %s, \"reference\": %s, \"ratio\": %.3f, \"unit\": \"kB\"}\n", value, usual, value / usual }'
done
