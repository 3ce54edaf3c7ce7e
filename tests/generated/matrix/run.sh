#!/bin/sh
# Checks that programs have the same meaning everywhere: runs random programs and those of FILES, on
# recorded input, with many compilers and on many machines, and compares the outputs with those of
# the reference interpreter. The interpreter does not have the fields of the state, so their values
# after each instant are compared with those of the first build.
#
# usage: run.sh EMIT LIBRARY RUNTIME COUNT SEED BUILD,BUILD… FILES…
#
# BUILD is one of the names below, or `all`. Prints a line for each build, `ok` or `FAIL`; the exit
# status is 1 if any fails.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
emit=$1 library=$2 runtime=$3 count=$4 seed=$5 wanted=$6
shift 6
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
exact="-std=c99 -ffp-contract=off"
warnings="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"

# NAME | COMPILER AND OPTIONS | RUNNER | RUN ONE PROGRAM IN THIS MANY
builds() {
    cat <<END
gcc-O0|gcc $exact -O0 $warnings||1
gcc-O2|gcc $exact -O2 $warnings||1
gcc-O3|gcc $exact -O3 $warnings||1
clang-O0|clang $exact -O0 $warnings||1
clang-O3|clang $exact -O3 $warnings||1
tcc|tcc -std=c99||1
frob-tcc|${FROB_TCC:-frob-tcc} $exact||1
sanitizers|gcc $exact -O1 -g -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all||1
valgrind|gcc $exact -O1 -g|valgrind -q --error-exitcode=9|10
aarch64|aarch64-linux-gnu-gcc $exact -O2 $warnings -static|qemu-aarch64|1
aarch64-Os|aarch64-linux-gnu-gcc $exact -Os $warnings -static|qemu-aarch64|1
armhf|arm-linux-gnueabihf-gcc $exact -O2 $warnings -static|qemu-arm|1
cortex-m4|arm-none-eabi-gcc $exact -O2 $warnings -mthumb -mcpu=cortex-m4 --specs=rdimon.specs -T $here/cortex_m.ld|sh $here/on_cortex_m.sh|1
cortex-m4f|arm-none-eabi-gcc $exact -O2 $warnings -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard --specs=rdimon.specs -T $here/cortex_m.ld|sh $here/on_cortex_m.sh|1
END
}

mkdir "$work/programs" "$work/states"
cp -rL "$runtime/include" "$work/include"
"$emit" --library "$library" --runtime "$runtime" --out "$work/programs" \
    --count "$count" --seed "$seed" "$@"
find "$work/programs" -mindepth 1 -maxdepth 1 -type d | sort >"$work/folders"

# Compiles the code that all programs are linked with.
common() { # NAME, COMPILER
    mkdir "$work/$1"
    sources="$here/runner.c $runtime/core/text.c $runtime/core/cell_read.c
        $runtime/core/cell_write.c $runtime/core/frame.c $runtime/core/trace.c $runtime/core/console.c $runtime/elementary/*.c"
    case "$1" in cortex-m4*) sources="$sources $here/cortex_m.c" ;; esac
    for source in $sources; do
        # shellcheck disable=SC2086
        ${2%% -T*} -I "$here" -I "$work/include" -c "$source" -o "$work/$1/$(basename "$source" .c).o"
    done
}

failed=0
builds >"$work/builds"
while IFS='|' read -r name compiler runner every; do
    case ",$wanted," in
    *",all,"*) [ "$name" != frob-tcc ] || [ -n "${FROB_TCC-}" ] || continue ;;
    *",$name,"*) ;;
    *) continue ;;
    esac
    common "$name" "$compiler"
    awk -v every="$every" 'NR % every == 1 % every' "$work/folders" >"$work/chosen"
    mkdir "$work/wrong"
    xargs -r -P "$(nproc)" -n 1 sh "$here/one.sh" "$name" "$compiler" "$runner" "$work" \
        <"$work/chosen"
    rm -rf "${work:?}/$name"
    find "$work/wrong" -type f -size +0 | sort >"$work/failures"
    if [ -s "$work/failures" ]; then
        echo "FAIL $name"
        xargs cat <"$work/failures"
        failed=1
    else
        echo "ok $name: $(wc -l <"$work/chosen") modules"
    fi
    rm -r "$work/wrong"
done <"$work/builds"
exit $failed
