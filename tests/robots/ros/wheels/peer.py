"""A robot's base in rclpy, for tests of programs that run as ROS 2 nodes.

It follows the commands on cmd_vel and publishes odom. It runs in a separate thread, so a test can
change its behaviour at any time.
"""

import math
import threading
import time

import rclpy
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from rclpy.time import Time
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Imu, LaserScan


class Base:
    """The robot: attributes that tests change are listed first."""

    def __init__(self, name="base", odom="odom", cmd_vel="cmd_vel", stamped=False, reliable=True):
        self.silent = False  # publishes nothing
        self.nan = False  # publishes a position that is not a number
        self.shift = 0.0  # seconds, added to timestamps
        self.frame = "base_link"  # of the lidar
        self.wall = None  # m, the place of a wall ahead, which the lidar sees
        self.simulated = None  # speed of the simulator's clock, relative to ours
        self.restarted = 0.0  # seconds by which the simulator's clock was set back

        self.stamped = stamped
        self.closing = False
        self.context = rclpy.Context()
        rclpy.init(context=self.context)
        self.node = rclpy.create_node(name, context=self.context)
        self.x = self.y = self.heading = self.v = self.turn = 0.0
        self.commands = []  # (time of arrival, speed, turn rate), only changes
        self.received = 0
        reliability = ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT
        self.publisher = self.node.create_publisher(
            Odometry, odom, QoSProfile(depth=5, reliability=reliability)
        )
        kind = TwistStamped if stamped else Twist
        self.node.create_subscription(kind, cmd_vel, self.command, 10)
        self.scans = self.node.create_publisher(LaserScan, "scan", qos_profile_sensor_data)
        self.imus = self.node.create_publisher(Imu, "imu", qos_profile_sensor_data)
        self.clocks = self.node.create_publisher(Clock, "/clock", qos_profile_sensor_data)
        self.started = time.monotonic()
        self.node.create_timer(0.01, self.tick)
        self.node.create_timer(0.02, self.step)
        self.node.create_timer(0.1, self.scan)
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self.thread = threading.Thread(target=self.spin, daemon=True)
        self.thread.start()

    def spin(self):
        try:
            self.executor.spin()
        except Exception:
            if self.context.ok() and not self.closing:
                raise

    def close(self):
        if not self.context.ok():
            return
        self.closing = True
        self.executor.shutdown()
        self.thread.join()
        self.node.destroy_node()
        rclpy.shutdown(context=self.context)

    def command(self, message):
        twist = message.twist if self.stamped else message
        self.received += 1
        velocity = (twist.linear.x, twist.angular.z)
        if not self.commands or self.commands[-1][1:] != velocity:
            self.commands.append((time.monotonic(), *velocity))
        self.v, self.turn = velocity

    def now(self):
        """The time for stamps."""
        if self.simulated is None:
            return self.node.get_clock().now()
        passed = (time.monotonic() - self.started) * self.simulated
        return Time(seconds=1000 + passed - self.restarted)

    def tick(self):
        if self.simulated is not None:
            self.clocks.publish(Clock(clock=self.now().to_msg()))

    def step(self):
        dt = 0.02
        self.heading += self.turn * dt
        self.x += self.v * math.cos(self.heading) * dt
        self.y += self.v * math.sin(self.heading) * dt
        if not self.silent:
            self.publisher.publish(self.odometry())

    def odometry(self):
        message = Odometry()
        stamp = self.now() + Duration(seconds=self.shift)
        message.header.stamp = stamp.to_msg()
        message.header.frame_id = "odom"
        message.child_frame_id = "base_link"
        message.pose.pose.position.x = math.nan if self.nan else self.x
        message.pose.pose.position.y = self.y
        message.pose.pose.orientation.z = math.sin(self.heading / 2)
        message.pose.pose.orientation.w = math.cos(self.heading / 2)
        message.twist.twist.linear.x = self.v
        message.twist.twist.angular.z = self.turn
        return message

    def call(self, request, seconds=10.0):
        """Calls a service and returns its answer."""
        future = request()
        self.until(future.done, "the service answers", seconds)
        return future.result()

    def until(self, holds, what, seconds=15.0):
        """Waits until a condition holds."""
        end = time.monotonic() + seconds
        while not holds():
            if time.monotonic() > end:
                raise AssertionError(f"never: {what}; commands {self.commands[-3:]}")
            time.sleep(0.005)

    def until_driving(self):
        self.until(lambda: self.v > 0, "the robot drives")

    def until_stopped(self):
        """Waits until the robot was stopped, and returns the time of that command."""
        self.until(lambda: self.v == 0 and self.turn == 0, "the robot is stopped")
        return self.commands[-1][0]

    def scan(self):
        """Publishes what a lidar with 360 rays sees, and what a gyroscope measures."""
        stamp = self.now().to_msg()
        imu = Imu()
        imu.header.stamp = stamp
        imu.angular_velocity.z = self.turn + 0.25
        imu.linear_acceleration.z = 9.81
        imu.orientation_covariance[0] = -1.0
        self.imus.publish(imu)
        if self.wall is None:
            return
        message = LaserScan()
        message.header.stamp = stamp
        message.header.frame_id = self.frame
        message.angle_min = -math.pi
        message.angle_increment = math.pi / 180
        message.angle_max = message.angle_min + 359 * message.angle_increment
        message.range_min, message.range_max = 0.1, 8.0
        ahead = self.wall - self.x
        cosines = [math.cos(message.angle_min + k * message.angle_increment) for k in range(360)]
        message.ranges = [ahead / c if c > 0.1 else math.inf for c in cosines]
        self.scans.publish(message)
