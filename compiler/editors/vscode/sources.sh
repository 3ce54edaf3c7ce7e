#!/bin/sh
# sources.sh FOLDER: copies the sources of the extension into FOLDER and sets the version in
# package.json, which is 0.0.0 here, to the version in dune-project.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$here/../../..
version=$(sed -n 's/^(version \(.*\))$/\1/p' "$top/dune-project")
mkdir -p "$1"
cp -RL "$here"/. "$1"
cp "$top/LICENSE" "$1/LICENSE"
sed "s/^  \"version\": \"0\.0\.0\"/  \"version\": \"$version\"/" "$here/package.json" >"$1/package.json"
