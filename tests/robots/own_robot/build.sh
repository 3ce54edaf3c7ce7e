#!/bin/sh
# build.sh TEST ROOT [OPTION...]: builds TEST.cc with the Rover's driver and board, and the hosts'
# code that runs robots; with sanitizers unless other options are given. rover.h is in this folder.
set -eu
test=$1 root=$2
shift 2
[ $# -gt 0 ] || set -- -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=undefined
rover=$root/examples/own_robot
exec g++ -std=c++17 "$@" -ffp-contract=off \
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
    -I. -I../wire -I../faults -I../drivers -I"$rover" \
    -I"$root/runtime" -I"$root/runtime/include" -I"$root/sim/wire" \
    "$test.cc" "$rover/rover_wire.c" "$rover/rover_odometry.c" "$rover/rover_driver.c" \
    "$rover/rover_board.c" "$root/runtime/core/robot.c" "$root/runtime/hal/fake/fake.c" -o "$test"
