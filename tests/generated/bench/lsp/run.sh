#!/bin/sh
# Measures the language server on a generated program of 2,000 lines: the time from a change to its
# diagnostics, and from a query for a type to the answer. Reports the 95th percentile of 200 each,
# compared with the goal, and the server's own processor time for each, which does not depend on the
# machine's load. The argument is the working folder.
set -eu
times=200
test -z "${SHORT:-}" || times=4
generate=_build/default/tests/generated/bench/generate/generate.exe
mkdir -p "$1/lsp"
dune build ./tests/generated/bench/generate/generate.exe
"$generate" 2000 >"$1/lsp/lines_2000.frob"
PATH=$PWD/_build/install/default/bin:$PATH PYTHONPATH=tests/users/lsp PYTHONDONTWRITEBYTECODE=1 \
    python3 tests/generated/bench/lsp/latency.py "$1/lsp" $times
