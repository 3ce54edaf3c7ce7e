"""A plain rclpy node without any of Frob's code: it drives a robot ahead until an object is near,
turns to the left until the way is clear, and finally prints what it has seen.

usage: teleop.py SECONDS [stamped]
"""

import math
import sys

import rclpy
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Imu, LaserScan


class Teleop(Node):
    """Counts messages, and drives."""

    def __init__(self, stamped):
        super().__init__("teleop")
        self.stamped = stamped
        self.counts = {"odom": 0, "scan": 0, "imu": 0, "clock": 0}
        self.first = self.last = None  # positions
        self.ahead = math.inf
        self.nearest = math.inf
        self.backwards = 0  # times of /clock that went back
        self.time = 0.0
        kind = TwistStamped if stamped else Twist
        self.commands = self.create_publisher(kind, "cmd_vel", 10)
        self.create_subscription(Odometry, "odom", self.on_odometry, 10)
        self.create_subscription(LaserScan, "scan", self.on_scan, qos_profile_sensor_data)
        self.create_subscription(Imu, "imu", self.on_imu, 10)
        self.create_subscription(Clock, "/clock", self.on_clock, qos_profile_sensor_data)
        self.create_timer(0.1, self.drive)

    def on_odometry(self, message):
        self.counts["odom"] += 1
        position = message.pose.pose.position
        self.last = (position.x, position.y)
        self.first = self.first or self.last

    def on_scan(self, message):
        self.counts["scan"] += 1
        bearings = [
            math.remainder(message.angle_min + k * message.angle_increment, 2 * math.pi)
            for k in range(len(message.ranges))
        ]
        self.ahead = min(r for r, b in zip(message.ranges, bearings) if abs(b) < 0.5)
        self.nearest = min(self.nearest, *message.ranges)

    def on_imu(self, message):
        self.counts["imu"] += 1
        assert abs(message.linear_acceleration.z - 9.81) < 0.5, message

    def on_clock(self, message):
        self.counts["clock"] += 1
        time = message.clock.sec + message.clock.nanosec * 1e-9
        self.backwards += time < self.time
        self.time = time

    def drive(self):
        twist = Twist()
        if self.ahead > 0.6:
            twist.linear.x = 0.3
        else:
            twist.angular.z = 1.0
        if self.stamped:
            self.commands.publish(TwistStamped(twist=twist))
        else:
            self.commands.publish(twist)


def main():
    rclpy.init()
    node = Teleop("stamped" in sys.argv)
    end = node.get_clock().now().nanoseconds + float(sys.argv[1]) * 1e9
    while node.get_clock().now().nanoseconds < end:
        rclpy.spin_once(node, timeout_sec=0.1)
    far = math.dist(node.first, node.last) if node.first else 0
    print(node.counts, f"far {far:.2f}", f"nearest {node.nearest:.2f}", f"back {node.backwards}")


main()
