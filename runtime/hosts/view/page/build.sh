#!/bin/sh
# usage: build.sh WORK OUT : the page's bundle, from the sources beside this file, with the
# packages of package-lock.json, which npm puts into the folder WORK.
set -eu
sources=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1" "$2"
out=$(cd "$2" && pwd)
rm -f "$1"/*.ts
for folder in camera map operate signals source time; do
    rm -rf "$1/$folder"
    cp -r "$sources/$folder" "$1"
done
cp "$sources"/*.ts "$sources"/*.css "$sources"/*.html "$sources"/*.svg "$sources"/*.json "$sources"/*.mjs "$1"
cd "$1"
npm ci --silent --no-audit --no-fund
npx tsc
node bundle.mjs "$out"
