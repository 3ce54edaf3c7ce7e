"""Tests details of programs as ROS 2 nodes against rclpy. usage: details.py FROBC FOLDER"""

import math
import time

import nodes
from cameras import RED, SENSOR_DATA, drives_at, picture
from frames import Broadcaster, says
from markers import DRAWS, Viewer
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import Image, Imu, LaserScan
from std_msgs.msg import String

SCANNED = """import Lidar
import Robot

main :: (HasLidar i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (hold 0 (mapE speed (lidar i))) 0)) where
    speed :: Scan 4 -> Velocity
    speed scan = case rangeAt 0 scan of
        Nothing -> 0.1[m/s]
        Just far -> if far < 1[m] then 0.2[m/s] else 0.3[m/s]
"""


def scan_of(count, ahead, increment=None):
    """A scan all around the robot, whose rays have the same range."""
    scan = LaserScan(angle_min=-math.pi, range_min=0.1, range_max=8.0)
    scan.angle_increment = 2 * math.pi / count if increment is None else increment
    scan.ranges = [ahead] * count
    return scan


def test_scans():
    """Scans of any size count, with NaN and infinity; the unusable ones are ignored and named."""
    nodes.write("scanned.frob", SCANNED)
    base = nodes.robot()
    run = nodes.Run(program="scanned.frob")

    def drives(make, speed):
        def holds():
            scan = make()
            scan.header.stamp = base.now().to_msg()
            base.scans.publish(scan)
            time.sleep(0.05)
            return base.v == speed

        base.until(holds, f"the robot drives at {speed} m/s", 30)

    drives(lambda: scan_of(360, 0.5), 0.2)
    drives(lambda: scan_of(8192, 4.0), 0.3)
    drives(lambda: scan_of(4, math.nan), 0.1)
    drives(lambda: scan_of(720, math.inf), 0.3)
    drives(lambda: scan_of(8, -math.inf), 0.2)
    for scan, message in [
        (scan_of(9000, 4.0), "it has more than 8192 ranges"),
        (scan_of(360, 4.0, 0.0), "its angles are not finite numbers, or angle_increment is 0"),
        (scan_of(360, 4.0, 0.1), "its rays cover more than a full turn"),
        (LaserScan(angle_increment=0.1, range_max=8.0), "it has no ranges"),
    ]:
        scan.header.stamp = base.now().to_msg()
        base.scans.publish(scan)
        base.until(lambda message=message: says(run, message), f"it reports: {message}")
    assert base.v == 0.2, "bad scans change nothing"
    run.end()
    base.close()


FELT = """import Imu
import Robot

main :: (HasImu i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (hold 0 (mapE speed (imu i))) 0)) where
    speed :: Imu -> Velocity
    speed reading
        | reading.acceleration.x > 0.9[m/s^2] && facing reading.heading = 0.2[m/s]
        | otherwise = 0.1[m/s]
    facing heading = case heading of
        Just angle -> abs angle < 0.1
        Nothing -> False
"""


def test_imu_frame():
    """The measurements of a unit that looks to the right are turned to the robot's directions."""
    nodes.write("felt.frob", FELT)
    base = nodes.robot()
    base.imus = base.node.create_publisher(Imu, "elsewhere", 1)
    units = base.node.create_publisher(Imu, "imu", SENSOR_DATA)

    def measure():
        # The unit accelerates to its left, which is ahead.
        imu = Imu()
        imu.header.stamp = base.now().to_msg()
        imu.header.frame_id = "imu_link"
        imu.linear_acceleration.y = 1.0
        imu.orientation.z, imu.orientation.w = math.sin(-math.pi / 4), math.cos(-math.pi / 4)
        units.publish(imu)

    timer = base.node.create_timer(0.05, measure)
    run = nodes.Run(program="felt.frob")
    unknown = "no transform between its frame `imu_link` and `base_link` is known"
    base.until(lambda: says(run, unknown), "the message appears", 60)
    assert base.v == 0, "its messages are ignored"
    Broadcaster(base).publish("base_link", "imu_link", turned=-math.pi / 2)
    base.until(lambda: base.v == 0.2, "the measurements are turned", 30)
    run.end()
    run = nodes.Run("--set", "imu_aligned=1", program="felt.frob")
    base.until(lambda: base.v == 0.1, "a setting overrides the transform", 60)
    timer.cancel()
    run.end()
    base.close()


def test_late_recorder():
    """A subscriber that starts later receives the columns, and the instants from the first one."""
    base = nodes.robot()
    run = nodes.Run()
    base.until(lambda: base.x > 0.3, "it has driven 0.3 m", 30)
    kept = QoSProfile(depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    columns, instants = [], []
    base.node.create_subscription(String, "/ahead/columns", columns.append, kept)
    base.node.create_subscription(String, "/ahead/instants", instants.append, kept)
    base.until(lambda: columns and len(instants) > 50, "they arrive")
    numbers = [int(message.data.split(" ", 1)[0]) for message in instants]
    assert numbers == list(range(len(numbers))), numbers[:5]
    run.end()
    base.close()


def test_two_cameras():
    """Each camera has a topic of its own, by its label, or as an option says."""
    eyes = RED.replace("(HasCamera i", "(HasConsole i").replace(
        "(camera i)", '(consoleCamera "left" (console i))'
    )
    nodes.write("eyes.frob", eyes)
    base = nodes.robot()
    default = base.node.create_publisher(Image, "left/image_raw", SENSOR_DATA)
    run = nodes.Run(program="eyes.frob")
    drives_at(base, default, lambda: picture("rgb8", [250, 0, 0]), 0.2)
    run.end()
    other = base.node.create_publisher(Image, "other/image", SENSOR_DATA)
    run = nodes.Run("--camera", "left=ros:other/image", program="eyes.frob")
    drives_at(base, other, lambda: picture("rgb8", [250, 0, 0]), 0.2)
    run.end()
    base.close()


def test_marker_rate():
    """A drawing is published at most twenty times a second."""
    nodes.write("draws.frob", DRAWS)
    base = nodes.robot()
    viewer = Viewer(base)
    run = nodes.Run(program="draws.frob")
    base.until(lambda: viewer.received > 0, "markers arrive", 60)
    start, before = time.monotonic(), viewer.received
    base.until(lambda: time.monotonic() > start + 3, "three seconds pass")
    passed = time.monotonic() - start
    run.end()
    # Messages may have waited before they were counted.
    assert 0 < viewer.received - before <= 20 * passed + 10, (viewer.received - before, passed)
    base.close()


WIDE = """import Ros

data In = In { scan :: Event (LaserScan 8000) }
data Out = Out { heard :: Event () }

main :: Program In Out
main = node 50[Hz] (proc i -> Out { heard = mapE (\\_ -> ()) i.scan })
"""


def test_large_record():
    """A node with a record that is too large does not start, and names its field."""
    nodes.write("wide.frob", WIDE)
    run = nodes.Run("--for", "1s", program="wide.frob")
    run.process.wait(timeout=60)
    _, errors = run.end()
    assert run.process.returncode != 0 and "a value of `scan` has" in errors, errors
    assert "more than the maximum of 60000" in errors, errors


if __name__ == "__main__":
    nodes.write("ahead.frob", nodes.PROGRAM)
    nodes.run_tests(globals())
