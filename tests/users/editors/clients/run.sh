#!/bin/sh
# run.sh FOLDER: runs third-party clients and tools on the editor support: pytest-lsp on the server,
# vscode-tmgrammar-test on the grammar, and a check of the packaged extension. Installs what they
# need from PyPI and npm in FOLDER; skips tools that are missing, with a message.
set -u
here=$(cd "$(dirname "$0")" && pwd)
editors=$(cd "$here/../../../../compiler/editors" && pwd)
mkdir -p "$1"
out=$(cd "$1" && pwd)
failed=0

left_out() { echo "left out: $1 ($2 is not at hand)"; }

python=$out/python/bin/python
if { test -x "$python" || python3 -m venv "$out/python"; } >"$out/python.log" 2>&1 &&
    "$python" -m pip install --quiet --disable-pip-version-check -r "$here/requirements.txt" \
        >>"$out/python.log" 2>&1; then
    "$python" -B -m pytest -q -p no:cacheprovider \
        -o asyncio_default_fixture_loop_scope=function "$here/test_server.py" || failed=1
else
    left_out "the server under pytest-lsp" PyPI
fi

mkdir -p "$out/npm"
if (cd "$out/npm" && npm install --no-audit --no-fund --silent --prefix . vscode-tmgrammar-test@0.1.3) \
    >"$out/npm.log" 2>&1; then
    "$out/npm/node_modules/.bin/vscode-tmgrammar-test" \
        -g "$editors/vscode/frob.tmLanguage.json" "$here/highlighting.test" || failed=1
    if sh "$editors/vscode/build.sh" "$out/vsix" >"$out/vsix.log" 2>&1; then
        python3 "$here/check_vsix.py" "$out/vsix/frob.vsix" "$(frobc --version)" || failed=1
    else
        cat "$out/vsix.log"
        failed=1
    fi
else
    left_out "the grammar and the extension for Visual Studio Code" npm
fi
exit $failed
