#!/bin/sh
# Runs every test and counts: the last line is `N passed, M failed`.
#
# Alcotest suites and C programs say themselves how many checks passed; cram
# files and golden files are one test each, and dune shows those that fail.
set -u
cd "$(dirname "$0")/.." || exit 1
log=$(mktemp)
trap 'rm -f "$log"' EXIT

dune build @install @runtest --force >"$log" 2>&1
status=$?
cat "$log"

cram=$(find tests -name '*.t' | wc -l)
golden=$(find tests -name 'dune*' -exec cat {} + | grep -c '(diff ')
awk -v files=$((cram + golden)) -v status="$status" '
    /^ok /   { passed++ }
    /^FAIL / { failed++ }
    # "Test Successful in 0.002s. 14 tests run." or "2 failures! in 0.004s. 14 tests run."
    / tests? run\.$/ {
        run = $(NF - 2)
        bad = ($2 ~ /^(failure|failures|error|errors)!?$/) ? $1 : 0
        passed += run - bad
        failed += bad
    }
    # A golden or cram file that differs.
    /^File "tests\/[^"]*", line 1, characters 0-0:$/ {
        if (!($2 in differs)) { differs[$2] = 1; broken++ }
    }
    END {
        passed += files - broken
        failed += broken
        if (status != 0 && failed == 0) failed = 1
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0
    }' "$log"
