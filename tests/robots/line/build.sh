#!/bin/sh
# build.sh EXE ROOT: builds frob-line with the drivers, the hosts' code that runs them, the
# simulated robots' ends of the line, and the simulator.
set -eu
exe=$1 root=$2
warnings="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
mkdir -p objects
for source in "$root"/runtime/core/*.c "$root"/runtime/drivers/*/*.c \
    "$root/runtime/hal/fake/fake.c" "$root/runtime/hosts/common/load.c" \
    "$root/runtime/hosts/robot/drivers.c"; do
    gcc -std=c99 -O2 -ffp-contract=off $warnings -I"$root/runtime" -I"$root/runtime/include" \
        -c "$source" -o "objects/$(echo "$source" | tr ./ __).o"
done
g++ -std=c++17 -O2 -ffp-contract=off $warnings \
    -I"$root/runtime" -I"$root/runtime/include" -I"$root/sim" -I"$root/sim/serve" \
    -I"$root/sim/wire" main.cc "$root/sim/serve/robots.cc" "$root/sim/serve/server.cc" \
    "$root/sim/serve/summary.cc" "$root/sim/serve/paced_line.cc" \
    "$root/sim/serve/p2os_packet.cc" "$root/sim/serve/pioneer_firmware.cc" "$root/sim/serve/pioneer_motion.cc" "$root"/sim/wire/*.cc \
    objects/*.o "$root/sim/libfrobsim.a" -lbox2d -ltomlplusplus -lcairo -ldl -o "$exe"
rm -r objects
