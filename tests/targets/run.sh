#!/bin/sh
# The wall follower on other machines, emulated by qemu, drives a simulated
# robot: ARM Linux through a pseudo-terminal, a Cortex-M4 without an operating
# system through its UART. What it drove is checked, and the recordings of the
# Linux ones are replayed on this machine, bit for bit.
#
# Prints a line for each check, `ok` or `FAIL`; the exit status is 1 if any
# fails. Takes about a minute.
set -eu
cd "$(dirname "$0")/../.."
frobc=$PWD/_build/install/default/bin/frobc
program=$PWD/examples/wall_follow/wall_follow.frob
world=$PWD/tests/robot/wall.toml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

check () { # NAME, COMMAND…
    name=$1
    shift
    if "$@" >"$work/said" 2>&1; then echo "ok $name"; else
        echo "FAIL $name"
        cat "$work/said"
        failed=1
    fi
}

. tests/run/within.sh

# Starts the robot; its device is then in the file `served`.
serve () {
    rm -f "$work/served"
    "$frobc" serve --robot pioneer --world "$world" --log "$work/told" "$@" >"$work/served" &
    robot=$!
    for attempt in $(seq 100); do
        grep -q device "$work/served" 2>/dev/null && break
        sleep 0.05
    done
    device=$(sed -n 's/^device: //p' "$work/served")
}

replays () { # LOG
    "$frobc" trace "$program" --input "$1" --output "$work/again.csv"
    sed 's/,.*,\([^,]*,[^,]*\)$/,\1/' "$1" | cmp - "$work/again.csv"
}

drove () { # LEAST DISTANCE
    within distance_driven "$1" 9 mean_wall_distance_error 0 0.05 collisions 0 0 <"$work/served"
}

on_linux () { # TARGET, EMULATOR, LIBRARIES
    "$frobc" build "$program" --target "$1" -o "$work/$1"
    serve
    "$2" -L "$3" "$work/$1" --device "$device" --for 15 --record "$work/log.csv" >"$work/summary"
    kill "$robot"
    wait "$robot"
    check "$1: follows the wall" drove 3.5
    check "$1: one connection" within connections 1 1 steps 700 760 <"$work/summary"
    check "$1: its recording replays here, bit for bit" replays "$work/log.csv"
}

on_cortex_m () {
    "$frobc" build "$program" --target cortex-m -o "$work/cortex-m"
    serve --tcp 0
    timeout 16 qemu-system-arm -M mps2-an386 -display none -monitor none \
        -serial "${device}" -serial "file:$work/console" -kernel "$work/cortex-m" \
        >/dev/null 2>&1 || true
    kill "$robot"
    wait "$robot"
    cat "$work/console"
    check "cortex-m: follows the wall" drove 3
    check "cortex-m: no step was late" grep -q "time 10 s, .* late 0, stale 0, connections 1" "$work/console"
}

on_linux aarch64-linux qemu-aarch64 /usr/aarch64-linux-gnu
on_linux armhf-linux qemu-arm /usr/arm-linux-gnueabihf
on_cortex_m
exit $failed
