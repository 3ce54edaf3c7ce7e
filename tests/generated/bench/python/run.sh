#!/bin/sh
# Compares programs that Python runs on arrays with a loop in C. Requires numpy.
set -eu
here=tests/generated/bench/python
python=/usr/bin/python3
if test -x $python && $python -c 'import numpy' 2>/dev/null; then
    FROBC=$PWD/_build/install/default/bin/frobc PYTHONPATH=runtime/python \
        $python -B $here/speed.py \
        tests/generated/bench/step/pid/pid.frob tests/generated/bench/step/kalman/kalman.frob
fi
