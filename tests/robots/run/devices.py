"""Independent models of the lidar and of the inertial measurement unit of the simulator.

    devices.py lidar RUN SIZE    compares the scans of a recording with distances that this script
                                 computes; prints the largest difference, the standard deviation,
                                 and the fraction of directions without a distance
    devices.py imu RUN           compares the readings with the motion that the recording shows

The room is 6 m by 4 m with a pillar at (3, 2) of radius 0.3 m. The robot starts at (1, 1) with a
heading of 0, and its odometry has no errors. The walls are 0.1 m thick.
"""

import csv
import math
import re
import statistics
import sys

START = (1.0, 1.0)
LEFT, RIGHT, LOW, HIGH = 0.05, 5.95, 0.05, 3.95
RAYS = 360
SEAT = (0.1, -0.05)
FARTHEST = 4.0


def ray(x, y, angle):
    """The distance from a place to the walls or to the pillar."""
    u, v = math.cos(angle), math.sin(angle)
    found = []
    if abs(u) > 1e-12:
        found.append(((RIGHT if u > 0 else LEFT) - x) / u)
    if abs(v) > 1e-12:
        found.append(((HIGH if v > 0 else LOW) - y) / v)
    dx, dy = 3 - x, 2 - y
    along, across = dx * u + dy * v, dx * v - dy * u
    if along > 0 and abs(across) < 0.3:
        found.append(along - math.sqrt(0.09 - across**2))
    return min(found)


def expected(x, y, heading, size):
    """The smallest distance in each sector; FARTHEST if nothing is in range."""
    u, v = math.cos(heading), math.sin(heading)
    x, y = x + u * SEAT[0] - v * SEAT[1], y + v * SEAT[0] + u * SEAT[1]
    rays = [min(FARTHEST, ray(x, y, heading + math.radians(i))) for i in range(RAYS)]
    sectors = []
    for k in range(size):
        middle = 360 * k / size
        off = [abs((i - middle + 180) % 360 - 180) for i in range(RAYS)]
        # a ray between two sectors belongs to one of them: this script accepts both
        sure = [d for i, d in enumerate(rays) if off[i] < 180 / size - 1e-6]
        both = [d for i, d in enumerate(rays) if off[i] < 180 / size + 1e-6]
        sectors.append({min(sure), min(both)})
    return sectors


def scan_of(cell):
    text = re.search(r"ranges = \[(.*?)\]", cell).group(1)
    return [None if c == "Nothing" else float(c.split()[1]) for c in text.split(", ")]


def lidar(file, size):
    worst, errors, unknown, count, scans = 0.0, [], 0, 0, 0
    for row in csv.DictReader(open(file)):
        cell = row[f"in.console.lidar {size}"]
        if not cell:
            continue
        scans += 1
        # the pose of the instant is that of the scan, which was taken at the same time
        pose = (
            START[0] + float(row["in.odometry.position.x"]),
            START[1] + float(row["in.odometry.position.y"]),
            float(row["in.odometry.heading"]),
        )
        for seen, known in zip(scan_of(cell), expected(*pose, size)):
            count += 1
            if seen is None:
                unknown += 1
                continue
            error = min((seen - d for d in known), key=abs)
            worst = max(worst, abs(error))
            if max(known) < FARTHEST - 0.1:
                errors.append(error)
    print(
        f"{scans} scans, worst {worst:.3f}, deviation {statistics.pstdev(errors):.3f}, "
        f"unknown {unknown / count:.3f}"
    )


def wrapped(angle):
    return math.remainder(angle, 2 * math.pi)


def imu(file):
    turned, heading0, last, deflected = 0.0, 0.0, None, 0.0
    rate_errors, up, compass, speed = [], [], [], 0.0
    for row in csv.DictReader(open(file)):
        cell = row["in.console.imu"]
        heading = float(row["in.odometry.heading"])
        if cell:
            numbers = [float(n) for n in re.findall(r"[xyz] = ([^,}]*)", cell)]
            time = float(row["time"])
            step = time - (last or 0.0)
            last = time
            turned += numbers[2] * step
            speed += numbers[3] * step
            up.append(numbers[5])
            rate_errors.append(numbers[0])
            seen = re.search(r"heading = Just \(?([^,)]*)", cell)
            if seen:
                compass.append(wrapped(float(seen.group(1)) - heading))
    print(
        f"turned {turned:.3f}, odometry {wrapped(heading - turned) + turned:.3f}; "
        f"speed {speed:.2f}; up {statistics.mean(up):.3f}; "
        f"rates around x: mean {statistics.mean(rate_errors):.4f}, "
        f"deviation {statistics.pstdev(rate_errors):.4f}"
    )
    if compass:
        print(
            f"compass: mean error {statistics.mean(compass):.3f}, "
            f"deviation {statistics.pstdev(compass):.3f}"
        )
    else:
        print("no compass")


if sys.argv[1] == "lidar":
    lidar(sys.argv[2], int(sys.argv[3]))
else:
    imu(sys.argv[2])
