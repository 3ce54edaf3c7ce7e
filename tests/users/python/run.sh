#!/bin/sh
# usage: run.sh ROOT WRITTEN : runs these tests with Debian's Python, because it has the packages.
set -eu
python=/usr/bin/python3
test -x $python || python=python3
if ! $python -c "import numpy, pandas" 2>/dev/null; then
    echo "ok   the Python package (skipped: no numpy, pandas)"
    exit 0
fi
examples=$1/examples
interp=$1/tests/meaning/interp
"$2" 4 \
    "$examples/wall_follow/wall_follow.frob" "$examples/patrol/patrol.frob" \
    "$examples/line_follow/line_follow.frob:create" "$examples/safe_stick/safe_stick.frob:pioneer" \
    "$interp/arrays_in_values.frob" "$interp/arrays_of_any_size.frob" \
    "$interp/arrays_of_events.frob" "$interp/comparison_of_data.frob" \
    "$interp/state_of_every_type.frob" "$interp/tasks_with_parameters.frob" \
    "$interp/numbers_are_total.frob"
export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$1/runtime/python" FROB_ROOT="$1"
for test in test_*.py; do
    if test "$test" = test_cluster.py && ! $python -c "import distributed" 2>/dev/null; then
        echo "ok   sweeps on a Dask cluster (skipped: no distributed; \`make python\` installs it from PyPI)"
        continue
    fi
    $python -W error "$test"
done
