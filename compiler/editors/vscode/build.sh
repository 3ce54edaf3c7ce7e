#!/bin/sh
# build.sh FOLDER: builds the extension and writes it to FOLDER/frob.vsix. Needs npm, which
# downloads packages the first time.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
out=$(cd "$1" && pwd)
sh "$here/sources.sh" "$out/vscode"
cd "$out/vscode"
if [ -f package-lock.json ]; then npm ci --no-audit --no-fund --silent; else npm install --no-audit --no-fund --silent; fi
npm run --silent bundle
npx --no-install vsce package --no-dependencies --skip-license --out "$out/frob.vsix" >"$out/vsce.log" 2>&1 ||
    { cat "$out/vsce.log" >&2; exit 1; }
echo "$out/frob.vsix"
