#!/bin/sh
# Stereo beside OpenCV's on the motorcycle pair of scikit-image. The argument is the folder to
# work in. The package is fetched once, and opened as the zip file that it is.
set -eu
python=/usr/bin/python3
work=$1
mkdir -p "$work"
if ! test -f "$work/skimage/data/motorcycle_disp.npz"; then
    $python -m pip download --quiet --no-deps --only-binary :all: --dest "$work" \
        scikit-image==0.25.2
    $python - "$work" <<'END'
import glob, sys, zipfile
package = zipfile.ZipFile(glob.glob(sys.argv[1] + "/scikit_image-*.whl")[0])
for name in ("left.png", "right.png", "disp.npz"):
    package.extract("skimage/data/motorcycle_" + name, sys.argv[1])
END
fi
sh tests/generated/bench/vision/run.sh "$work" >"$work/lines"
$python tests/generated/bench/vision/stereo.py "$work/kernels" "$work" "$work/skimage/data" \
    >>"$work/lines"
grep opencv "$work/lines" | awk -F'"' '
    BEGIN { printf "%-24s %10s %10s %7s\n", "", "Frob", "OpenCV", "ratio" }
    function number(text) { gsub(/[:, ]/, "", text); return text }
    { printf "%-24s %10s %10s %7s  %s\n", $8, number($15), number($17), number($19), $22 }'
