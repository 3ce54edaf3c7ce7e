"""Compares the path of a robot, as the viewer sends it, with the robot's positions."""

import bisect
import math


def apart(a, b, place):
    """The distance of a place from the line between two points."""
    (ax, ay), (bx, by), (x, y) = a, b, place
    length = math.hypot(bx - ax, by - ay)
    along = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length**2 if length > 0 else 0
    share = min(1, max(0, along))
    return math.hypot(ax + share * (bx - ax) - x, ay + share * (by - ay) - y)


def is_followed(points, places, close=0.015, long=1.0):
    """Whether the lines between `points` pass within `close` metres of all `places`, and each
    of them takes at most `long` seconds and an instant. Points and places have time, x and y."""
    times = [time for time, _, _ in points]
    if any(b - a > long + 0.021 for a, b in zip(times, times[1:])):
        return False
    for time, *place in places:
        after = max(1, min(bisect.bisect_left(times, time), len(points) - 1))
        if apart(points[after - 1][1:], points[after][1:], place) > close + 1e-9:
            return False
    return True
