#!/bin/sh
# Runs the wall follower on other machines, emulated by qemu, where it drives a simulated robot: on
# ARM Linux through a pseudo-terminal, and on a Cortex-M4 without an operating system through its
# UART. Checks how it drove, and replays the Linux recordings on this machine, where the results
# must be identical bit for bit.
#
# Prints a line for each check, `ok` or `FAIL`; the exit status is 1 if any fails. Takes about a
# minute and a half.
set -eu
cd "$(dirname "$0")/../../.."
frobc=$PWD/_build/install/default/bin/frobc
program=$PWD/examples/wall_follow/wall_follow.frob
world=$PWD/tests/robots/robot/wall.toml
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

. tests/robots/run/within.sh

# Starts the robot and writes the name of its device to the file `served`.
serve () {
    rm -f "$work/served"
    case $* in *--robot*) ;; *) set -- --robot pioneer "$@" ;; esac
    "$frobc" serve --world "$world" --log "$work/told" "$@" >"$work/served" &
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
    with_camera "$@"
}

# The camera is a folder of random pictures; the program computes its speed from their brightness.
with_camera () { # TARGET, EMULATOR, LIBRARIES
    seeing=$PWD/tests/robots/camera/sees.frob
    mkdir -p "$work/pictures"
    for k in 1 2 3 4 5 6; do
        { printf 'P5 64 48 255\n'; head -c 3072 /dev/urandom; } >"$work/pictures/$k.pgm"
    done
    "$frobc" build "$seeing" --robot pioneer --target "$1" -o "$work/sees-$1"
    serve
    "$2" -L "$3" "$work/sees-$1" --device "$device" --camera "$work/pictures" --set camera.rate=2 \
        --for 4 --record "$work/seen.csv" >"$work/summary" 2>"$work/complaints"
    kill "$robot"
    wait "$robot"
    check "$1: a program sees" within camera_frames 6 6 late_steps 0 0 <"$work/summary"
    grep -v '^#' "$work/seen.csv" | sed 's/"[^"]*"//g' | cut -d, -f1,31- >"$work/drove.csv"
    "$frobc" trace "$seeing" --robot pioneer --input "$work/seen.csv" --output "$work/again.csv"
    check "$1: what it saw replays here, bit for bit" cmp "$work/drove.csv" "$work/again.csv"
}

# Size of the text without the runtime, compiled as for the board.
text_size () { # PRECISION, OPTIONS
    mkdir -p "$work/$1"
    "$frobc" compile "$program" --robot pioneer --real "$1" -o "$work/$1"
    arm-none-eabi-gcc -std=c99 -O2 -ffp-contract=off -mthumb -mcpu=cortex-m4 $2 -I runtime/include \
        -c "$work/$1/wall_follow.c" -o "$work/$1/wall_follow.o"
    arm-none-eabi-size "$work/$1/wall_follow.o" | awk 'NR == 2 { print $1 }'
}

no_doubles () {
    ! arm-none-eabi-nm "$work/float/wall_follow.o" | grep '__aeabi_\(d\|f2d\|i2d\|l2d\)'
}

on_cortex_m () { # PRECISION, NAME
    "$frobc" build "$program" --target cortex-m --real "$1" -o "$work/cortex-m"
    serve --tcp 0
    timeout 16 qemu-system-arm -M mps2-an386 -display none -monitor none \
        -serial "${device}" -serial "file:$work/console" -kernel "$work/cortex-m" \
        >/dev/null 2>&1 || true
    kill "$robot"
    wait "$robot"
    cat "$work/console"
    check "$2: follows the wall" drove 3
    check "$2: no step was late" grep -q "time 10 s, .* late 0, stale 0, connections 1" "$work/console"
}

# Tests the drivers of the other robots: they connect and drive, and their robots report how far.
other_on_cortex_m () { # ROBOT
    "$frobc" build "$PWD/tests/robots/robot/forward.frob" --robot "$1" --target cortex-m -o "$work/$1-on-cortex-m"
    serve --robot "$1" --tcp 0
    timeout 12 qemu-system-arm -M mps2-an386 -display none -monitor none \
        -serial "${device}" -serial "file:$work/console" -kernel "$work/$1-on-cortex-m" \
        >/dev/null 2>&1 || true
    kill "$robot"
    wait "$robot"
    cat "$work/console"
    check "cortex-m: a $1 is connected" grep -q "connections 1" "$work/console"
    check "cortex-m: a $1 drives" within distance_driven 0.5 4 <"$work/served"
}

# Compiles the exported library with Debian's Arduino core. An AVR has no 64-bit double, so it is
# refused; the rest of the main program works with the core.
for_arduino () {
    core=/usr/share/arduino/hardware/arduino/avr
    library=$work/exported
    "$frobc" export "$program" --robot pioneer --platformio "$library"
    set -- avr-g++ -mmcu=atmega2560 -DF_CPU=16000000L -DARDUINO=10819 -DARDUINO_ARCH_AVR -std=gnu++11 \
        -Os -I"$library/src" -I"$core/cores/arduino" \
        -I"$core/variants/mega" -c "$library/examples/$(basename "$program" .frob)/main.cpp" -o "$work/main.o"
    refused () { ! "$@" 2>"$work/refusal" && grep -q "needs 64-bit doubles" "$work/refusal"; }
    check "arduino: an AVR is refused" refused "$@"
    check "arduino: the main program fits the core" "$@" '-Dstatic_assert(condition,text)='
}

on_linux aarch64-linux qemu-aarch64 /usr/aarch64-linux-gnu
on_linux armhf-linux qemu-arm /usr/arm-linux-gnueabihf
on_cortex_m double cortex-m
on_cortex_m float "cortex-m, single precision"
other_on_cortex_m scout
other_on_cortex_m create
for_arduino
float="-mfpu=fpv4-sp-d16 -mfloat-abi=hard"
echo "text of the program's C on a Cortex-M4: $(text_size double "") bytes in double precision," \
    "$(text_size float "$float") in single"
check "cortex-m, single precision: the program has no doubles" no_doubles
exit $failed
