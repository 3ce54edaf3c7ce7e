#!/bin/sh
# Measures how much of a tracker's work the Frob program itself does, rather than the kernels: its
# fraction of the instructions of a step, counted by callgrind, on the frames of a run
# (tests/robots/trackers). Its fraction of the time is smaller, because an instruction of a kernel
# takes longer than an average one. The argument is the working folder.
set -eu
out=$1/share
trackers=tests/robots/trackers
frobc=$PWD/_build/install/default/bin/frobc
rm -rf "$out"
mkdir -p "$out"
"$frobc" run $trackers/known.frob --world $trackers/world.toml --for 3s --record "$out/run.csv" \
    >"$out/summary"

share() { # a tracker of share.frob
    { cat tests/generated/bench/vision/share.frob; echo "main = $1"; } >"$out/$1.frob"
    "$frobc" build "$out/$1.frob" --shared -o "$out/$1.so"
    valgrind --quiet --tool=callgrind --callgrind-out-file="$out/$1.out" \
        _build/install/default/lib/frobc/frob-trace "$out/$1.so" "$out/run.csv" "$out/$1.csv"
    # Check that the tracker saw its object; otherwise the kernels would search the whole image, or
    # nothing.
    awk -F, '$2 == "Seen" { n++ } END { if (n < 0.9 * (NR - 1)) exit 1 }' "$out/$1.csv"
    callgrind_annotate --inclusive=yes --threshold=100 "$out/$1.out" | awk -v program="$1" '
        { count = $1; gsub(",", "", count) }
        / \?\?\?:step \[/ { step = count }
        / \?\?\?:frob_(find_blobs|find_edges|get_patch|match_patch|find_template) \[/ {
            kernels += count }
        END {
            if (step == 0 || kernels == 0) exit 1
            share = 100 * (step - kernels) / step
            printf "{\"program\": \"%s\", \"measure\": \"Frob'\''s share of a tracker\", ", program
            printf "\"compiler\": \"gcc\", \"value\": %.2f, \"reference\": 10, ", share
            printf "\"ratio\": %.3f, \"unit\": \"%%\"}\n", share / 10
        }'
}

for tracker in blob ssd composites edges; do
    share $tracker
done
