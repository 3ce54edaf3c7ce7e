#!/bin/sh
# Compiles one program, runs it on its recordings, and says what is wrong.
# usage: one.sh NAME COMPILER RUNNER WORK FOLDER (see run.sh)
set -u
name=$1 compiler=$2 runner=$3 work=$4 folder=$5
here=$(cd "$(dirname "$0")" && pwd)
made=$work/$name/$(basename "$folder")
mkdir -p "$made"
cp -L "$folder"/*.[ch] "$made"
[ "$name" != tcc ] || cp -L "$folder"/for_tcc/*.[ch] "$made"
# shellcheck disable=SC2086
if ! { $compiler -I "$here" -I "$work/include" -I "$made" -o "$made/run" \
    "$made"/*.c "$work/$name"/*.o -lm && $runner "$made/run"; } >"$made/said" 2>&1; then
    echo "$name, $(basename "$folder"):"
    head -20 "$made/said"
fi
rm -rf "$made"
