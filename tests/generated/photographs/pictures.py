"""Compares the vision kernels on photographs with OpenCV and with ground truth.

    pictures.py LIBRARY SKIMAGE OPENCV VISP

LIBRARY is the library of the kernels (kernels.py); the others are folders of pictures:
`skimage/data` of the package scikit-image, `examples/data` of opencv-doc, `ViSP-images` of
visp-images-data. Prints JSON, one object a line. The exit status is 1 if a figure exceeds its
limit."""

import sys
import time

import cv2
import numpy as np

from kernels import Kernels, end, row

library, skimage, opencv, visp = sys.argv[1:]
kernels = Kernels(library)
cv2.setNumThreads(1)


def grey(name):
    image = cv2.imread(name, cv2.IMREAD_GRAYSCALE)
    assert image is not None, name
    return image


# Pairs with known disparities: scikit-image's motorcycle (Scharstein et al., 2014), and
# opencv-doc's aloe (Hirschmüller and Scharstein, 2007)


def least_time(call):
    times = []
    for _ in range(9):
        start = time.perf_counter()
        found = call()
        times.append((time.perf_counter() - start) * 1e3)
    return min(times), found


def opencv_disparities(left, right, most, window):
    matcher = cv2.StereoBM_create(most, window)
    matcher.setDisp12MaxDiff(1)
    matcher.setUniquenessRatio(10)
    return matcher.compute(left, right)


def judged(found, truth):
    """Returns the percentage of pixels with a result, and the percentage of these that are more
    than 2 pixels off.
    """
    sure = np.isfinite(truth)
    known = sure & (found >= 0)
    wrong = known & (np.abs(found / 16 - truth) > 2)
    return 100 * known.sum() / sure.sum(), 100 * wrong.sum() / known.sum()


def stereo(name, left, right, truth, most):
    for window in (9, 15, 21):
        ours = least_time(lambda: kernels.disparities(left, right, most, window))
        theirs = least_time(lambda: opencv_disparities(left, right, most, window))
        (known, wrong), (their_known, their_wrong) = (judged(f[1], truth) for f in (ours, theirs))
        row(f"{name}, window {window}: time", ours[0], theirs[0], "ms")
        row(f"{name}, {window}: not known", 100 - known, 100 - their_known, "%", most=1)
        row(f"{name}, {window}: wrong", wrong, their_wrong, "%", most=1.05)


def motorcycle():
    pair = [grey(f"{skimage}/motorcycle_{side}.png") for side in ("left", "right")]
    stereo("motorcycle", *pair, np.load(f"{skimage}/motorcycle_disp.npz")["arr_0"], 80)


def aloe():
    pair = [grey(f"{opencv}/aloe{side}.jpg") for side in "LR"]
    truth = grey(f"{opencv}/aloeGT.png").astype(float)
    truth[truth == 0] = np.nan
    stereo("aloe", *pair, truth, 224)


# Photographs of a chessboard with two cameras, from opencv-doc


COLUMNS, ROWS = 9, 6
board = np.array([(x, y, 0) for y in range(ROWS) for x in range(COLUMNS)], np.float32)


def corners_of(name):
    """Returns the board's inner corners, as OpenCV refines them and as our kernel finds them,
    starting from OpenCV's corners rounded to whole pixels."""
    image = grey(name)
    found, corners = cv2.findChessboardCorners(image, (COLUMNS, ROWS))
    assert found, name
    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 100, 1e-4)
    theirs = cv2.cornerSubPix(image, corners.copy(), (5, 5), (-1, -1), stop)[:, 0]
    ours = [kernels.corner(image, round(float(x)), round(float(y)), 4) for x, y in theirs]
    return image.shape[::-1], theirs.astype(float), np.array(ours)


def rms(vectors):
    return np.sqrt((vectors**2).sum(axis=1).mean())


def calibrated(size, views):
    return cv2.calibrateCamera(
        [board] * len(views), [v.astype(np.float32) for v in views], size, None, None
    )


