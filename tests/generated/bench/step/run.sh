#!/bin/sh
# Compares generated C with hand-written C, under gcc and clang at -O2 and -O3, each also with
# link-time optimization, which inlines the step into the loop that calls it. Measures the time of
# the step for hosts (see bench.c), its instructions (counted by valgrind, so the same in each run),
# the size of the state, and the size of the text at -O2; and the time of the step that rounds
# seconds, compared with hand-written C that rounds them too. The placement of machine code in memory alone changes
# the ratio of two times by up to a tenth, so each program is compiled in several layouts, and the
# script reports the layout with the median ratio. Some programs are also compared with the C that
# Copilot generates for them. The arguments are the working folder, and the programs; the default is
# all.
set -eu
out=$1/step
shift
here=tests/generated/bench/step
frobc=_build/install/default/bin/frobc
rounds=67 middle=2
levels="O2 O3"
# Alignments of functions and loops; the usual one is the compilers' default.
usual=-falign-functions=16
layouts="-falign-functions=64 -falign-loops=32 $usual"
# The elementary functions.
library=_build/install/default/lib/frobc/libfrob.a
# The options with which frobc's hosts compile generated code; hand-written code gets the same.
exact="-std=c99 -ffp-contract=off"
warnings="-Wall -Wextra -Werror"
if [ -n "${SHORT:-}" ]; then
    rounds=1 levels=O2 layouts=$usual middle=1
    [ $# -gt 0 ] || set -- pid
fi
mkdir -p "$out"

# Arguments: measure, compiler, value, reference, unit.
row() {
    ratio=$(awk "BEGIN { printf \"%.3f\", $3 / $4 }")
    printf '{"program": "%s", "measure": "%s", "compiler": "%s", "value": %s, "reference": %s, "ratio": %s, "unit": "%s"}\n' \
        "$program" "$1" "$2" "$3" "$4" "$ratio" "$5"
}

# Size of code and constants, without debugging and exception tables.
text_bytes() {
    size -A "$1" | awk '$1 ~ /^\.(text|rodata)/ { sum += $2 } END { print sum + 0 }'
}

# Instructions of a pass, divided by the number of steps.
instructions() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="$2*" "$1" 1 2>&1 |
        awk '/Collected/ { printf "%.1f", $4 / 16384 }'
}

# Runs the executable of each layout, and prints the output of the one with the median ratio.
middle_of_layouts() {
    for layout in $layouts; do
        "$1$layout" $rounds
    done >"$1-times"
    awk '{ print $1 / $2, $0 }' "$1-times" | sort -n | sed -n ${middle}p | cut -d ' ' -f 2-
}

measure() {
    compiler=$1
    label="$compiler -$2"
    made=$out/$program-$compiler-$2
    include="-I $out -I $here -I $here/$program -I runtime/include"
    # The usual layout is the last one, so that the sizes below are those of its objects.
    for layout in $layouts; do
        flags="-$2 $layout $exact"
        # shellcheck disable=SC2086
        {
            $compiler $flags $warnings $include -c "$out/$program.c" -o "$made-generated.o"
            $compiler $flags $warnings $include -c "$here/$program/by_hand.c" -o "$made-by_hand.o"
            $compiler $flags $warnings $include "$here/$program/bench.c" "$here/bench.c" \
                "$made-generated.o" "$made-by_hand.o" $library -lm -o "$made$layout"
            $compiler $flags $warnings $include -DBENCH_IN_SECONDS "$here/$program/bench.c" \
                "$here/bench.c" "$made-generated.o" "$made-by_hand.o" $library -lm \
                -o "$made-in_seconds$layout"
        }
    done
    # Compares the outputs for extreme inputs.
    "$made$usual" 0
    "$made-in_seconds$usual" 0
    set -- $(middle_of_layouts "$made")
    row "step time" "$label" "$1" "$2" ns
    if [ "$label" = "gcc -O2" ]; then row "state" "$compiler" "$3" "$4" bytes; fi
    set -- $(middle_of_layouts "$made-in_seconds")
    row "step time, in seconds" "$label" "$1" "$2" ns
    row "step instructions" "$label" "$(instructions "$made$usual" generated_pass)" \
        "$(instructions "$made$usual" by_hand_pass)" instructions
    case $label in
    *-O2) row "text" "$label" "$(text_bytes "$made-generated.o")" "$(text_bytes "$made-by_hand.o")" bytes ;;
    esac
}

