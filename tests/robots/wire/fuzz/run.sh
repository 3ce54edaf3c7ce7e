#!/bin/sh
# run.sh FOLDER BYTES SEED ROBOT...: fuzzes the wire format of each robot with at least BYTES bytes,
# under sanitizers, and prints a line for each. Input that fails is kept in the folder, and its path
# printed.
set -u
folder=$1 bytes=$2 seed=$3
shift 3
status=0
for robot in "$@"; do
    corpus=$(mktemp -d)
    log=$corpus.log
    if FUZZ_BYTES=$bytes "$folder/fuzz_$robot" -seed="$seed" -max_len=16384 -len_control=0 \
        -artifact_prefix="$corpus/" "$corpus" >"$log" 2>&1 &&
        counted=$(grep -E '^[0-9]+ bytes$' "$log"); then
        echo "ok wire format of the $robot: $counted, under sanitizers"
        rm -rf "$corpus" "$log"
    else
        tail -n 40 "$log"
        echo "FAIL wire format of the $robot: log $log, input in $corpus"
        status=1
    fi
done
exit $status
