#!/bin/sh
# What is proven of generated C and of the clamp, by analysis for every input, and
# what MISRA C says of it. docs/generated-c.md, "What is proven", has the meaning
# and the assumptions.
#
# usage: run.sh FROBC RUNTIME PAGE PROGRAM.frob[:ROBOT]…
#
# A program that leaves its robot open is taken for the one that is named.
# Files without a main are modules, and left out. PAGE is that page: of MISRA C's rules those may be broken that it has a row for.
# Prints a line for each, `ok` or `FAIL`; the exit status is 1 if any fails. Needs
# cppcheck, and frama-c: without that only MISRA C is asked, and a line says so.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
if [ "$1" != --one ]; then
    frobc=$1 runtime=$2 page=$3
    shift 3
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    sed -n 's/^| \([0-9]*\.[0-9]*\) |.*/misra-c2012-\1/p; s/^| `\([a-zA-Z]*\)` | .*cppcheck.*/\1/p' \
        "$page" | sort >"$work/argued"
    has_analysis=$(command -v frama-c || :)
    export frobc runtime work has_analysis
fi

# NAME INCLUDES FILES…: the alarms go to $work/NAME.alarms, one a line. Arithmetic
# may give NaN and infinities; a bool that the caller gives may have any bits.
# Without __GNUC__, generated C has no hints for gcc, which the analysis does not know.
analyse() {
    name=$1 includes=$2
    shift 2
    if ! frama-c -eva -eva-precision 3 -eva-auto-loop-unroll 1024 -machdep x86_64 \
        -warn-special-float none -no-warn-invalid-bool \
        -cpp-extra-args="-U__GNUC__ $includes -I $runtime -I $runtime/include" \
        "$@" >"$work/$name.log" 2>&1 || ! grep -q 'alarms\{0,1\} generated' "$work/$name.log"; then
        echo "the analysis failed:" >"$work/$name.alarms"
        tail -5 "$work/$name.log" >>"$work/$name.alarms"
        return
    fi
    sed -n '/^\[eva:alarm\]/{N;s/\n */ /;p;}' "$work/$name.log" >"$work/$name.alarms"
}

verdict() { # NAME, and what is proven
    if [ -s "$work/$1.alarms" ]; then
        echo "FAIL $1"
        cat "$work/$1.alarms"
    else
        echo "ok $1: $2"
    fi
}

# The struct that the step function takes as this parameter.
parameter() { # in|out, header
    grep -o "struct [A-Za-z0-9_]* \*\(restrict \)\{0,1\}$1[,)]" "$2" | tail -1 | cut -d' ' -f2
}

# The program that was compiled to $made.
prove() {
    # Any values of its parameters, if it has some; truth values are the caller's duty.
    if grep -q "^struct ${name}_params {" "$made/$name.h"; then
        params="static struct ${name}_params params;" by=", &params"
    else
        params="" by=""
    fi
    cat >"$made/main.c" <<END
#include "$name.h"
#include <__fc_builtin.h>

static struct ${name}_state state;
$params
static struct $(parameter in "$made/$name.h") in;
static struct $(parameter out "$made/$name.h") out;

int main(void)
{
    ${by:+Frama_C_make_unknown((char *)&params, sizeof params);}
    ${name}_reset(&state$by);
    while (Frama_C_nondet(0, 1)) {
        double dt;
        Frama_C_make_unknown((char *)&in, sizeof in);
        Frama_C_make_unknown((char *)&dt, sizeof dt);
        if (Frama_C_nondet(0, 1))
            ${name}_reset(&state$by);
        if (dt == dt)
            ${name}_step(&state$by, dt, &in, &out);
    }
    return 0;
}
END
    called=$(! grep -q '^foreign' "$file" || find "$folder" -name '*.c' ! -name main.c)
    # shellcheck disable=SC2086
    analyse "$name" "-I $made -I $folder" "$made/main.c" "$made/$name.c" $called \
        "$runtime"/elementary/*.c
    verdict "$name" "no undefined behaviour, for any input"
}

program() { # PROGRAM.frob[:ROBOT]
    file=${1%%:*} robot=${1#"${1%%:*}"}
    name=$(basename "$file" .frob) folder=$(dirname "$file")
    made=$work/$name
    mkdir "$made"
    "$frobc" compile "$file" ${robot:+--robot "${robot#:}"} -o "$made" || {
        echo "FAIL $name: is not compiled"
        return
    }
    if [ -n "$has_analysis" ]; then prove; fi
    cppcheck -q --enable=warning,style,portability --addon=misra --std=c99 --platform=unix64 \
        --suppress=missingIncludeSystem -I "$runtime/include" -I "$folder" \
        "$made/$name.c" 2>&1 | grep -E "^($made|$runtime/include)/.*\]\$" >"$work/$name.findings" || :
    sed 's/.*\[\(.*\)\]$/\1/' "$work/$name.findings" | sort -u >"$work/$name.rules"
    new=$(comm -13 "$work/argued" "$work/$name.rules")
    if [ -n "$new" ]; then
        echo "FAIL $name: findings of rules that docs/generated-c.md does not argue"
        for rule in $new; do grep -F "[$rule]" "$work/$name.findings" | head -3; done
    else
        echo "ok $name: MISRA C finds what is known, by $(wc -l <"$work/$name.rules") rules"
    fi
}

if [ "$1" = --one ]; then
    program "$2"
    exit 0
fi

failed=0
tell() {
    cat "$work/said"
    ! grep -q ^FAIL "$work/said" || failed=1
}

if [ -n "$has_analysis" ]; then
    analyse clamp "" "$here/clamp.c"
    verdict clamp "what moves a robot is finite and within its limits" >"$work/said"
    # That this can fail: a clamp that lets twice as much pass on one side.
    mkdir -p "$work/wrong/core"
    sed 's/? most : -most/? most : -2.0 * most/' "$runtime/core/robot.c" >"$work/wrong/core/robot.c"
    analyse wrong_clamp "-I $work/wrong" "$here/clamp.c"
    if [ -s "$work/wrong_clamp.alarms" ]; then
        echo "ok wrong_clamp: is found" >>"$work/said"
    else
        echo "FAIL wrong_clamp: is not found" >>"$work/said"
    fi
else
    echo "left out: that nothing is undefined, and the clamp; there is no frama-c on this system" >"$work/said"
fi
tell

for program; do
    ! grep -q '^main' "${program%%:*}" || echo "$program"
done | xargs -P "$(nproc)" -n 1 sh "$here/run.sh" --one >"$work/said" 2>&1 || failed=1
tell
exit $failed
