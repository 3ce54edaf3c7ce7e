#!/bin/sh
# Runs the benchmarks: prints a table and writes _build/bench.json. Each part prints JSON objects,
# one a line; see the parts for what they measure. If a part fails, the script continues, names the
# part at the end, and exits with status 1. With $SHORT each part measures as little as possible:
# this checks that the part works, but its figures are meaningless.
set -u
cd "$(dirname "$0")/../../.."
out=_build/bench
bench=tests/generated/bench
mkdir -p "$out"
: >"$out/lines"

failed=
part() { # COMMAND...
    "$@" >"$out/part" || failed="$failed
bench: this part failed: $*"
    cat "$out/part" >>"$out/lines"
}

part sh $bench/step/run.sh "$out"
part sh $bench/step/cortex_m/run.sh "$out"
part sh $bench/compile_time.sh "$out"
part sh $bench/assertions.sh "$out"
part sh $bench/shapes.sh "$out"
part sh $bench/simulator.sh "$out"
part sh $bench/sweep/run.sh "$out"
part sh $bench/code_size.sh "$out"
part sh $bench/stop/run.sh "$out"
part sh $bench/view/run.sh "$out"
part sh $bench/vision/run.sh "$out"
part sh $bench/vision/camera.sh "$out"
part sh $bench/vision/frames.sh "$out"
part sh $bench/vision/share.sh "$out"
part python3 $bench/vision/truth.py _build/install/default/bin/frobc "$out/truth" ${SHORT:+1}
if [ -z "${SHORT:-}" ] && /usr/bin/python3 -c 'import cv2' 2>/dev/null; then
    sh tests/generated/photographs/run.sh _build/photographs >"$out/photographs" || true
    part cat _build/photographs/lines
fi
part sh $bench/lsp/run.sh "$out"
part sh $bench/python/run.sh

{
    echo '['
    sed '$!s/$/,/' "$out/lines"
    echo ']'
} >_build/bench.json

awk -F'"' '
    BEGIN { printf "%-14s %-26s %-10s %10s %10s %7s  %s\n", "program", "measure", "compiler", "value", "reference", "ratio", "unit" }
    function number(text) { gsub(/[:, ]/, "", text); return text }
    { printf "%-14s %-26s %-10s %10s %10s %7s  %s\n", $4, $8, $12, number($15), number($17), number($19), $22 }
' "$out/lines"
[ -z "$failed" ] || { echo "$failed" >&2; exit 1; }
