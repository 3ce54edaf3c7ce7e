#!/bin/sh
# Checks that the pragma in generated C protects it from the gcc bug that shared_stack.c shows.
# Prints a line for each compiler, `ok` or `FAIL`, and whether the compiler has the bug without the
# pragma; the exit status is 1 if any fails.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
warnings="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"

is_right() { # COMPILER AND OPTIONS, RUNNER
    # shellcheck disable=SC2086
    $1 -std=c99 $warnings -static "$here/shared_stack.c" -o "$work/run" && $2 "$work/run" >"$work/said"
}

while IFS='|' read -r compiler runner; do
    for level in O1 O2 O3 Os; do
        fault="it has no fault"
        is_right "$compiler -$level -DSTRICT" "$runner" || fault="it has the fault otherwise"
        if is_right "$compiler -$level" "$runner"; then
            echo "ok shared stack, $compiler -$level: $fault"
        else
            echo "FAIL shared stack, $compiler -$level: $(cat "$work/said")"
            failed=1
        fi
    done
done <<END
gcc|
aarch64-linux-gnu-gcc|qemu-aarch64
arm-linux-gnueabihf-gcc|qemu-arm
END
exit $failed
