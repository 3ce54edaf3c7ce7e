"""Prints the figures of docs/figures.md about ROS 2. usage: figures.py FROBC FOLDER

The peer is in rclpy, and its own times are part of the figures. The environment variables SCANS,
INSTANTS and KILLS change how much is measured.
"""

import glob
import math
import os
import subprocess
import time

import nodes
from geometry_msgs.msg import Twist
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String

# Turns faster the farther the wall ahead is, so each command tells which scan it is from.
ECHO = """import Robot
import Lidar

main :: (HasLidar i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR 0 (ahead i * 1[rad/s/m])))

ahead :: HasLidar i => SF i Distance
ahead = proc i -> hold 0 (mapE front (lidar i))

front :: Scan 36 -> Distance
front scan = fromMaybe 0 (rangeAt 0 scan)
"""

SCANS = int(os.environ.get("SCANS", "2000"))
INSTANTS = int(os.environ.get("INSTANTS", "100000"))
KILLS = int(os.environ.get("KILLS", "100"))
STEP = 1 / 256  # m between the walls of scans; the conversion to floats is exact


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, math.ceil(share * len(values)) - 1)]


def memory(process):
    """The proportional set size of a process, and its resident set size, in MB."""
    with open(f"/proc/{process}/smaps_rollup", encoding="utf-8") as file:
        sizes = {line.split()[0]: int(line.split()[1]) / 1024 for line in list(file)[1:]}
    return sizes["Pss:"], sizes["Rss:"]


def build_empty_node():
    """Compiles empty_node.c, and returns the executable."""
    prefix = os.environ["AMENT_PREFIX_PATH"]
    here = os.path.dirname(os.path.abspath(__file__))
    executable = os.path.join(nodes.FOLDER, "empty_node")
    libraries = [f"-l{name}" for name in ["rcl", "rcutils", "rmw"]]
    includes = [f"-I{folder}" for folder in glob.glob(os.path.join(prefix, "include", "*"))]
    subprocess.run(
        ["gcc", "-O2", os.path.join(here, "empty_node.c"), "-o", executable, *includes]
        + [f"-L{prefix}/lib", "-Wl,--allow-shlib-undefined", *libraries],
        check=True,
    )
    return executable


def memories(process):
    """The memory of a process and of an empty node, at the same moment, so that both share the pages
    of libraries with the same processes."""
    with subprocess.Popen(
        [os.path.join(nodes.FOLDER, "with"), build_empty_node()],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
    ) as node:
        node.stdout.readline()
        time.sleep(1)
        sizes = memory(process), memory(node.pid)
        node.stdin.close()
    return sizes


def wall_at(distance):
    """A scan of a wall ahead."""
    scan = LaserScan()
    scan.angle_min, scan.angle_increment = -math.pi, math.pi / 180
    scan.angle_max = scan.angle_min + 359 * scan.angle_increment
    scan.range_min, scan.range_max = 0.001, 30.0
    scan.ranges = [distance] * 360
    return scan


def measure_scans(base):
    """Sends scans one after the other, and prints how long their commands take."""
    arrived = {}
    base.node.destroy_subscription(next(iter(base.node.subscriptions)))
    base.node.create_subscription(
        Twist,
        "cmd_vel",
        lambda message: arrived.setdefault(round(message.angular.z / STEP), time.monotonic()),
        10,
    )
    base.until(lambda: base.scans.get_subscription_count() > 0, "the node subscribes", 30)
    time.sleep(2)
    sent = {}
    for k in range(1, SCANS + 1):
        scan = wall_at(k * STEP)
        scan.header.stamp = base.now().to_msg()
        sent[k] = time.monotonic()
        base.scans.publish(scan)
        time.sleep(0.01)
    time.sleep(0.5)
    delays = [(arrived[k] - sent[k]) * 1000 for k in sent if k in arrived]
    print(
        f"scan to command at 1000 Hz, with the wait for the instant: median "
        f"{percentile(delays, 0.5):.2f} ms, p99 {percentile(delays, 0.99):.2f} ms, "
        f"{SCANS - len(delays)} of {SCANS} unanswered"
    )


def measure_node():
    """Prints the latency, the lost messages and the memory of a program's node."""
    nodes.write("echo.frob", ECHO)
    base = nodes.robot()
    numbers = []
    base.node.create_subscription(
        String,
        "/echo/instants",
        lambda message: numbers.append(int(message.data.split(" ", 1)[0])),
        QoSProfile(depth=10000, durability=DurabilityPolicy.TRANSIENT_LOCAL),
    )
    run = nodes.Run(
        *["--rate", "1000", "--set", "fastest_turn=20", "--set", "late=10"], program="echo.frob"
    )
    measure_scans(base)
    base.until(lambda: len(numbers) >= INSTANTS, "the instants arrive", 60 + INSTANTS / 300)
    own, empty = memories(run.children()[1])
    _, errors = run.end()
    last = max(numbers)
    first = min(numbers)
    print(
        f"instants on ~/instants (reliable): {len(set(numbers))}, "
        f"lost {last - first + 1 - len(set(numbers))}"
    )
    for k, kind in enumerate(["proportional", "resident"]):
        print(
            f"memory of the node's process ({kind}): {own[k]:.1f} MB; of an empty rcl node: "
            f"{empty[k]:.1f} MB; difference: {own[k] - empty[k]:.1f} MB"
        )
    print(errors, end="")
    while nodes.OPEN:
        nodes.OPEN.pop()()


def measure_kills():
    nodes.write("ahead.frob", nodes.PROGRAM)
    found = nodes.latencies(
        "the controller was killed", lambda run: os.kill(run.children()[0], 9), KILLS
    )
    print(f"zero after a kill: p99 {percentile(found, 0.99):.1f} ms of {KILLS}")
    while nodes.OPEN:
        nodes.OPEN.pop()()


def main():
    load = os.getloadavg()[0]
    measure_node()
    measure_kills()
    print(f"load: {load:.1f} at the start, {os.getloadavg()[0]:.1f} at the end")


main()