def chessboard(side):
    seen = [corners_of(f"{opencv}/{side}{k:02}.jpg") for k in (*range(1, 10), *range(11, 15))]
    size = seen[0][0]
    theirs, ours = ([s[k] for s in seen] for k in (1, 2))
    row(
        f"chessboard, {side}: corners beside OpenCV's, RMS",
        rms(np.vstack(ours) - np.vstack(theirs)),
        0.3,
        "px",
        most=1,
    )
    by_theirs, by_ours = calibrated(size, theirs), calibrated(size, ours)
    row(
        f"chessboard, {side}: corners off the calibrated board, RMS",
        by_ours[0],
        by_theirs[0],
        "px",
        most=1.5,
    )
    row(
        f"chessboard, {side}: focal length, difference in %",
        100 * abs(by_ours[1][0, 0] / by_theirs[1][0, 0] - 1),
        1,
        "%",
        most=1,
    )
    matrix, distortion = by_theirs[1], by_theirs[2][0]
    points = np.vstack(theirs)
    straight = cv2.undistortPointsIter(
        points[:, None], matrix, distortion, None, matrix, (cv2.TERM_CRITERIA_COUNT, 100, 0)
    )[:, 0]
    found = kernels.bent(True, points, matrix, distortion, size)
    row(
        f"chessboard, {side}: undistort beside OpenCV, at most",
        np.abs(found - straight).max(),
        0.01,
        "px",
        most=1,
    )
    row(
        f"chessboard, {side}: distorted again, off at most",
        np.abs(kernels.bent(False, found, matrix, distortion, size) - points).max(),
        0.01,
        "px",
        most=1,
    )


# Tags with known corners and poses, from visp-images-data


def turned(found, axis):
    """The angle in degrees between the found direction of a tag and the true one."""
    facing = np.array((found.facing.x, found.facing.y, found.facing.z))
    return np.degrees(np.arccos(np.clip(facing @ axis, -1, 1)))


def off_corners(tag, corners):
    """The largest distance between corresponding corners. The true corners may start at another
    corner and run in the other direction.
    """
    found = np.array([(p.x, p.y) for p in tag.corners])
    return min(
        np.linalg.norm(np.roll(corners[::way], k, 0) - found, axis=1).max()
        for way in (1, -1)
        for k in range(4)
    )


def blocks(name, length):
    """Reads a file of repeated blocks, each with a name and `length` lines of numbers. Maps the
    number in each name to its block."""
    lines = [line.split() for line in open(name) if line.strip()]
    return {
        int(lines[k][-1].rsplit("_", 1)[-1]): np.array(lines[k + 1 : k + 1 + length], float)
        for k in range(0, len(lines), length + 1)
    }


def tags_of(what, image, truth, poses, sizes, matrix, limits):
    """Checks the tags in an image. `poses` maps each number to the position of the tag's centre and
    the direction it faces.
    """
    found = kernels.tags(image)
    size = image.shape[::-1]
    assert len(found) == min(8, len(truth)) and set(found) <= set(truth), sorted(found)
    places = {k: kernels.tag_place(tag, sizes[k], matrix, size) for k, tag in found.items()}
    middles = {k: np.array((p.middle.x, p.middle.y, p.middle.z)) for k, p in places.items()}
    corner, place, turn = limits
    row(
        f"{what}: corners off, at most",
        max(off_corners(t, truth[k]) for k, t in found.items()),
        corner,
        "px",
        most=1,
    )
    row(
        f"{what}: place off, at most",
        max(
            100 * np.linalg.norm(m - poses[k][0]) / np.linalg.norm(poses[k][0])
            for k, m in middles.items()
        ),
        place,
        "%",
        most=1,
    )
    row(
        f"{what}: turn off, at most",
        max(turned(p, poses[k][1]) for k, p in places.items()),
        turn,
        "deg",
        most=1,
    )


def tags():
    folder = f"{visp}/AprilTag/benchmark/640x480"
    truth = blocks(f"{folder}/corners_tag36_11.txt", 4)
    poses = {k: np.loadtxt(f"{folder}/cMo_{k}.txt") for k in truth}
    tags_of(
        "tags, rendered",
        grey(f"{folder}/tag36_11_640x480.png"),
        truth,
        {k: (p[:3, 3], p[:3, 2]) for k, p in poses.items()},
        {k: 0.2 if k < 3 else 0.1 for k in truth},
        np.array([[700, 0, 320], [0, 700, 240], [0, 0, 1]]),
        (1, 1, 2),
    )
    folder = f"{visp}/AprilTag"
    # these corners are given as (row, column)
    truth = {k: c[:, ::-1] for k, c in blocks(f"{folder}/ground_truth_detection.txt", 4).items()}
    poses = blocks(f"{folder}/ground_truth_pose.txt", 1)
    tags_of(
        "tags, photographed",
        grey(f"{folder}/AprilTag.pgm"),
        truth,
        {k: (p[0, :3], cv2.Rodrigues(p[0, 3:])[0][:, 2]) for k, p in poses.items()},
        dict.fromkeys(truth, 0.053),
        np.array([[615.17, 0, 312.19], [0, 615.17, 243.44], [0, 0, 1]]),
        (1, 1, 2),
    )


motorcycle()
aloe()
chessboard("left")
chessboard("right")
tags()
end()
