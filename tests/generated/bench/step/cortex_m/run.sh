#!/bin/sh
# Compares the generated step in single precision with that in double precision on a Cortex-M4,
# whose floating-point unit supports only single precision. Measures the size of the text in bytes,
# and the instructions of a step, as bench.h in this folder counts them. The arguments are the
# working folder, and the programs; the default is all.
set -eu
out=$1/cortex_m
shift
here=tests/generated/bench/step
frobc=_build/install/default/bin/frobc
gcc="arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -Os -std=c99
    -ffp-contract=off -I runtime/include"
board="--specs=rdimon.specs -T tests/generated/matrix/cortex_m.ld tests/generated/matrix/cortex_m.c"

# Size of code and constants.
text_bytes() {
    arm-none-eabi-size -A "$1" | awk '$1 ~ /^\.(text|rodata)/ { sum += $2 } END { print sum + 0 }'
}

# Builds PROGRAM.o, and prints the size of its text and the instructions of a step.
measured() { # PRECISION, OPTIONS
    made=$out/$1
    mkdir -p "$made"
    "$frobc" compile --real "$1" "$here/$program/$program.frob" -o "$made"
    # shellcheck disable=SC2086
    {
        $gcc -c "$made/$program.c" -o "$made/$program.o"
        $gcc $2 -I "$here/cortex_m" -I "$made" -iquote "$here/$program" "$here/$program/bench.c" \
            "$made/$program.o" runtime/elementary/*.c $board -lm -o "$made/$program.elf"
    }
    echo "$(text_bytes "$made/$program.o") $(timeout 60 qemu-system-arm -M mps2-an386 -icount shift=0 \
        -nographic -monitor none -serial none -semihosting-config enable=on,target=native \
        -kernel "$made/$program.elf")"
}

row() { # MEASURE, VALUE, REFERENCE, UNIT
    ratio=$(awk "BEGIN { printf \"%.3f\", $2 / $3 }")
    printf '{"program": "%s", "measure": "%s", "compiler": "Cortex-M4", "value": %s, "reference": %s, "ratio": %s, "unit": "%s"}\n' \
        "$program" "$1" "$2" "$3" "$ratio" "$4"
}

if [ $# -eq 0 ] && [ -n "${SHORT:-}" ]; then set -- pid; fi
if [ $# -eq 0 ]; then set -- wall_follow pid kalman; fi
for program in "$@"; do
    # shellcheck disable=SC2046
    set -- $(measured float -DBENCH_SINGLE) $(measured double "")
    row "text, single precision" "$1" "$3" bytes
    row "step, single precision" "$2" "$4" instructions
done