# The same with link-time optimization, including the benchmark.
measure_linked() {
    compiler=$1
    label="$compiler -$2 -flto"
    made=$out/$program-$compiler-$2-lto
    include="-I $out -I $here -I $here/$program -I runtime/include"
    for layout in $layouts; do
        # shellcheck disable=SC2086
        $compiler -$2 -flto $layout $exact $warnings $include "$here/$program/bench.c" \
            "$here/bench.c" "$out/$program.c" "$here/$program/by_hand.c" $library -lm -o "$made$layout"
    done
    set -- $(middle_of_layouts "$made")
    row "step time" "$label" "$1" "$2" ns
    row "step instructions" "$label" "$(instructions "$made$usual" generated_pass)" \
        "$(instructions "$made$usual" by_hand_pass)" instructions
}

# All steps in one call, compared with a call for each step.
measure_batch() {
    compiler=$1
    made=$out/$program-$compiler-batch
    include="-I $out/batch -I $here -I $here/$program -I runtime/include"
    mkdir -p "$out/batch"
    "$frobc" compile --batch "$here/$program/$program.frob" -o "$out/batch"
    for layout in $layouts; do
        flags="-O2 $layout $exact"
        # shellcheck disable=SC2086
        {
            $compiler $flags $warnings $include -c "$out/batch/$program.c" -o "$made.o"
            $compiler $flags $warnings $include -DBENCH_BATCH "$here/$program/bench.c" "$here/bench.c" \
                "$made.o" $library -lm -o "$made$layout"
        }
    done
    set -- $(middle_of_layouts "$made")
    row "step time, many in a call" "$compiler -O2" "$1" "$2" ns
}

# The generated step, compared with the C that `copilot.hs` writes, compiled with the same options.
measure_copilot() {
    tool=$out/$program-copilot
    mkdir -p "$tool"
    ghc -v0 -i"$here" -outputdir "$tool" -o "$tool/write" "$here/$program/copilot.hs"
    (cd "$tool" && ./write)
    for compiler in gcc clang; do
        flags="-O2 $exact"
        include="-I $tool -I $out -I $here -I $here/$program -I runtime/include"
        # shellcheck disable=SC2086
        {
            $compiler $flags $include -c "$tool/copilot.c" -o "$tool/copilot.o"
            $compiler $flags $include "$here/$program/bench.c" "$here/bench.c" \
                "$here/$program/copilot_step.c" "$tool/copilot.o" \
                "$out/$program-$compiler-O2-generated.o" $library -lm -o "$tool/bench"
        }
        set -- $("$tool/bench" $((3 * rounds)))
        row "step time beside Copilot" "$compiler -O2" "$1" "$2" ns
        row "state beside Copilot" "$compiler -O2" "$3" \
            "$(size "$tool/copilot.o" | awk 'NR == 2 { print $2 + $3 }')" bytes
        row "text beside Copilot" "$compiler -O2" \
            "$(text_bytes "$out/$program-$compiler-O2-generated.o")" "$(text_bytes "$tool/copilot.o")" bytes
    done
}

# Size of the text for a microcontroller, with the usual options for one.
measure_cortex() {
    flags="-mcpu=cortex-m4 -mthumb -Os $exact $warnings"
    include="-I $out -I $here -I $here/$program -I runtime/include"
    # shellcheck disable=SC2086
    {
        arm-none-eabi-gcc $flags $include -c "$out/$program.c" -o "$out/$program-m4-generated.o"
        arm-none-eabi-gcc $flags $include -c "$here/$program/by_hand.c" -o "$out/$program-m4-by_hand.o"
    }
    row "text" "Cortex-M4" "$(text_bytes "$out/$program-m4-generated.o")" \
        "$(text_bytes "$out/$program-m4-by_hand.o")" bytes
}

skipped() {
    printf '{"program": "%s", "measure": "%s", "compiler": "%s", "value": null, "reference": null, "ratio": null, "unit": "skipped: not installed"}\n' \
        "$program" "$1" "$2"
}

has_copilot() {
    command -v ghc >/dev/null && ghc-pkg --simple-output list copilot-c99 2>/dev/null | grep -q copilot
}

if [ $# -eq 0 ]; then
    set -- wall_follow pid modes obstacles kalman events nested patrol bug distance clamped_pid weak_modes
fi
for program in "$@"; do
    "$frobc" compile "$here/$program/$program.frob" -o "$out"
    for level in $levels; do
        for compiler in gcc clang; do
            measure "$compiler" "$level"
            measure_linked "$compiler" "$level"
        done
    done
    measure_batch gcc
    measure_batch clang
    if [ -f "$here/$program/copilot.hs" ]; then
        if has_copilot; then measure_copilot; else skipped "step time beside Copilot" ghc; fi
    fi
    if command -v arm-none-eabi-gcc >/dev/null; then measure_cortex; else skipped "text" Cortex-M4; fi
done
