#!/bin/sh
# Measures the speed of the simulator with a camera, 320 by 240 at 30 Hz with noise, and a program
# that looks for the ball in each frame (examples/follow_ball): simulated seconds per second of one
# core, from the least processor time of ten runs of 20 s. The argument is the working folder.
set -eu
times=10
test -z "${SHORT:-}" || times=1
out=$1/camera
example=examples/follow_ball
mkdir -p "$out"
gcc -std=c99 -O2 -Wall -Wextra -Werror tests/generated/bench/processor_time.c -o "$out/processor_time"
_build/install/default/bin/frobc build "$example/follow_ball.frob" --shared -o "$out/follow_ball.so"
# Skip the host's summary, which comes first.
set -- $("$out/processor_time" $times _build/default/runtime/frob-sim "$out/follow_ball.so" \
    --world "$example/world.toml" --for 20 2>"$out/messages" | tail -1)
awk -v ms="$1" 'BEGIN {
    printf "{\"program\": \"follow_ball\", \"measure\": \"simulator with camera\", "
    printf "\"compiler\": \"gcc\", \"value\": %.1f, \"reference\": 20, \"ratio\": %.2f, ", \
        20000 / ms, 20000 / ms / 20
    printf "\"unit\": \"s/s\"}\n" }'
