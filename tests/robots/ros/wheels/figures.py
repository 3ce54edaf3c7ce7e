"""Prints the figures of docs/figures.md about ROS 2. usage: figures.py FROBC FOLDER

The peer is in rclpy, and its own times are part of the figures.
"""

import math
import os
import time

import nodes
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

ECHO = """import Robot

-- Turns faster the farther the robot is, so each command tells which odometry it is from.
main :: (HasOdometry i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR 0 ((place i).x * 0.001[rad/s/m])))
"""

COUNT = 2000


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, math.ceil(share * len(values)) - 1)]


def memory(process):
    """The proportional set size of a process, in MB."""
    with open(f"/proc/{process}/smaps_rollup", encoding="utf-8") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("Pss:")) / 1024


def main():
    nodes.write("echo.frob", ECHO)
    base = nodes.robot()
    base.silent = True
    arrived = {}
    base.command = lambda message: arrived.setdefault(
        round(message.angular.z / 0.001), time.monotonic()
    )
    numbers = []
    base.node.create_subscription(
        String,
        "/echo/instants",
        lambda message: numbers.append(int(message.data.split(" ", 1)[0])),
        QoSProfile(depth=10000, durability=DurabilityPolicy.TRANSIENT_LOCAL),
    )
    base.node.destroy_subscription(next(iter(base.node.subscriptions)))
    base.node.create_subscription(nodes.Twist, "cmd_vel", base.command, 10)
    run = nodes.Run(*["--rate", "1000", "--set", "fastest_turn=20"], program="echo.frob")
    base.until(lambda: base.publisher.get_subscription_count() > 0, "the node subscribes", 30)
    time.sleep(1)
    sent = {}
    for k in range(1, COUNT + 1):
        base.x = float(k)
        sent[k] = time.monotonic()
        base.publisher.publish(base.odometry())
        time.sleep(0.01)
    time.sleep(0.5)
    node = run.children()[1]
    size = memory(node)
    run.end()
    delays = [(arrived[k] - sent[k]) * 1000 for k in sent if k in arrived]
    print(
        f"odometry to command at 1000 Hz: median {percentile(delays, 0.5):.2f} ms,"
        f" p99 {percentile(delays, 0.99):.2f} ms, {COUNT - len(delays)} of {COUNT} unanswered"
    )
    lost = max(numbers) + 1 - len(set(numbers))
    print(f"instants on ~/instants: {len(set(numbers))}, lost {lost}")
    print(f"memory of the node's process: {size:.1f} MB; load {os.getloadavg()[0]:.1f}")
    while nodes.OPEN:
        nodes.OPEN.pop()()


main()
