"""Tests nodes with topics of their own against rclpy. usage: topics.py FROBC FOLDER"""

import csv
import itertools
import math
import os
import signal
import subprocess
import threading
import time

import rclpy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from nav_msgs.msg import Odometry, Path
from nodes import EXECUTABLE_PATIENT, FOLDER, FROBC, OPEN, Run, colcon_build, run_tests, write
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from sensor_msgs.msg import JointState, Joy, LaserScan, NavSatFix
from std_msgs.msg import Bool, Empty, Float32, Int16, String, UInt8
from visualization_msgs.msg import Marker, MarkerArray


class Peer:
    """A node that publishes and subscribes to any topics, in a thread of its own."""

    def __init__(self, name="peer"):
        OPEN.append(self.close)
        self.context = rclpy.Context()
        rclpy.init(context=self.context)
        self.node = rclpy.create_node(name, context=self.context)
        self.received = {}
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self.closed = False
        self.thread = threading.Thread(target=self.spin, daemon=True)
        self.thread.start()

    def spin(self):
        while not self.closed:
            self.executor.spin_once(timeout_sec=0.02)

    def close(self):
        if self.closed:
            return
        self.closed = True
        self.thread.join()
        self.executor.shutdown()
        self.node.destroy_node()
        rclpy.shutdown(context=self.context)

    def hear(self, kind, topic):
        """Collects the messages of a topic."""
        messages = self.received.setdefault(topic, [])
        self.node.create_subscription(kind, topic, messages.append, 100)
        return messages

    def publisher(self, kind, topic):
        return self.node.create_publisher(kind, topic, 10)

    def repeat(self, seconds, publisher, make):
        """Publishes make() periodically."""
        return self.node.create_timer(seconds, lambda: publisher.publish(make()))


def until(holds, what, seconds=40.0):
    """Waits until a condition holds."""
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            raise AssertionError(f"never: {what}")
        time.sleep(0.005)


def matched(publisher):
    until(lambda: publisher.get_subscription_count() > 0, "the node subscribes")


def publish_until(publisher, message, holds, what):
    """Publishes a message until a condition holds. With best-effort delivery, messages may be lost,
    in particular the first one."""
    published = []

    def repeats():
        if not published or time.monotonic() > published[-1] + 0.5:
            publisher.publish(message)
            published.append(time.monotonic())
        return holds()

    until(repeats, what)


def rows_of(text):
    """A recording or trace as a list of dictionaries."""
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


ENABLED = """import Robot
import Ros

data In = In { enable :: Event Bool, console :: Console }
data Out = Out { cmdVel :: Twist, blocked :: Event Bool }

instance HasConsole In where
    keyPressed _ = NoEvent
    console i = i.console

-- Drives while it is enabled.
main :: Program In Out
main = node 50[Hz] (proc i -> Out
    { cmdVel = twist (if hold False i.enable then knob "pace" 0 1[m/s] 0.2[m/s] i else 0) 0
    , blocked = i.enable
    })
"""


def enabled(*options, **executable):
    """Starts that program, and returns the peer, the run, the velocities and a publisher."""
    write("enabled.frob", ENABLED)
    peer = Peer()
    velocities = peer.hear(Twist, "cmd_vel")
    enable = peer.publisher(Bool, "enable")
    return peer, Run(*options, program="enabled.frob", **executable), velocities, enable


