#!/bin/sh
# usage: build.sh WORK OUT
# Builds the page's bundle in OUT from the sources in this folder. npm installs the packages of
# package-lock.json in the folder WORK.
set -eu
sources=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1" "$2"
out=$(cd "$2" && pwd)
rm -f "$1"/*.ts
for folder in camera map operate plots save signals source time; do
    rm -rf "$1/$folder"
    cp -r "$sources/$folder" "$1"
done
cp "$sources"/*.ts "$sources"/*.css "$sources"/*.html "$sources"/*.svg "$sources"/*.json "$sources"/*.mjs "$1"
{
    echo "// Made by build.sh from console_kinds.h."
    echo "/** The kinds of things that a program has on its console. */"
    sed -n 's/^ *KIND(FROB_[A-Z_]*, \("[a-z]*"\)).*/\1/p' "$sources/../console_kinds.h" |
        paste -s -d '|' | sed 's/.*/export type ControlKind = &;/'
} >"$1/operate/kinds.ts"
cd "$1"
npm ci --silent --no-audit --no-fund
npx tsc
node bundle.mjs "$out"
