#!/bin/sh
# Compares the rules of MISRA C that generated C violates with the table of deviations.
#
# usage: misra.sh FROBC RUNTIME PAGE PROGRAM.frob…
#
# A rule that cppcheck reports for one of the programs needs a row in the table of PAGE
# (docs/generated-c.md). Each row needs a finding, so that the table lists no rule that generated C
# obeys. The rows below are exceptions. Prints what differs; the exit status is 1 if anything does.
# Without cppcheck it says that the test is skipped.
set -eu
frobc=$1 runtime=$2 page=$3
shift 3

# Rules that cppcheck does not check (10.4), that only other programs violate (8.14), or that only
# cppcheck 2.10 (2.4) or 2.17 (8.7, 17.3) reports. cppcheck's own rules depend on the version, too.
exceptions='misra-c2012-2.4 misra-c2012-8.7 misra-c2012-8.14 misra-c2012-10.4 misra-c2012-17.3
    clarifyCondition identicalInnerCondition knownConditionTrueFalse multiCondition'

if ! command -v cppcheck >/dev/null; then
    echo "skipped: tests/generated/prove/misra.sh needs cppcheck (Debian package cppcheck)" >&2
    exit 0
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for program; do
    "$frobc" compile "$program" -o "$work"
done
cd "$work"
case $runtime in /*) ;; *) runtime=$OLDPWD/$runtime ;; esac
case $page in /*) ;; *) page=$OLDPWD/$page ;; esac

# One process for each file, as `cppcheck -j` does not run checks of the whole program.
printf '%s\n' *.c | xargs -P "$(nproc)" -I FILE sh -c '
    cppcheck -q --enable=warning,style,portability --addon=misra --std=c99 --platform=unix64 \
        --suppress=missingIncludeSystem -I "$1/include" "$2" >"$2.found" 2>&1' sh "$runtime" FILE
cat ./*.found | sed -n 's/.*\[\([a-zA-Z]*\)\]$/\1/p; s/.*\[\(misra-c2012-[0-9.]*\)\]$/\1/p' |
    sort -u >reported
if ! grep -q '^misra' reported; then
    echo "cppcheck reports no rule of MISRA C; it says:"
    cat ./*.found
    exit 1
fi
sed -n 's/^| \([0-9]*\.[0-9]*\) |.*/misra-c2012-\1/p; s/^| `\([a-zA-Z]*\)` | .*cppcheck.*/\1/p' \
    "$page" | sort >rows
# shellcheck disable=SC2086
printf '%s\n' $exceptions | sort >exceptions

status=0
for rule in $(comm -13 rows reported); do
    status=1
    echo "$rule has no row in docs/generated-c.md:"
    grep -h -F "[$rule]" ./*.found | head -3
done
for rule in $(comm -23 rows reported | comm -23 - exceptions); do
    status=1
    echo "$rule has a row in docs/generated-c.md, but cppcheck does not report it"
done
exit $status
