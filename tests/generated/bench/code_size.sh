#!/bin/sh
# Measures the code size of the BUG example and of the wall follower that it builds on, in bytes for
# a Cortex-M4 (gcc -Os). Excludes the runtime's elementary functions and the C library, which all
# programs share. The argument is the working folder.
set -eu
out=$1/code_size
frobc=_build/install/default/bin/frobc
mkdir -p "$out"

text() {
    "$frobc" compile "examples/$1/$1.frob" --robot pioneer -o "$out"
    arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -Os -std=c99 \
        -ffp-contract=off -I _build/install/default/share/frobc/include \
        -c "$out/$1.c" -o "$out/$1.o"
    arm-none-eabi-size "$out/$1.o" | awk 'NR == 2 { print $1 }'
}

value=$(text bug)
reference=$(text wall_follow)
awk -v value="$value" -v reference="$reference" 'BEGIN {
    printf "{\"program\": \"bug\", \"measure\": \"code for Cortex-M4\", \"compiler\": \"gcc -Os\", "
    printf "\"value\": %d, \"reference\": %d, \"ratio\": %.3f, \"unit\": \"bytes\"}\n", \
        value, reference, value / reference
}'