def test_topics():
    """An event of a Bool switches the velocity; the run is replayed bit for bit."""
    record = os.path.join(FOLDER, "log.csv")
    peer, run, velocities, enable = enabled("--record", record)
    blocked = peer.hear(Bool, "blocked")
    matched(enable)
    until(lambda: len(velocities) > 10, "it publishes")
    assert all(v.linear.x == 0 for v in velocities)
    for data, speed, what in [
        (True, 0.2, "it drives"),
        (False, 0.0, "it stops"),
        (True, 0.2, "it drives again"),
    ]:
        publish_until(
            enable, Bool(data=data), lambda speed=speed: velocities[-1].linear.x == speed, what
        )
    output, errors = run.end()
    until(lambda: velocities[-1].linear.x == 0, "the end of the run stops it")
    assert [data for data, _ in itertools.groupby(b.data for b in blocked)] == [True, False, True]
    expected = "node /enabled, subscribes to /enable, publishes /cmd_vel, /blocked"
    assert expected in output, (output, errors)
    with open(record, encoding="utf-8") as file:
        recorded = rows_of(file.read())
    steps = [float(b["time"]) - float(a["time"]) for a, b in zip(recorded, recorded[1:])]
    assert abs(sorted(steps)[len(steps) // 2] - 0.02) < 0.003, steps[:10]
    replayed = subprocess.run(
        [FROBC, "trace", os.path.join(FOLDER, "enabled.frob"), "--input", record],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    for a, b in zip(recorded, rows_of(replayed), strict=True):
        assert all(a[column] == value for column, value in b.items() if column != "time"), (a, b)


def test_package():
    """colcon builds a package whose node has topics of its own, and the node runs."""
    write("enabled.frob", ENABLED)
    node = colcon_build("enabled")
    peer, run, velocities, enable = enabled(
        *EXECUTABLE_PATIENT, *["--ros-args", "-p", "pace:=0.5"], patient=False, executable=node
    )
    blocked = peer.hear(Bool, "blocked")
    matched(enable)
    until(lambda: len(velocities) > 10, "it publishes")
    assert all(v.linear.x == 0 for v in velocities)
    at_pace = "it drives at the pace of the parameter"
    publish_until(enable, Bool(data=True), lambda: velocities[-1].linear.x == 0.5, at_pace)
    until(lambda: blocked and blocked[0].data, "it publishes the event")
    output, errors = run.end()
    until(lambda: velocities[-1].linear.x == 0, "the end of the run stops it")
    assert "node /enabled, subscribes to /enable" in output, (output, errors)


def test_remapped():
    """Topics of a node's own are remapped; its knobs are parameters."""
    write("enabled.frob", ENABLED)
    peer = Peer()
    velocities = peer.hear(Twist, "base/cmd_vel")
    enable = peer.publisher(Bool, "go")
    run = Run(
        *["--ros-args", "-r", "enable:=go", "-r", "cmd_vel:=base/cmd_vel", "-r", "__node:=mover"],
        program="enabled.frob",
    )
    matched(enable)
    until(lambda: len(velocities) > 10, "it publishes")
    enable.publish(Bool(data=True))
    until(lambda: velocities[-1].linear.x == 0.2, "it drives")
    client = AsyncParameterClient(peer.node, "mover")
    until(client.services_are_ready, "the node has parameters")
    client.set_parameters([Parameter("pace", value=0.5)])
    until(lambda: velocities[-1].linear.x == 0.5, "it drives faster")
    run.end()


WIDE = """import Ros

data In = In
    { scan :: Event (Counted (LaserScan 8))
    , odom :: Odometry
    , joy :: Event (Joy 2 4)
    , level :: Event Int16
    , go :: Event ()
    }

data Out = Out
    { cmdVel :: TwistStamped
    , nearest :: Event (Float32[m])
    , missed :: Event UInt8
    , went :: Event ()
    , copy :: Odometry
    , sticks :: Event (Joy 3 1)
    , levelOut :: Event UInt8
    }

main :: Program In Out
main = node 10[Hz] (proc i -> Out
    { cmdVel = TwistStamped { twist = twist i.odom.twist.twist.linear.x ((robotIn i.odom).heading / 1[s]) }
    , nearest = mapE (\\c -> Float32 { data_ = nearestRay (-20[deg]) 20[deg] c.message }) i.scan
    , missed = mapE (\\c -> UInt8 { data_ = c.missed }) i.scan
    , went = i.go
    , copy = i.odom
    , sticks = mapE sticks i.joy
    , levelOut = mapE (\\l -> UInt8 { data_ = l.data_ }) i.level
    }) where
    sticks joy = Joy
        { axes = Upto { count = joy.axes.count, items = [at 0 0 joy.axes.items, 0.5, 0.75] }
        , buttons = Upto { count = 9, items = [joy.buttons.count] }
        }
"""


def odometry(x=0.0, heading=0.0, speed=0.0):
    message = Odometry()
    message.pose.pose.position.x = x
    message.pose.pose.orientation.z = math.sin(heading / 2)
    message.pose.pose.orientation.w = math.cos(heading / 2)
    message.twist.twist.linear.x = speed
    return message


def test_messages():
    """Records, sequences, headers, counts and numbers of all sizes are converted."""
    write("wide.frob", WIDE)
    peer = Peer()
    velocities = peer.hear(TwistStamped, "cmd_vel")
    nearest = peer.hear(Float32, "nearest")
    missed = peer.hear(UInt8, "missed")
    went = peer.hear(Empty, "went")
    copies = peer.hear(Odometry, "copy")
    sticks = peer.hear(Joy, "sticks")
    levels = peer.hear(UInt8, "level_out")
    odom = peer.publisher(Odometry, "odom")
    scan = peer.publisher(LaserScan, "scan")
    joy = peer.publisher(Joy, "joy")
    level = peer.publisher(Int16, "level")
    go = peer.publisher(Empty, "go")
    run = Run("--rate", "2", program="wide.frob")
    for publisher in [odom, scan, joy, level, go]:
        matched(publisher)
    time.sleep(0.5)
    assert not velocities, "it runs without odometry"
    peer.repeat(0.05, odom, lambda: odometry(3.0, 0.5, 0.25))
    until(lambda: velocities and velocities[-1].twist.linear.x == 0.25, "it reads the odometry")
    assert abs(velocities[-1].twist.angular.z - 0.5) < 1e-9
    assert abs(velocities[-1].header.stamp.sec - time.time()) < 5
    assert velocities[-1].header.frame_id == "base_link"
    until(lambda: copies and copies[-1].pose.pose.position.x == 3.0, "it copies the odometry")
    assert copies[-1].header.frame_id == "odom"
    assert copies[-1].pose.covariance[0] == 0
    # Several messages arrive before an instant: it reads the newest one.
    ranges = [0.5, 4.0, 2.0, math.nan, math.inf, 1.0, 9.0, 9.0, 0.125, 0.125]
    for offset in [3.0, 2.0, 0.0]:
        message = LaserScan(angle_min=-0.2, angle_max=0.25, angle_increment=0.05)
        message.range_min, message.range_max = 0.1, 8.0
        message.ranges = [r + offset for r in ranges]
        scan.publish(message)
    until(lambda: nearest and missed, "it reads the scan")
    time.sleep(0.7)
    assert sum(m.data + 1 for m in missed) == 3, missed
    # The last two of ten ranges are cut off.
    assert nearest[-1].data == 0.5, nearest
    go.publish(Empty())
    until(lambda: len(went) == 1, "it goes")
    joy.publish(Joy(axes=[0.25, 1.0, 1.0], buttons=[1, 0, 1]))
    until(lambda: sticks, "it reads the joystick")
    assert list(sticks[0].axes) == [0.25, 0.5] and list(sticks[0].buttons) == [3], sticks
    for value, expected in [(-5, 0), (300, 255), (7, 7)]:
        level.publish(Int16(data=value))
        until(lambda: levels and levels[-1].data == expected, f"{value} becomes {expected}")
    _, errors = run.end()
    assert "warning" not in errors, errors


GUARDED = """import Ros

data In = In { odom :: Odometry }
data Out = Out { cmdVel :: Twist }

main :: Program In Out
main = node 50[Hz] (proc i -> Out
    { cmdVel = twist (if (robotIn i.odom).position.x > 5[m] then 0/0 else 0.3[m/s]) 0
    })
"""


def guarded():
    write("guarded.frob", GUARDED)
    peer = Peer()
    velocities = peer.hear(Twist, "cmd_vel")
    place = [1.0]
    odom = peer.publisher(Odometry, "odom")
    timer = peer.repeat(0.02, odom, lambda: odometry(place[0]))
    return velocities, place, timer


def test_silence():
    """Without messages on a plain topic, commands are zero; numbers that are not finite, too."""
    velocities, place, timer = guarded()
    run = Run(program="guarded.frob")
    until(lambda: velocities and velocities[-1].linear.x == 0.3, "it drives")
    timer.cancel()
    until(lambda: velocities[-1].linear.x == 0, "it stops")
    time.sleep(0.5)
    assert velocities[-1].linear.x == 0
    timer.reset()
    until(lambda: velocities[-1].linear.x == 0.3, "it drives again")
    place[0] = 6.0
    until(lambda: velocities[-1].linear.x == 0, "it replaces NaN")
    _, errors = run.end()
    assert "`cmdVel` has a number that is not finite; zero is published instead" in errors, errors


def test_killed():
    """Commands are zero after a process of the node was killed."""
    velocities, _, _ = guarded()
    for kill in [
        lambda run: os.kill(run.children()[0], signal.SIGKILL),
        lambda run: os.kill(run.process.pid, signal.SIGKILL),
        lambda run: os.killpg(run.process.pid, signal.SIGKILL),
    ]:
        run = Run(program="guarded.frob")
        until(lambda: velocities and velocities[-1].linear.x == 0.3, "it drives")
        kill(run)
        until(lambda: velocities[-1].linear.x == 0, "it stops")
        run.end()
        time.sleep(0.5)


REFUSED = """import Ros

data Odd = Odd { FIELDS }

instance Message Odd where
    rosType _ = "TYPE"

data In = In { odd :: Event Odd }
data Out = Out { heard :: Event () }

main :: Program In Out
main = node 50[Hz] (proc i -> Out { heard = mapE (\\_ -> ()) i.odd })
"""


def refusal(type_, fields):
    """The message about a node that cannot start."""
    write("odd.frob", REFUSED.replace("TYPE", type_).replace("FIELDS", fields))
    run = Run("--for", "1s", program="odd.frob")
    run.process.wait(timeout=60)
    _, errors = run.end()
    assert run.process.returncode != 0, errors
    return errors


def test_refused():
    """Types of messages that do not exist or do not match the record are named."""
    for type_, fields, expected in [
        ("no_msgs/msg/Odd", "x :: Int", "the ROS 2 message package no_msgs is not installed"),
        (
            "std_msgs/msg/Odd",
            "x :: Int",
            "the package std_msgs of the sourced ROS 2 has no message Odd",
        ),
        (
            "geometry_msgs/msg/Point",
            "x, q :: Float",
            "geometry_msgs/msg/Point has no field for `q` of `Odd`",
        ),
        (
            "geometry_msgs/msg/Point",
            "x :: Int",
            "the field `x` of `Odd` is `Int`, but geometry_msgs/msg/Point has `float64 x`",
        ),
        (
            "sensor_msgs/msg/Imu",
            "orientationCovariance :: Array 3 Float",
            "but sensor_msgs/msg/Imu has `float64[9] orientation_covariance`",
        ),
        (
            "std_msgs/msg/String",
            "data_ :: Float",
            "the field `data_` of `Odd` is `Float`, but std_msgs/msg/String has `string data`",
        ),
    ]:
        errors = refusal(type_, fields)
        assert expected in errors, errors


def test_refused_at_start():
    """A node compares types that frobc does not find, as on another machine, when it starts."""
    # The libraries of tf2_msgs are in the path of libraries, but not in AMENT_PREFIX_PATH.
    for type_, fields, expected in [
        ("no_msgs/msg/Odd", "x :: Int", "the ROS 2 message package no_msgs is not installed"),
        (
            "tf2_msgs/msg/Odd",
            "x :: Int",
            "the package tf2_msgs of this ROS 2 installation has no message Odd",
        ),
        (
            "tf2_msgs/msg/TFMessage",
            "transforms :: Int",
            "in tf2_msgs/msg/TFMessage, `transforms` is a message (several), but in the record "
            "`Odd` it is neither an array nor an `Upto`: declare it as `Upto` of a record",
        ),
        (
            "tf2_msgs/msg/TFMessage",
            "least :: Int",
            "tf2_msgs/msg/TFMessage has no field for `least` of the record `Odd`: rename or remove",
        ),
    ]:
        errors = refusal(type_, fields)
        assert expected in errors, errors


TEXTS = """import Geometry
import Ros

data Mode = Idle | Driving
instance RosText Mode where
    rosText mode = case mode of
        Idle -> "idle"
        Driving -> "driving\N{LATIN SMALL LETTER E WITH ACUTE}"
data Frame = Map | Odom
instance RosText Frame where
    rosText frame = case frame of
        Map -> "map"
        Odom -> "odom"
data Goal = Goal { header :: Header Frame, pose :: Pose3 }
instance Message Goal where
    rosType _ = "geometry_msgs/msg/PoseStamped"
data Unstamped = Unstamped { header :: FrameOnly, pose :: Pose3 }
data FrameOnly = FrameOnly { frameId :: Frame }
instance Message Unstamped where
    rosType _ = "geometry_msgs/msg/PoseStamped"
data Joints = Joints { name :: Upto 3 (Maybe Mode), position :: Upto 3 Angle }
instance Message Joints where
    rosType _ = "sensor_msgs/msg/JointState"

data In = In
    { mode :: Event Mode
    , open :: Event (Maybe Mode)
    , goal :: Event Goal
    , joints :: Event Joints
    , fix :: Event NavSatFix
    }
data Out = Out
    { modeOut :: Event Mode
    , openOut :: Event (Maybe Mode)
    , goalOut :: Event Goal
    , unstamped :: Event Unstamped
    , jointsOut :: Event Joints
    , diagnostics :: Event (DiagnosticArray 2 1 Mode Mode Frame Frame)
    , path :: Event (Path 2)
    , estimate :: Event OdometryWithCovariance
    , fixOut :: Event NavSatFix
    }

main :: Program In Out
main = node 50[Hz] (proc i -> Out
    { modeOut = i.mode
    , openOut = i.open
    , goalOut = i.goal
    , unstamped = mapE (\\g -> Unstamped { header = FrameOnly { frameId = g.header.frameId }, pose = g.pose }) i.goal
    , jointsOut = i.joints
    , diagnostics = mapE report i.mode
    , path = mapE (\\g -> Path { poses = Upto { count = 1, items = [PoseStamped { pose = g.pose }, PoseStamped { pose = g.pose }] } }) i.goal
    , estimate = mapE estimated i.goal
    , fixOut = i.fix
    }) where
    report m = DiagnosticArray { status = Upto { count = 1, items = [state m, state m] } }
    state m = DiagnosticStatus
        { level = diagnosticWarn, name = m, message = Idle
        , values = Upto { count = 1, items = [KeyValue { key = Map, value = Odom }] }
        }
    estimated g = OdometryWithCovariance
        { pose = PoseWithCovariance { pose = g.pose, covariance = covariances }
        , twist = TwistWithCovariance { twist = twist 0 0, covariance = covariances }
        }
    covariances = generate toFloat
"""


def test_texts():
    """Texts are enumerations, also in arrays and headers; unknown ones are reported once."""
    write("texts.frob", TEXTS)
    peer = Peer()
    modes = peer.hear(String, "mode_out")
    opened = peer.hear(String, "open_out")
    goals = peer.hear(PoseStamped, "goal_out")
    unstamped = peer.hear(PoseStamped, "unstamped")
    joints = peer.hear(JointState, "joints_out")
    diagnostics = peer.hear(DiagnosticArray, "diagnostics")
    paths = peer.hear(Path, "path")
    estimates = peer.hear(Odometry, "estimate")
    fixes = peer.hear(NavSatFix, "fix_out")
    mode = peer.publisher(String, "mode")
    open_ = peer.publisher(String, "open")
    goal = peer.publisher(PoseStamped, "goal")
    joint = peer.publisher(JointState, "joints")
    fix = peer.publisher(NavSatFix, "fix")
    run = Run(program="texts.frob")
    for publisher in [mode, open_, goal, joint, fix]:
        matched(publisher)
    time.sleep(1)
    for text in ["idle", "driving\u00e9", "blink", "blink", "\x1b[31m", "idle"]:
        mode.publish(String(data=text))
        open_.publish(String(data=text))
        time.sleep(0.2)
    until(lambda: len(modes) == 3 and len(opened) == 6, "it repeats the texts it knows")
    assert [m.data for m in modes] == ["idle", "driving\u00e9", "idle"], modes
    assert [m.data for m in opened] == ["idle", "driving\u00e9", "", "", "", "idle"], opened
    status = diagnostics[1].status
    assert len(status) == 1 and status[0].name == "driving\u00e9", status
    assert status[0].level == b"\x01" and status[0].message == "idle", status
    assert status[0].values[0].key == "map" and status[0].values[0].value == "odom", status
    assert status[0].hardware_id == "" and diagnostics[1].header.stamp.sec > 0, status
    message = PoseStamped()
    message.header.frame_id = "map"
    message.header.stamp.sec, message.header.stamp.nanosec = 7, 999999999
    message.pose.position.x = 2.5
    goal.publish(message)
    until(lambda: goals and unstamped and paths and estimates, "it repeats the goal")
    assert goals[0] == message, goals
    assert unstamped[0].header.frame_id == "map", unstamped
    assert abs(unstamped[0].header.stamp.sec - time.time()) < 5, unstamped
    assert paths[0].header.frame_id == "odom" and len(paths[0].poses) == 1, paths
    assert paths[0].poses[0].header.frame_id == "odom", paths
    assert paths[0].poses[0].header.stamp == paths[0].header.stamp, paths
    assert list(estimates[0].pose.covariance) == list(range(36)), estimates
    assert list(estimates[0].twist.covariance) == list(range(36)), estimates
    joint.publish(JointState(name=["idle", "elbow"], position=[0.5, 1.5]))
    until(lambda: joints, "it repeats the joints")
    assert list(joints[0].name) == ["idle", ""] and list(joints[0].position) == [0.5, 1.5], joints
    satellites = NavSatFix(latitude=51.5, longitude=-0.1, position_covariance_type=2)
    satellites.status.status, satellites.status.service = -1, 3
    satellites.position_covariance = [float(k) for k in range(9)]
    fix.publish(satellites)
    until(lambda: fixes, "it repeats the position")
    fixes[0].header = satellites.header
    assert fixes[0] == satellites, fixes
    _, errors = run.end()
    assert errors.count('a message on /mode is ignored: its `data` is "blink"') == 1, errors
    assert errors.count('a message on /open is read with `Nothing`: its `data` is "blink"') == 1
    assert errors.count('"?[31m"') == 2 and "\x1b" not in errors, errors
    assert errors.count('its `name` is "elbow"') == 1, errors


SHAPES = """import Geometry
import Ros

data In = In { scan :: Event (LaserScan 4) }
data Out = Out { shapes :: Event (MarkerArray 2 4), shape :: Event (Marker 4) }

main :: Program In Out
main = node 50[Hz] (proc i -> Out
    { shapes = mapE (\\s -> MarkerArray { markers = Upto { count = 2, items = [shapeOf 7 s, shapeOf 8 s] } }) i.scan
    , shape = mapE (shapeOf 9) i.scan
    })

shapeOf :: Int -> LaserScan 4 -> Marker 4
shapeOf k scan = Marker
    { id = k
    , type_ = markerPoints
    , action = markerAdd
    , pose = Pose3
        { position = Vec3 { x = scan.rangeMax, y = 0, z = 0 }
        , orientation = Quaternion { x = 0, y = 0, z = 0, w = 1 }
        }
    , scale = Vec3 { x = 0.1[m], y = 0.2[m], z = 0 }
    , color = ColorRGBA { r = 1, g = 0.5, b = 0, a = 1 }
    , lifetime = Duration { sec = 2, nanosec = 5 }
    , frameLocked = True
    , points = Upto { count = scan.ranges.count, items = map (\\r -> Vec3 { x = r, y = 0, z = 0 }) scan.ranges.items }
    , colors = Upto { count = 0, items = generate (\\_ -> ColorRGBA { r = 0, g = 0, b = 0, a = 0 }) }
    }
"""


def test_markers():
    """A program publishes markers of its own, alone and in arrays."""
    write("shapes.frob", SHAPES)
    peer = Peer()
    arrays = peer.hear(MarkerArray, "shapes")
    shapes = peer.hear(Marker, "shape")
    scan = peer.publisher(LaserScan, "scan")
    run = Run(program="shapes.frob")
    matched(scan)
    time.sleep(1)
    scan.publish(LaserScan(range_max=4.0, ranges=[1.0, 2.0, 3.0]))
    until(lambda: arrays and shapes, "it publishes the markers")
    assert [m.id for m in arrays[0].markers] == [7, 8], arrays
    for marker, k in [(arrays[0].markers[1], 8), (shapes[0], 9)]:
        assert (marker.id, marker.type, marker.action) == (k, Marker.POINTS, Marker.ADD), marker
        assert marker.header.frame_id == "odom" and marker.header.stamp.sec > 0, marker
        assert marker.pose.position.x == 4.0 and marker.pose.orientation.w == 1.0, marker
        assert (marker.scale.x, marker.scale.y, marker.color.g) == (0.1, 0.2, 0.5), marker
        assert (marker.lifetime.sec, marker.lifetime.nanosec) == (2, 5), marker
        assert [p.x for p in marker.points] == [1.0, 2.0, 3.0], marker
        assert len(marker.colors) == 0 and marker.frame_locked, marker
    _, errors = run.end()
    assert "warning" not in errors, errors


ALL = """import Geometry
import Ros

data Mode = Idle | Driving
instance RosText Mode where
    rosText mode = case mode of
        Idle -> "idle"
        Driving -> "driving"

data All = All
    { FIELDS
    }

main :: Program All All
main = node 20[Hz] identity
"""

# Every type of messages in the library.
TYPES = [
    *["Vec3[m]", "Quaternion", "Pose3", "PointStamped", "PoseStamped", "PoseArray 2"],
    *["PoseWithCovarianceStamped", "Twist", "TwistStamped", "TwistWithCovarianceStamped", "Accel"],
    *["Wrench", "WrenchStamped", "Odometry", "OdometryWithCovariance", "Path 2", "LaserScan 3"],
    *["Imu", "ImuWithCovariance", "Range", "BatteryState", "Joy 1 2", "JointState 2"],
    *["Temperature", "FluidPressure", "MagneticField", "NavSatFix", "NavSatStatus"],
    *["KeyValue Mode Mode", "DiagnosticStatus 2 Mode Mode Mode Mode", "Float32[m]", "UInt8"],
    *["DiagnosticArray 2 1 Mode Mode Mode Mode", "Int16", "ColorRGBA", "Stamp", "Duration"],
    *["Header Mode", "Bool", "Int", "Float", "()", "Mode", "Marker 3", "MarkerArray 2 3"],
]


def test_all_types():
    """This ROS 2 has all message types of the library, with the same fields."""
    fields = [f"t{k} :: Event ({type_})" for k, type_ in enumerate(TYPES)]
    write("all.frob", ALL.replace("FIELDS", "\n    , ".join(fields)))
    run = Run("--for", "0.5s", program="all.frob")
    run.process.wait(timeout=120)
    output, errors = run.end()
    assert run.process.returncode == 0 and "node /all" in output, (output, errors)


def test_other_type():
    """A topic with messages of another type is named."""
    peer = Peer()
    enable = peer.publisher(String, "enable")
    peer.repeat(0.1, enable, lambda: String(data="True"))
    write("enabled.frob", ENABLED)
    run = Run("--for", "3s", program="enabled.frob")
    run.process.wait(timeout=60)
    _, errors = run.end()
    assert "/enable has two types" in errors and "std_msgs/msg/String" in errors, errors


if __name__ == "__main__":
    run_tests(globals())
