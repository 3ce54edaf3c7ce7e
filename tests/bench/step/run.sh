#!/bin/sh
# Step time and state of generated C beside hand-written C, under gcc and
# clang at -O2 (see harness.h). The argument is the folder to work in.
set -eu
out=$1
here=tests/bench/step
frobc=_build/install/default/bin/frobc
# As frobc's own hosts build generated code; hand-written code gets the same.
exact="-ffp-contract=off -fno-builtin-sin"

for program in wall_follow pid; do
    "$frobc" compile "$here/$program.frob" -o "$out"
done
for compiler in gcc clang; do
    "$compiler" -std=c99 -O2 $exact -Wall -Wextra -Werror -I "$out" -I "$here" \
        "$here"/main.c "$here"/harness.c "$here"/*_by_hand.c \
        "$out"/wall_follow.c "$out"/pid.c -lm -o "$out/step-$compiler"
    "$out/step-$compiler"
done
