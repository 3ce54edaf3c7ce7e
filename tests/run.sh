#!/bin/sh
# Runs every test and counts the results: the last line is `N passed, M failed`.
#
# Alcotest suites and C programs print how many checks passed. Each cram file and golden file counts
# as one test; dune shows those that fail. At the end the script names all failures again.
set -u
cd "$(dirname "$0")/.." || exit 1
log=$(mktemp)
trap 'rm -f "$log"' EXIT

# Use one more job than processors, because real-time tests mostly wait.
# If the caller ignores SIGPIPE, as some services do, `yes | head` would print an error in tests.
env --default-signal=PIPE \
    dune build -j $(($(nproc) + 1)) @install @runtest --force >"$log" 2>&1
status=$?
sh tests/formatters/format.sh --check >>"$log" 2>&1
cat "$log"

cram=$(find tests -name '*.t' | wc -l)
golden=$(find tests compiler -name 'dune*' -exec cat {} + | grep -c '(diff ')
awk -v files=$((cram + golden)) -v status="$status" '
    /^ok /   { passed++ }
    /^FAIL / { failed++; bad[++bads] = $0 }
    /\[FAIL\] |^Error: |^Fatal error: |^File "[^"]*dune[^"]*", line / { bad[++bads] = $0 }
    # A program that ended without a report, for example with a traceback. The next line names it.
    / alias [^ ]+ \(exit [0-9]+\)$/ { getline; bad[++bads] = $0 }
    # Lines in which dune may say why a command failed. They are shown only if nothing else gives a
    # reason.
    /^File "|^Command (exited|got)|^Alert|^make|signal [A-Z]|[Tt]imeout|rror:/ { clue[++clues] = $0 }
    # "Test Successful in 0.002s. 14 tests run." or "2 failures! in 0.004s. 14 tests run."
    / tests? run\.$/ {
        run = $(NF - 2)
        wrong = ($2 ~ /^(failure|failures|error|errors)!?$/) ? $1 : 0
        passed += run - wrong
        failed += wrong
    }
    # A golden or cram file differs. A test that prints half a line may have begun the line.
    /File "[^"]*", line 1, characters 0-0:$/ {
        file = $(NF - 4)
        if (!(file in differs)) { differs[file] = 1; broken++; bad[++bads] = file " differs" }
    }
    END {
        passed += files - broken
        failed += broken
        # dune ends with 1 if a test fails. With any other status it did not run all of them.
        if (status > 1) {
            failed++
            bad[++bads] = "dune ended with status " status ", so some tests did not run"
        }
        if (status != 0 && failed == 0) failed = 1
        if (status != 0 && bads == 0) {
            bad[++bads] = "dune exited with " status " and named no test"
            for (i = clues > 20 ? clues - 19 : 1; i <= clues; i++) bad[++bads] = "perhaps: " clue[i]
        }
        for (i = 1; i <= bads && failed > 0; i++)
            if (!(bad[i] in told)) { told[bad[i]] = 1; print "failed: " bad[i] }
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0
    }' "$log"
