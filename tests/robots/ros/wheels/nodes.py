"""Tests programs as ROS 2 nodes against rclpy. usage: nodes.py FROBC FOLDER

Prints a line for each test. Each test starts a robot's base (peer.py) and a program.
"""

import os
import shutil
import signal
import subprocess
import sys
import time

from peer import Base
from rclpy.qos import QoSProfile
from sensor_msgs.msg import Imu

FROBC, FOLDER = sys.argv[1:3]
# On a busy machine, messages may be late.
PATIENT = ["--patience", "1s", "--set", "late=1"]

PROGRAM = """import Robot

-- Drives ahead.
main :: (HasOdometry i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (if (place i).x < 100[m] then 0.2[m/s] else 0) 0))
"""


# Objects to close after each test, even after a failed one.
OPEN = []


def robot(**options):
    """Starts the base of a robot."""
    base = Base(**options)
    OPEN.append(base.close)
    return base


class Run:
    """A program that runs as a node."""

    def __init__(self, *options, patient=True, program="ahead.frob"):
        self.errors = open(os.path.join(FOLDER, "errors"), "w+", encoding="utf-8")
        OPEN.append(self.abandon)
        # frobc replaces itself by the program.
        self.process = subprocess.Popen(
            [FROBC, "run", "--ros2", os.path.join(FOLDER, program)]
            + (PATIENT if patient else [])
            + list(options),
            stdout=subprocess.PIPE,
            stderr=self.errors,
            text=True,
            start_new_session=True,
        )

    def children(self):
        """The processes of the controller and of the node."""
        path = f"/proc/{self.process.pid}/task/{self.process.pid}/children"
        with open(path, encoding="utf-8") as file:
            return [int(word) for word in file.read().split()][:2]

    def abandon(self):
        """Ends it after a failure."""
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait()

    def end(self):
        """Interrupts it, and returns its output and its messages."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        output, _ = self.process.communicate(timeout=20)
        self.errors.seek(0)
        return output, self.errors.read()


def test_drives():
    """A program drives a robot whose odometry is reliable."""
    base = robot()
    run = Run("--for", "2s")
    base.until_driving()
    base.until(lambda: base.x > 0.2, "it has driven 0.2 m")
    base.until(lambda: "ahead" in base.node.get_node_names(), "the node has the program's name")
    output, errors = run.process.communicate()[0], run.end()[1]
    assert run.process.returncode == 0, errors
    assert "node /ahead, odometry from /odom, velocity to /cmd_vel" in output, output
    base.until_stopped()
    base.close()


def test_best_effort():
    """A program drives a robot whose odometry is best effort."""
    base = robot(reliable=False)
    run = Run()
    base.until_driving()
    run.end()
    base.until_stopped()
    base.close()


def test_lidar():
    """A program for sonars stops before a wall that the robot's lidar sees."""
    base = robot()
    base.wall = 1.2
    record = os.path.join(FOLDER, "log.csv")
    run = Run("--record", record, program="approach.frob")
    base.until_driving()
    base.until(lambda: 0.4 < base.wall - base.x < 0.75 and base.v < 0.02, "it stands at the wall")
    _, errors = run.end()
    with open(record, encoding="utf-8") as file:
        header = file.readline()
        rows = file.readlines()
    # A row has a scan if its array of distances is not empty.
    scans = sum("Just" in row for row in rows)
    assert scans > 5 and "lidar" in header, (scans, header, errors)
    base.close()


def test_remapping():
    """Topics, the node and its namespace are remapped."""
    base = robot(odom="/robot1/base/odom", cmd_vel="/robot1/drive")
    run = Run(
        "--ros-args",
        *["-r", "odom:=base/odom", "-r", "cmd_vel:=drive"],
        *["-r", "__node:=follower", "-r", "__ns:=/robot1"],
    )
    base.until_driving()
    base.until(
        lambda: ("follower", "/robot1") in base.node.get_node_names_and_namespaces(),
        "the node has the new name and namespace",
    )
    run.end()
    base.close()


def test_parameter():
    """An argument for ROS sets a parameter of the program."""
    with open(os.path.join(FOLDER, "paced.frob"), "w", encoding="utf-8") as file:
        file.write(
            "import Robot\n\nparam pace :: Velocity = 0.2[m/s]\n\n"
            "main :: DiffDrive o => Program i o\n"
            "main = reactimateRobot (proc _ -> roMake (setVelTR pace 0))\n"
        )
    base = robot()
    run = Run("--ros-args", "-p", "pace:=0.125", program="paced.frob")
    base.until(lambda: base.v == 0.125, "the robot drives at the pace of the parameter")
    run.end()
    base.close()


