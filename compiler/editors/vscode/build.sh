#!/bin/sh
# Makes the extension as a file to install: build.sh FOLDER puts frob.vsix there. Needs npm, and
# the network for it once.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
out=$(cd "$1" && pwd)
mkdir -p "$out/vscode"
cp -R "$here"/. "$out/vscode/"
cp "$here/../../../LICENSE" "$out/vscode/LICENSE"
cd "$out/vscode"
if [ -f package-lock.json ]; then npm ci --no-audit --no-fund --silent; else npm install --no-audit --no-fund --silent; fi
npm run --silent bundle
npx --no-install vsce package --no-dependencies --skip-license --out "$out/frob.vsix" >"$out/vsce.log" 2>&1 ||
    { cat "$out/vsce.log" >&2; exit 1; }
echo "$out/frob.vsix"
