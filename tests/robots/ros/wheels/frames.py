"""Tests programs that read the transforms of frames. usage: frames.py FROBC FOLDER"""

import math
import os
import shutil
import time

import nodes
from geometry_msgs.msg import PointStamped
from rclpy.qos import DurabilityPolicy, QoSProfile
from transforms import STORE, TFMessage

CLICKED = """import Geometry
import Robot

main :: (HasConsole i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (speed (hold origin (mapClicked i))) 0)) where
    origin = Vec2 { x = 0, y = 0 }
    speed p = if abs (p.x - 2[m]) < 1[cm] && abs (p.y - 1[m]) < 1[cm] then 0.2[m/s] else 0
"""

SEATED = """[start]
x = 1
y = 1
[[wall]]
points = [[2.5, 0], [2.5, 2]]
[[lidar]]
ahead = 0.2
"""


def says(run, text):
    """Whether the program has written this message."""
    with open(run.errors.name, encoding="utf-8") as file:
        return text in file.read()


class Broadcaster:
    """Publishes transforms: on /tf_static, also for nodes that start later, or on /tf."""

    def __init__(self, base, topic="/tf_static"):
        fixed = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        qos = fixed if topic == "/tf_static" else 100
        self.publisher = base.node.create_publisher(TFMessage, topic, qos)

    def publish(self, parent, child, x=0.0, turned=0.0, tilted=0.0):
        types = STORE.types
        header = types["std_msgs/msg/Header"](
            stamp=types["builtin_interfaces/msg/Time"](sec=0, nanosec=0), frame_id=parent
        )
        rotation = (
            0.0,
            math.sin(tilted / 2),
            math.sin(turned / 2),
            math.cos((turned + tilted) / 2),
        )
        transform = types["geometry_msgs/msg/Transform"](
            translation=types["geometry_msgs/msg/Vector3"](x=x, y=0.0, z=0.0),
            rotation=types["geometry_msgs/msg/Quaternion"](*rotation),
        )
        stamped = types["geometry_msgs/msg/TransformStamped"](
            header=header, child_frame_id=child, transform=transform
        )
        message = types["tf2_msgs/msg/TFMessage"](transforms=[stamped])
        self.publisher.publish(bytes(STORE.serialize_cdr(message, "tf2_msgs/msg/TFMessage")))


def test_lidar():
    """A lidar's place on the robot is that of its frame, whose transforms have two parts."""
    base = nodes.robot()
    base.wall, base.frame = 1.5, "laser"
    Broadcaster(base).publish("base_link", "mast", x=0.5)
    moving = Broadcaster(base, "/tf")
    base.node.create_timer(0.1, lambda: moving.publish("mast", "laser", x=-0.3))
    run = nodes.Run(program="approach.frob")
    base.until_driving()
    # The scans of this robot are those of a lidar at the centre, but it is 0.2 m ahead. So the
    # program sees the wall 0.2 m farther away, and comes closer than in the test of nodes.py.
    base.until(lambda: base.wall - base.x < 0.55 and base.v < 0.02, "it stands at the wall")
    assert base.wall - base.x > 0.4, base.x
    _, errors = run.end()
    assert "ignored" not in errors, errors
    base.close()


def test_moving_frame():
    """The robot stops when the transform of the lidar's frame is no longer published."""
    base = nodes.robot()
    base.wall, base.frame = 100.0, "laser"
    moving = Broadcaster(base, "/tf")
    timer = base.node.create_timer(0.1, lambda: moving.publish("base_link", "laser"))
    run = nodes.Run(program="approach.frob")
    base.until_driving()
    time.sleep(1)
    timer.cancel()
    base.until_stopped()
    timer.reset()
    base.until_driving()
    run.end()
    base.close()


def test_unknown_frame():
    """The robot stands while the place of the lidar is not known; the message names the frame."""
    base = nodes.robot()
    base.wall, base.frame = 100.0, "laser"
    run = nodes.Run(program="approach.frob")
    unknown = "no transform between its frame `laser` and `base_link`"
    base.until(lambda: says(run, unknown), "the message appears", 60)
    base.until_stopped()
    time.sleep(0.5)
    base.until_stopped()
    Broadcaster(base).publish("base_link", "laser")
    base.until_driving()
    _, errors = run.end()
    assert errors.count(unknown) == 1, errors
    base.close()


def test_tilted_lidar():
    """A tilted lidar is reported, unless a setting says where it is."""
    base = nodes.robot()
    base.wall, base.frame = 100.0, "laser"
    Broadcaster(base).publish("base_link", "laser", tilted=0.5)
    run = nodes.Run(program="approach.frob")
    base.until(lambda: says(run, "its frame `laser` is tilted"), "the message appears", 60)
    base.until_stopped()
    run.end()
    run = nodes.Run("--set", "lidar_x=0", program="approach.frob")
    base.until_driving()
    _, errors = run.end()
    assert "ignored" not in errors, errors
    base.close()


def test_simulated_lidar():
    """A program reads where the lidar of the simulated robot is."""
    nodes.write("seated.toml", SEATED)
    served = nodes.Served("--world", os.path.join(nodes.FOLDER, "seated.toml"))
    record = os.path.join(nodes.FOLDER, "log.csv")
    run = nodes.Run("--for", "8s", "--record", record, program="approach.frob")
    run.process.wait(timeout=60)
    _, errors = run.end()
    assert run.process.returncode == 0 and "ignored" not in errors, errors
    with open(record, encoding="utf-8") as file:
        column = file.readline().strip().split(",").index("in.odometry.position.x")
        place = [float(line.split(",")[column]) for line in file][-1]
    # It stops with its front, 0.2 m ahead of its centre, 0.5 m before the wall.
    assert abs(1 + place - 1.8) < 0.05, place
    served.end()


def click(base, run, frame, x, expected):
    """Clicks on the map until the robot drives, or for some time."""
    publisher = base.node.create_publisher(PointStamped, "clicked_point", 10)
    base.until(lambda: publisher.get_subscription_count() > 0, "the node subscribes", 30)
    message = PointStamped()
    message.header.frame_id = frame
    message.point.x, message.point.y = x, 1.0
    end = time.monotonic() + (30 if expected else 4)
    while time.monotonic() < end and base.v == 0:
        publisher.publish(message)
        time.sleep(0.1)
    assert (base.v > 0) == expected, base.v
    return run.end()[1]


def test_click():
    """A point that is clicked in rviz is a click on the map of the program's console."""
    nodes.write("clicked.frob", CLICKED)
    base = nodes.robot()
    errors = click(base, nodes.Run(program="clicked.frob"), "odom", 2.0, True)
    assert "ignored" not in errors, errors
    base.close()


def test_click_on_map():
    """It may be in another frame, whose transform is known."""
    base = nodes.robot()
    errors = click(base, nodes.Run(program="clicked.frob"), "map", 12.0, False)
    assert "no transform between its frame `map` and `odom` is known" in errors, errors
    base.close()
    base = nodes.robot()
    Broadcaster(base).publish("map", "odom", x=10.0)
    click(base, nodes.Run(program="clicked.frob"), "map", 12.0, True)
    base.close()


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    shutil.copy(os.path.join(here, "..", "approach.frob"), nodes.FOLDER)
    nodes.run_tests(globals())
