#!/bin/sh
# Measures how the time of `frobc compile` grows for programs of extreme shapes: the processor time
# for each, compared with one of half its size. A ratio of 2 means linear growth. (Nested values
# give C of quadratic size, because a value contains all of its levels.) The argument is the working
# folder.
set -eu
out=$1/shapes
frobc=_build/install/default/bin/frobc
mkdir -p "$out"
gcc -std=c99 -O2 -Wall -Wextra -Werror tests/generated/bench/processor_time.c -o "$out/processor_time"

# Arguments: shape and size; see shapes.awk.
compile() {
    awk -v shape="$1" -v n="$2" -f tests/generated/bench/shapes.awk >"$out/$1.frob"
    time=$("$out/processor_time" 3 "$frobc" compile "$out/$1.frob" -o "$out")
    echo "${time% *}"
}

while read -r shape size; do
    test -z "${SHORT:-}" || size=$((size / 100 * 2))
    half=$(compile "$shape" $((size / 2)))
    whole=$(compile "$shape" "$size")
    awk -v name="${shape}_$size" -v whole="$whole" -v half="$half" 'BEGIN {
        printf "{\"program\": \"%s\", \"measure\": \"compile, beside half\", \"compiler\": \"frobc\", ", name
        printf "\"value\": %s, \"reference\": %s, \"ratio\": %.2f, \"unit\": \"ms\"}\n", whole, half, whole / half }'
done <<END
ifs 9000
lets 9000
equations 20000
delays 20000
nodes 10000
instances 1000
modes 5000
tuples 400
maybes 240
END
