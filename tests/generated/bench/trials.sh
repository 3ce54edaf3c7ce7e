#!/bin/sh
# Measures the processor time of `frobc test` on all examples with 100 seeds each. Examples with
# cameras take long, so they run with two seeds, and the result is scaled. All are compiled
# beforehand. Leaves out examples with C code of their own, which need further options.
set -eu
frobc=_build/install/default/bin/frobc
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

seconds() { # example, seeds
    "$frobc" test "$1" --seeds 1 --keep "$work/failed" >"$work/said" || { cat "$work/said"; exit 1; }
    /usr/bin/env bash -c 'TIMEFORMAT="%U %S"; time "$@" >/dev/null' - \
        "$frobc" test "$1" --seeds "$2" --keep "$work/failed" 2>&1 | awk '{ print $1 + $2 }'
}

row() { # name, seconds
    printf '{"program": "%s", "measure": "100 seeds", "compiler": "gcc", "value": %s, "reference": 0, "ratio": 0, "unit": "s"}\n' "$1" "$2"
}

plain=0 seeing=0
# The trials of a program may be in its test file.
programs() { grep -l '^trial' examples/*/*.frob | sed 's/\.test\.frob$/.frob/' | sort -u; }

for example in $(programs); do
    name=$(basename "$example" .frob)
    if ls "$(dirname "$example")"/*.c >/dev/null 2>&1; then continue; fi
    if grep -q '^\[camera\]\|^\[stereo\]' "$(dirname "$example")/world.toml"; then
        value=$(seconds "$example" 2 | awk '{ print 50 * $1 }')
        seeing=$(awk "BEGIN { print $seeing + $value }")
    else
        value=$(seconds "$example" 100)
        plain=$(awk "BEGIN { print $plain + $value }")
    fi
    row "$name" "$value"
done
row "all without cameras" "$plain"
row "all with cameras" "$seeing"
