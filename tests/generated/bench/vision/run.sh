#!/bin/sh
# Measures the vision kernels in milliseconds, compared with the goals; and, if Debian's Python has
# OpenCV, compares stereo with its StereoBM. The argument is the working folder.
set -eu
here=tests/generated/bench/vision
case $(uname -m) in x86_64) clones=-DFROB_VISION_CLONES ;; *) clones= ;; esac
gcc -std=c99 -D_POSIX_C_SOURCE=200809L -O3 -ffp-contract=off $clones -Iruntime/include \
    "$here/kernels.c" runtime/vision/*.c runtime/elementary/*.c -lm -o "$1/kernels"
"$1/kernels"
python=/usr/bin/python3
if test -x $python && $python -c 'import cv2' 2>/dev/null; then
    $python "$here/stereo.py" "$1/kernels" "$1"
fi