def test_stamped():
    """A setting selects TwistStamped; without it, the node explains how to set it."""
    base = robot(stamped=True)
    run = Run("--set", "stamped=1")
    base.until_driving()
    run.end()
    run = Run()
    time.sleep(4)
    _, errors = run.end()
    assert "subscribes to geometry_msgs/msg/TwistStamped" in errors, errors
    assert "add `--set stamped=1`" in errors, errors
    base.close()


def test_other_type():
    """A topic of another type is reported."""
    base = robot(odom="other")
    base.node.create_publisher(Imu, "odom", QoSProfile(depth=5))
    run = Run()
    time.sleep(4)
    _, errors = run.end()
    assert "the node base publishes sensor_msgs/msg/Imu" in errors, errors
    base.close()


def test_late_robot():
    """The robot may start after the program, and restart."""
    run = Run("--reconnect", "60s")
    time.sleep(3)
    base = robot()
    base.until_driving()
    base.close()
    time.sleep(2)
    base = robot()
    base.until_driving()
    _, errors = run.end()
    assert "no node publishes /odom" in errors, errors
    base.until_stopped()
    base.close()


def test_same_name():
    """Another node of the same name is reported."""
    base = robot(name="ahead")
    run = Run()
    base.until_driving()
    time.sleep(2)
    _, errors = run.end()
    assert "there is another node of the name /ahead" in errors, errors
    base.close()


def test_bad_odometry():
    """The robot stops on silence, NaN, and timestamps that jump."""
    base = robot()
    run = Run(patient=False)
    base.until_driving()
    for name, bad, good in [("silent", True, False), ("nan", True, False), ("shift", -30.0, -30.0)]:
        setattr(base, name, bad)
        base.until_stopped()
        time.sleep(0.2)
        assert base.v == 0, name
        setattr(base, name, good)
        base.until_driving()
    _, errors = run.end()
    assert "its position is not a number" in errors, errors
    assert "jumped back by 30" in errors or "jumped back by 29.9" in errors, errors
    base.close()


def latencies(name, kill, times):
    """Prints the time from killing a process until the robot is stopped, in ms."""
    found = []
    base = robot()
    for _ in range(times):
        run = Run()
        base.until_driving()
        time.sleep(0.1)
        at = time.monotonic()
        kill(run)
        found.append((base.until_stopped() - at) * 1000)
        run.end()
    base.close()
    found.sort()
    print(f"  stopped after {name}: median {found[times // 2]:.1f} ms, most {found[-1]:.1f} ms")
    return found


def test_killed():
    """The robot is stopped when a process of the program is killed."""
    times = int(os.environ.get("KILLS", "5"))
    latencies("the controller was killed", lambda r: os.kill(r.children()[0], 9), times)
    latencies("the supervisor was killed", lambda r: os.kill(r.process.pid, 9), times)
    latencies("all in its session were killed", lambda r: os.killpg(r.process.pid, 9), times)


def test_node_killed():
    """A killed node is replaced, and the robot drives on."""
    base = robot()
    run = Run()
    base.until_driving()
    first = run.children()[1]
    os.kill(first, 9)
    base.until(lambda: any(c[1] == 0 for c in base.commands[1:]), "the new node stops the robot")
    base.until_driving()
    assert run.children()[1] != first
    run.end()
    base.close()


def main():
    with open(os.path.join(FOLDER, "ahead.frob"), "w", encoding="utf-8") as file:
        file.write(PROGRAM)
    here = os.path.dirname(os.path.abspath(__file__))
    shutil.copy(os.path.join(here, "..", "approach.frob"), FOLDER)
    failures = 0
    for name, test in list(globals().items()):
        if not name.startswith("test_"):
            continue
        if len(sys.argv) > 3 and name not in sys.argv[3:]:
            continue
        try:
            test()
            print(f"ok {test.__doc__}", flush=True)
        except (AssertionError, LookupError, OSError) as error:
            failures += 1
            print(f"FAIL {test.__doc__}\n{error}", flush=True)
        while OPEN:
            OPEN.pop()()
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
