#!/bin/sh
# build.sh EXE ROOT OPTION...: builds soak.cc with the drivers, the hosts' code that runs them, and
# the simulated robots' ends of the line.
set -eu
exe=$1 root=$2
shift 2
exec g++ -std=c++17 "$@" -ffp-contract=off \
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
    -I. -I../wire -I"$root/runtime" -I"$root/runtime/include" \
    -I"$root/sim" -I"$root/sim/serve" -I"$root/sim/wire" \
    soak.cc "$root"/sim/wire/*.cc \
    "$root/sim/serve/pioneer_firmware.cc" "$root/sim/serve/pioneer_motion.cc" "$root/sim/serve/p2os_packet.cc" \
    "$root"/runtime/drivers/scout/*.c "$root"/runtime/drivers/create/*.c \
    "$root"/runtime/drivers/pioneer/*.c \
    "$root/runtime/core/robot.c" "$root/runtime/hal/fake/fake.c" -o "$exe"
