#!/bin/sh
# build.sh TEST ROOT [OPTION...]: builds TEST.cc with the drivers of Scout and Create, the hosts'
# code that runs them, and the simulated robots' ends of the line; with sanitizers unless other
# options are given. Compiles everything as C++17.
set -eu
test=$1 root=$2
shift 2
[ $# -gt 0 ] || set -- -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=undefined
exec g++ -std=c++17 "$@" -ffp-contract=off \
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
    -I"$root/runtime" -I"$root/runtime/include" -I"$root/sim/wire" -I../drivers \
    "$test.cc" "$root"/sim/wire/*.cc \
    "$root"/runtime/drivers/scout/*.c "$root"/runtime/drivers/create/*.c \
    "$root/runtime/core/robot.c" "$root/runtime/hal/fake/fake.c" -o "$test"
