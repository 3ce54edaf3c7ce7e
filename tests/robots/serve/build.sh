#!/bin/sh
# build.sh TEST ROOT: builds TEST.cc with the drivers of Scout and Create, the hosts' code that runs
# them, the robots' ends of the line, and the simulator.
set -eu
test=$1 root=$2
exec g++ -std=c++17 -O1 -g -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
    -I"$root/runtime" -I"$root/runtime/include" -I"$root/sim" -I"$root/sim/serve" \
    -I"$root/sim/wire" -I../wire -I../drivers "$test.cc" "$root"/sim/wire/*.cc \
    "$root"/runtime/drivers/scout/*.c "$root"/runtime/drivers/create/*.c \
    "$root/runtime/core/robot.c" "$root/runtime/hal/fake/fake.c" \
    "$root/sim/libfrobsim.a" -lbox2d -ltomlplusplus -lcairo -o "$test"
