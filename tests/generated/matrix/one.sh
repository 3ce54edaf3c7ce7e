#!/bin/sh
# Compiles one program, runs it on its recordings, and writes any failure to WORK/wrong. The final
# state must be the same as with the first compiler. usage: one.sh NAME COMPILER RUNNER WORK FOLDER
# (see run.sh)
set -u
name=$1 compiler=$2 runner=$3 work=$4 folder=$5
here=$(cd "$(dirname "$0")" && pwd)
exec >"$work/wrong/$(basename "$folder")"
made=$work/$name/$(basename "$folder")
mkdir -p "$made"
cp -L "$folder"/*.[ch] "$made"
case $name in *tcc) cp -L "$folder"/for_tcc/*.[ch] "$made" ;; esac
# shellcheck disable=SC2086
if ! { $compiler -I "$here" -I "$work/include" -I "$made" -o "$made/run" \
    "$made"/*.c "$work/$name"/*.o -lm && $runner "$made/run"; } >"$made/said" 2>&1; then
    echo "$name, $(basename "$folder"):"
    grep -v '^state ' "$made/said" | head -20
else
    grep '^state ' "$made/said" | tr -d '\r' >"$made/state"
    first=$work/states/$(basename "$folder")
    if [ ! -e "$first" ]; then
        echo "$name" | cat "$made/state" - >"$first"
    elif ! sed '$d' "$first" | cmp -s - "$made/state"; then
        echo "$name, $(basename "$folder"): the state differs from that under $(sed -n '$p' "$first")"
    fi
fi
rm -rf "$made"
