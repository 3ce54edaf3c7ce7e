#!/bin/sh
# Measures: prints a table and writes _build/bench.json. Each part prints JSON
# objects, one a line; see the parts for what they measure.
set -eu
cd "$(dirname "$0")/../../.."
out=_build/bench
mkdir -p "$out"

{
    sh tests/generated/bench/step/run.sh "$out"
    sh tests/generated/bench/step/cortex_m/run.sh "$out"
    sh tests/generated/bench/compile_time.sh "$out"
    sh tests/generated/bench/assertions.sh "$out"
    sh tests/generated/bench/shapes.sh "$out"
    sh tests/generated/bench/simulator.sh "$out"
    sh tests/generated/bench/sweep/run.sh "$out"
    sh tests/generated/bench/code_size.sh "$out"
    sh tests/generated/bench/stop/run.sh "$out"
    sh tests/generated/bench/view/run.sh "$out"
    sh tests/generated/bench/vision/run.sh "$out"
    sh tests/generated/bench/vision/camera.sh "$out"
    sh tests/generated/bench/vision/frames.sh "$out"
    sh tests/generated/bench/vision/share.sh "$out"
    python3 tests/generated/bench/vision/truth.py _build/install/default/bin/frobc "$out/truth"
    if /usr/bin/python3 -c 'import cv2' 2>/dev/null; then
        sh tests/generated/photographs/run.sh _build/photographs >"$out/photographs" || true
        cat _build/photographs/lines
    fi
    sh tests/generated/bench/lsp/run.sh "$out"
    sh tests/generated/bench/python/run.sh
} >"$out/lines"

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
