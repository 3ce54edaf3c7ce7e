#!/bin/sh
# Proves properties of generated C and of the clamp by static analysis, for every input, and checks
# the C against MISRA C. docs/generated-c.md, "What is proven", explains the results and their
# assumptions.
#
# usage: run.sh FROBC RUNTIME PAGE PROGRAM.frob[:ROBOT]…
#
# ROBOT is for programs that leave their robot open. Files without a main are modules and are
# skipped. PAGE is that page; the C may break only those rules of MISRA C that have a row in it.
# Prints a line for each check, `ok` or `FAIL`; the exit status is 1 if any fails. Requires cppcheck
# and frama-c; without frama-c it checks only MISRA C and says so.
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

# Arguments: NAME INCLUDES FILES…. Writes the alarms to $work/NAME.alarms, one a line. Arithmetic
# may produce NaN and infinities; a bool from the caller may have any bits. __GNUC__ is undefined,
# so that generated C has no gcc attributes, which the analysis does not know.
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

# Prints the struct type of this parameter of the step function.
parameter() { # in|out, header
    grep -o "struct [A-Za-z0-9_]* \*\(restrict \)\{0,1\}$1[,)]" "$2" | tail -1 | cut -d' ' -f2
}

# Proves the program that was compiled to $made.
prove() {
    # If the program has parameters, they may have any values, but the caller must pass valid
    # booleans.
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
        int64_t dt_ns;
        Frama_C_make_unknown((char *)&in, sizeof in);
        Frama_C_make_unknown((char *)&dt, sizeof dt);
        Frama_C_make_unknown((char *)&dt_ns, sizeof dt_ns);
        if (Frama_C_nondet(0, 1))
            ${name}_reset(&state$by);
        if (dt == dt && Frama_C_nondet(0, 1))
            ${name}_step(&state$by, dt, &in, &out);
        else if (dt == dt)
            ${name}_step_ns(&state$by, dt_ns, dt, &in, &out);
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
        echo "FAIL $name: does not compile"
        return
    }
    if [ -n "$has_analysis" ]; then prove; fi
    cppcheck -q --enable=warning,style,portability --addon=misra --std=c99 --platform=unix64 \
        --suppress=missingIncludeSystem -I "$runtime/include" -I "$folder" \
        "$made/$name.c" 2>&1 | grep -E "^($made|$runtime/include)/.*\]\$" >"$work/$name.findings" || :
    sed 's/.*\[\(.*\)\]$/\1/' "$work/$name.findings" | sort -u >"$work/$name.rules"
    new=$(comm -13 "$work/argued" "$work/$name.rules")
    if [ -n "$new" ]; then
        echo "FAIL $name: docs/generated-c.md does not justify these findings"
        for rule in $new; do grep -F "[$rule]" "$work/$name.findings" | head -3; done
    else
        echo "ok $name: MISRA C reports the known findings, of $(wc -l <"$work/$name.rules") rules"
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
    # Check that a proof can fail: a clamp that allows twice the limit on one side.
    mkdir -p "$work/wrong/core"
    sed 's/? most : -most/? most : -2.0 * most/' "$runtime/core/robot.c" >"$work/wrong/core/robot.c"
    analyse wrong_clamp "-I $work/wrong" "$here/clamp.c"
    if [ -s "$work/wrong_clamp.alarms" ]; then
        echo "ok wrong_clamp: found" >>"$work/said"
    else
        echo "FAIL wrong_clamp: not found" >>"$work/said"
    fi
else
    echo "skipped: undefined behaviour and the clamp, because frama-c is not installed" >"$work/said"
fi
tell

for program; do
    ! grep -q '^main' "${program%%:*}" || echo "$program"
done | xargs -P "$(nproc)" -n 1 sh "$here/run.sh" --one >"$work/said" 2>&1 || failed=1
tell
exit $failed
