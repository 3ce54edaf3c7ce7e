#!/bin/sh
# Runs every test and counts: the last line is `N passed, M failed`.
#
# Alcotest suites and C programs say themselves how many checks passed; cram
# files and golden files are one test each, and dune shows those that fail. What failed is
# named once more at the end, where it is seen.
set -u
cd "$(dirname "$0")/.." || exit 1
log=$(mktemp)
trap 'rm -f "$log"' EXIT

dune build @install @runtest --force >"$log" 2>&1
status=$?
cat "$log"

cram=$(find tests -name '*.t' | wc -l)
golden=$(find tests compiler -name 'dune*' -exec cat {} + | grep -c '(diff ')
awk -v files=$((cram + golden)) -v status="$status" '
    /^ok /   { passed++ }
    /^FAIL / { failed++; bad[++bads] = $0 }
    /\[FAIL\] |^Error: |^Fatal error: |^File "[^"]*dune", line / { bad[++bads] = $0 }
    # "Test Successful in 0.002s. 14 tests run." or "2 failures! in 0.004s. 14 tests run."
    / tests? run\.$/ {
        run = $(NF - 2)
        wrong = ($2 ~ /^(failure|failures|error|errors)!?$/) ? $1 : 0
        passed += run - wrong
        failed += wrong
    }
    # A golden or cram file that differs.
    /^File "[^"]*", line 1, characters 0-0:$/ {
        if (!($2 in differs)) { differs[$2] = 1; broken++; bad[++bads] = $2 " differs" }
    }
    END {
        passed += files - broken
        failed += broken
        if (status != 0 && failed == 0) failed = 1
        for (i = 1; i <= bads && failed > 0; i++)
            if (!(bad[i] in told)) { told[bad[i]] = 1; print "failed: " bad[i] }
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0
    }' "$log"
