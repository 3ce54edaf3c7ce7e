#!/bin/sh
# Measures how many controllers with a planted fault the trials of the examples without cameras
# catch; see faults.py. The arguments are the working folder, the number of faults, and a seed.
set -eu
out=$1/faults
rm -rf "$out"
mkdir -p "$out"
XDG_CACHE_HOME=$PWD/$out/cache python3 -B tests/generated/bench/faults/faults.py \
    "${FROBC:-_build/install/default/bin/frobc}" "$out" "${2:-200}" "${3:-1}"
rm -rf "$out"
