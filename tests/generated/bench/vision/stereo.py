"""Stereo beside OpenCV's StereoBM: one core each, the least time of 15, the same window,
disparities, check from the right and uniqueness. Prints JSON, one object a line.

    stereo.py KERNELS FOLDER [PICTURES]

KERNELS is the program kernels.c, FOLDER where to work. With PICTURES, the folder `data` of the
package scikit-image, also what share of its motorcycle pair (Scharstein et al., 2014) is wrong.
Without, time only, on a random pair.
"""
import json
import subprocess
import sys
import time

import cv2
import numpy as np


def opencv(left, right, disparities, window):
    matcher = cv2.StereoBM_create(disparities, window)
    matcher.setDisp12MaxDiff(1)
    matcher.setUniquenessRatio(10)
    times = []
    for _ in range(15):
        start = time.perf_counter()
        found = matcher.compute(left, right)
        times.append((time.perf_counter() - start) * 1e3)
    return min(times), found


def own(left, right, disparities, window):
    height, width = left.shape
    files = [f"{folder}/{name}" for name in ("left", "right", "found")]
    left.tofile(files[0])
    right.tofile(files[1])
    numbers = [str(n) for n in (width, height, disparities, window)]
    done = subprocess.run([kernels, *numbers, *files], check=True, capture_output=True, text=True)
    return float(done.stdout), np.fromfile(files[2], dtype=np.int16).reshape(height, width)


def row(measure, value, reference, unit):
    print(json.dumps({"program": "vision", "measure": measure, "compiler": "opencv",
                      "value": round(value, 4), "reference": round(reference, 4),
                      "ratio": round(value / reference, 2), "unit": unit}))


def judged(found, truth):
    """The shares of pixels that are known, and of these that are more than 2 pixels wrong."""
    sure = np.isfinite(truth)
    known = sure & (found >= 0)
    wrong = known & (np.abs(found / 16 - truth) > 2)
    return known.sum() / sure.sum(), wrong.sum() / known.sum()


kernels, folder = sys.argv[1:3]
cv2.setNumThreads(1)

if len(sys.argv) == 3:
    texture = np.random.default_rng(1).integers(0, 256, (240, 400), dtype=np.uint8)
    texture = cv2.GaussianBlur(texture, (0, 0), 1.2)
    pair = np.ascontiguousarray(texture[:, :320]), np.ascontiguousarray(texture[:, 9:329])
    row("stereo 320x240x32", own(*pair, 32, 9)[0], opencv(*pair, 32, 9)[0], "ms")
else:
    data = sys.argv[3]
    pair = [cv2.imread(f"{data}/motorcycle_{side}.png", 0) for side in ("left", "right")]
    truth = np.load(f"{data}/motorcycle_disp.npz")["arr_0"]
    for window in (9, 15, 21):
        ours, theirs = own(*pair, 80, window), opencv(*pair, 80, window)
        row(f"motorcycle, window {window}", ours[0], theirs[0], "ms")
        known, wrong = judged(ours[1], truth)
        their_known, their_wrong = judged(theirs[1], truth)
        row(f"known, {window}", 100 * known, 100 * their_known, "%")
        row(f"wrong of these, {window}", 100 * wrong, 100 * their_wrong, "%")
