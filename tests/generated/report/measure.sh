#!/bin/sh
# measure.sh FILE...: compares what frobc report states about programs with the results of gcc for
# their C: the size of the state, the functions of the C library that they call, and the stack.
# Prints the differences; skips programs that frobc rejects. REAL, if set, is the floating-point
# type.

here=$(dirname "$0")
headers=$here/../../../runtime/include
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
measured=0
real=${REAL:-double}

stated() { sed "s/.*\"$1\":\([0-9]*\).*/\1/" "$work/report.json"; }
used() { awk -v root="$name$1" -f "$here/stack_used.awk" "$work"/*.ci; }

same() { # what stated found
    [ "$2" = "$3" ] || echo "$file: $1: stated $2, found $3"
}
at_most() { # what stated found
    [ "$3" -le "$2" ] || echo "$file: $1: stated $2, found $3"
}
build() {
    gcc -std=c99 -ffp-contract=off "$@" -I "$headers" -I "$(dirname "$file")" -fcallgraph-info=su \
        -c "$work/$name.c" -o "$work/$name.o"
}

for file; do
    name=$(basename "$file" .frob)
    rm -f "$work"/*
    frobc report "$file" --real "$real" --format=json >"$work/report.json" 2>"$work/errors"
    case $? in
        0) ;;
        1) continue ;; # other tests show why it is rejected
        *) cat "$work/errors"; continue ;;
    esac
    frobc compile "$file" --real "$real" -o "$work" 2>"$work/errors" || cat "$work/errors"
    measured=$((measured + 1))

    cat >"$work/size.c" <<END
#include <stdio.h>
#include "$name.h"
int main(void) { printf("%lu\n", (unsigned long)sizeof(struct ${name}_state)); return 0; }
END
    gcc -I "$headers" -I "$(dirname "$file")" "$work/size.c" -o "$work/size"
    same "bytes of state" "$(stated state_bytes)" "$("$work/size")"

    build -O0 -fno-builtin
    library=$(sed 's/.*"library":\[\([^]]*\)\].*/\1/' "$work/report.json" | tr -d '"' | tr ',' '\n' |
        sed 's/^frob_//' | LC_ALL=C sort | xargs)
    # gcc copies large structs with memcpy.
    found=$(awk -v library=1 -f "$here/stack_used.awk" "$work"/*.ci | grep -v '^mem' | sed 's/^frob_//' |
        if [ "$real" = float ]; then sed 's/f$//'; else cat; fi |
        LC_ALL=C sort | xargs)
    same "functions of the C library or the runtime" "$library" "$found"

    for level in -O0 -O2; do
        build $level
        at_most "stack of reset, $level" "$(stated reset_stack_bytes)" "$(used _reset)"
        at_most "stack of step, $level" "$(stated step_stack_bytes)" "$(used _step)"
    done
done
[ "$measured" -gt 0 ] && echo "all measured"
