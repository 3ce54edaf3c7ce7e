#!/bin/sh
# The language server on a generated program of 2,000 lines: from a change to its messages, and
# from a question for a type to the answer, of 200 each, in which 95 of 100 are done, beside the
# aim; and how long the server itself works for each, whatever else the machine does. The argument is the folder to work in.
set -eu
generate=_build/default/tests/generated/bench/generate/generate.exe
mkdir -p "$1/lsp"
dune build ./tests/generated/bench/generate/generate.exe
"$generate" 2000 >"$1/lsp/lines_2000.frob"
PATH=$PWD/_build/install/default/bin:$PATH PYTHONPATH=tests/users/lsp PYTHONDONTWRITEBYTECODE=1 \
    python3 tests/generated/bench/lsp/latency.py "$1/lsp" 200
