#!/bin/sh
# Runs `frobc selftest` with the compilers that users have, in both precisions; for other machines,
# with qemu as the runner. All must succeed. Compilers that are not installed, or that lack
# libraries for such programs here (gcc -m32), are reported as skipped.
#
# usage: selftest.sh FROBC
#
# Prints a line for each, `ok`, `skipped` or `FAIL`; the exit status is 1 if any fails.
set -eu
frobc=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
exact="-std=c99 -ffp-contract=off"

# NAME | COMPILER | OPTIONS | RUNNER
compilers() {
    cat <<END
gcc-O3|gcc|$exact -O3|
gcc-Os|gcc|$exact -Os|
gcc-lto|gcc|$exact -O2 -flto|
gcc-m32|gcc|$exact -O2 -m32 -msse2 -mfpmath=sse|
gcc-11|gcc-11|$exact -O2|
clang-O2|clang|$exact -O2|
clang-O3|clang|$exact -O3|
clang-13|clang-13|$exact -O2|
clang-15|clang-15|$exact -O2|
clang-16|clang-16|$exact -O2|
clang-19|clang-19|$exact -O2|
clang-22|clang-22|$exact -O2|
tcc|tcc|-std=c99|
aarch64|aarch64-linux-gnu-gcc|$exact -O2 -static|qemu-aarch64
armhf|arm-linux-gnueabihf-gcc|$exact -O2 -static|qemu-arm
newlib|arm-none-eabi-gcc|$exact -O2 --specs=rdimon.specs|qemu-arm
END
}

can () { # COMPILER, OPTIONS
    echo 'int main(void) { return 0; }' >"$work/nothing.c"
    # shellcheck disable=SC2086
    $1 $2 -include stdio.h -o "$work/nothing" "$work/nothing.c" 2>"$work/said"
}

compilers >"$work/compilers"
while IFS='|' read -r name cc cflags runner; do
    if ! can "$cc" "$cflags"; then
        echo "skipped selftest $name"
        continue
    fi
    for real in double float; do
        if "$frobc" selftest --real $real --cc "$cc" --cflags "$cflags" ${runner:+--runner "$runner"} \
            </dev/null >"$work/said" 2>&1 && ! grep -q warning "$work/said"; then
            echo "ok selftest $name, $real"
        else
            echo "FAIL selftest $name, $real"
            cat "$work/said"
            failed=1
        fi
    done
done <"$work/compilers"
exit $failed
