#!/bin/sh
# Code of the BUG example for a Cortex-M4 (gcc -Os, with the runtime's elementary
# functions and the C library's left out, as they are shared by all programs), beside
# that of the wall follower that it is built on. In bytes. The argument is the folder to
# work in.
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
