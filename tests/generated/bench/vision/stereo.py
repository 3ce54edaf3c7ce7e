"""Compares stereo with OpenCV's StereoBM: one core each, the least time of 15, with the same
window, disparities, left-right check and uniqueness, on a random pair. Prints a JSON object.
tests/generated/photographs measures the quality of disparities on photographs.

    stereo.py KERNELS FOLDER

KERNELS is the program kernels.c, FOLDER the working folder.
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
        matcher.compute(left, right)
        times.append((time.perf_counter() - start) * 1e3)
    return min(times)


def own(left, right, disparities, window):
    height, width = left.shape
    files = [f"{folder}/{name}" for name in ("left", "right", "found")]
    left.tofile(files[0])
    right.tofile(files[1])
    numbers = [str(n) for n in (width, height, disparities, window)]
    done = subprocess.run([kernels, *numbers, *files], check=True, capture_output=True, text=True)
    return float(done.stdout)


def row(measure, value, reference, unit):
    print(
        json.dumps(
            {
                "program": "vision",
                "measure": measure,
                "compiler": "opencv",
                "value": round(value, 4),
                "reference": round(reference, 4),
                "ratio": round(value / reference, 2),
                "unit": unit,
            }
        )
    )


kernels, folder = sys.argv[1:]
cv2.setNumThreads(1)
texture = np.random.default_rng(1).integers(0, 256, (240, 400), dtype=np.uint8)
texture = cv2.GaussianBlur(texture, (0, 0), 1.2)
pair = np.ascontiguousarray(texture[:, :320]), np.ascontiguousarray(texture[:, 9:329])
row("stereo 320x240x32", own(*pair, 32, 9), opencv(*pair, 32, 9), "ms")
