#!/bin/sh
# Tests the vision kernels on photographs: see pictures.py. Prints a table, and writes its rows as
# JSON to FOLDER/lines, one object a line; the argument is the working folder. The exit status is 1
# if a figure exceeds its limit. The pictures come from three packages, one from PyPI and two from
# Debian, which are downloaded once and unpacked in that folder, but not installed.
set -eu
here=$PWD/tests/generated/photographs
python=/usr/bin/python3
mkdir -p "$1"
work=$(cd "$1" && pwd)

if ! test -d "$work/skimage/data"; then
    $python -m pip download --quiet --no-deps --only-binary :all: --dest "$work" \
        scikit-image==0.25.2 --python-version 3.11
    $python -m zipfile -e "$work"/scikit_image-*.whl "$work/opened"
    mkdir -p "$work/skimage"
    mv "$work/opened/skimage/data" "$work/skimage/data"
    rm -rf "$work/opened"
fi
for package in opencv-doc visp-images-data; do
    if ! test -d "$work/$package"; then
        rm -rf "$work/fetched" "$work/opened"
        mkdir "$work/fetched"
        (cd "$work/fetched" && apt-get -qq download "$package")
        dpkg-deb -x "$work"/fetched/*.deb "$work/opened"
        mv "$work/opened" "$work/$package"
        rm -r "$work/fetched"
    fi
done

case $(uname -m) in x86_64) clones=-DFROB_VISION_CLONES ;; *) clones= ;; esac
gcc -shared -fPIC -std=c99 -D_GNU_SOURCE -O3 -ffp-contract=off $clones -Iruntime/include \
    runtime/vision/*.c runtime/elementary/*.c runtime/hosts/common/tag_finder.c -lm -ldl \
    -o "$work/kernels.so"
$python -B "$here/pictures.py" "$work/kernels.so" "$work/skimage/data" \
    "$work/opencv-doc/usr/share/doc/opencv-doc/examples/data" \
    "$work/visp-images-data/usr/share/visp-images-data/ViSP-images" >"$work/lines" || status=1
awk -F'"' '
    BEGIN { printf "%-56s %9s %9s %6s\n", "", "Frob", "beside", "ratio" }
    function number(text) { gsub(/[:, ]/, "", text); return text }
    { printf "%-56s %9s %9s %6s  %s\n", $8, number($15), number($17), number($19), $22 }' \
    "$work/lines"
exit ${status:-0}
