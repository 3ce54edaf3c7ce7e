"""Tests the transforms of the simulated robot. usage: transforms.py FROBC FOLDER

The package tf2_msgs in these tests has no Python module. So the peer subscribes to raw messages, and
the package rosbags, which has its own definition of tf2_msgs/msg/TFMessage, reads them.
"""

import ctypes
import os
import time

import nodes
from nav_msgs.msg import Odometry
from peer import Base
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.qos import qos_profile_sensor_data as SENSOR_DATA
from rosbags.typesys import Stores, get_typestore
from sensor_msgs.msg import Imu, LaserScan

LIBRARIES = os.path.join(os.environ["AMENT_PREFIX_PATH"], "tf2", "lib")
STORE = get_typestore(Stores.ROS2_JAZZY)

WORLD = """[start]
x = 1
y = 1
[[lidar]]
ahead = 0.15
left = -0.05
[[lidar]]
name = "rear"
ahead = -0.2
"""


def type_support():
    """The type support of TFMessage, as rclpy expects it."""
    # rclpy finds the others by name, because this process has opened them. Jazzy has one more.
    for kind in [
        "generator_c",
        "typesupport_introspection_c",
        "typesupport_fastrtps_cpp",
        "typesupport_fastrtps_c",
    ]:
        path = f"{LIBRARIES}/libtf2_msgs__rosidl_{kind}.so"
        if os.path.exists(path):
            ctypes.CDLL(path, ctypes.RTLD_GLOBAL)
    library = ctypes.CDLL(f"{LIBRARIES}/libtf2_msgs__rosidl_typesupport_c.so", ctypes.RTLD_GLOBAL)
    get = library.rosidl_typesupport_c__get_message_type_support_handle__tf2_msgs__msg__TFMessage
    get.restype = ctypes.c_void_p
    new = ctypes.pythonapi.PyCapsule_New
    new.restype = ctypes.py_object
    new.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
    return new(get(), None, None)


class MessageType(type):
    """The class of the message's class, in which rclpy looks for the type support."""

    _TYPE_SUPPORT = type_support()
    _CREATE_ROS_MESSAGE = _CONVERT_FROM_PY = _CONVERT_TO_PY = _DESTROY_ROS_MESSAGE = object()


class TFMessage(metaclass=MessageType):
    """tf2_msgs/msg/TFMessage, for raw subscriptions."""


class Listener:
    """Collects transforms."""

    def __init__(self, base):
        self.moving = []
        self.fixed = []
        fixed = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        for topic, qos, found in [("/tf", 100, self.moving), ("/tf_static", fixed, self.fixed)]:
            base.node.create_subscription(
                TFMessage,
                topic,
                lambda data, found=found: found.extend(
                    STORE.deserialize_cdr(bytes(data), "tf2_msgs/msg/TFMessage").transforms
                ),
                qos,
                raw=True,
            )


def stamp(header):
    return (header.stamp.sec, header.stamp.nanosec)


def observer():
    """A node that neither publishes what a robot publishes nor drives."""
    base = Base(name="observer", odom="unused_odom", cmd_vel="unused_cmd_vel")
    base.imus = base.node.create_publisher(Imu, "unused_imu", 1)
    nodes.OPEN.append(base.close)
    return base


def test_transforms():
    """The simulated robot publishes its place on /tf, and the frames of its sensors on /tf_static."""
    nodes.write("seats.toml", WORLD)
    served = nodes.Served("--world", os.path.join(nodes.FOLDER, "seats.toml"))
    time.sleep(1)
    base = observer()
    odometry, frames = {}, {}
    base.node.create_subscription(
        Odometry, "odom", lambda m: odometry.setdefault(stamp(m.header), m), 100
    )
    for kind, topic in [(LaserScan, "scan"), (LaserScan, "rear"), (Imu, "imu")]:
        base.node.create_subscription(
            kind, topic, lambda m, t=topic: frames.setdefault(t, m.header.frame_id), SENSOR_DATA
        )
    listener = Listener(base)
    base.until(lambda: len(frames) == 3 and listener.fixed, "sensors and frames arrive")
    nodes.teleop("3")
    base.until(lambda: len(listener.moving) > 50, "transforms arrive")
    _, errors = served.end()
    assert errors == "", errors
    assert frames == {"scan": "lidar_link", "rear": "rear_link", "imu": "imu_link"}, frames
    seats = {
        t.child_frame_id: (t.transform.translation.x, t.transform.translation.y)
        for t in listener.fixed
        if t.header.frame_id == "base_link" and t.transform.rotation.w == 1.0
    }
    assert seats == {
        "lidar_link": (0.15, -0.05),
        "rear_link": (-0.2, 0.0),
        "imu_link": (0.0, 0.0),
    }, seats
    matched = 0
    for moving in listener.moving:
        assert (moving.header.frame_id, moving.child_frame_id) == ("odom", "base_link")
        same = odometry.get(stamp(moving.header))
        if same is None:
            continue
        matched += 1
        place, turned = moving.transform.translation, moving.transform.rotation
        pose = same.pose.pose
        assert (place.x, place.y) == (pose.position.x, pose.position.y)
        assert (turned.z, turned.w) == (pose.orientation.z, pose.orientation.w)
    assert matched > 50 and listener.moving[-1].transform.translation.x > 0.1, matched
    base.close()


def test_without_package():
    """Without tf2_msgs, the robot says so, and its sensors are in the robot's frame."""
    os.environ["TF2"] = ""
    served = nodes.Served()
    del os.environ["TF2"]
    base = observer()
    frames = []
    base.node.create_subscription(
        LaserScan, "scan", lambda m: frames.append(m.header.frame_id), SENSOR_DATA
    )
    base.until(lambda: frames, "a scan arrives")
    assert base.node.get_publishers_info_by_topic("/tf") == []
    _, errors = served.end()
    assert frames[0] == "base_link", frames
    assert "does not publish /tf, because the package tf2_msgs is not installed" in errors, errors
    base.close()


def test_controller():
    """A program that reads the odometry of a robot publishes no transforms."""
    nodes.write("ahead.frob", nodes.PROGRAM)
    base = nodes.robot()
    run = nodes.Run()
    base.until_driving()
    time.sleep(1)
    assert base.node.get_publishers_info_by_topic("/tf") == []
    assert base.node.get_publishers_info_by_topic("/tf_static") == []
    run.end()
    base.close()


if __name__ == "__main__":
    nodes.run_tests(globals())
