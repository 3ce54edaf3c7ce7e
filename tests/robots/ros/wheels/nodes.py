"""Tests programs as ROS 2 nodes against rclpy. usage: nodes.py FROBC FOLDER

Prints a line for each test. Each test starts a robot's base (peer.py) and a program.
"""

import csv
import os
import shutil
import signal
import subprocess
import sys
import time

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from peer import Base
from rcl_interfaces.msg import ParameterEvent
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from rclpy.qos import DurabilityPolicy, QoSProfile
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore
from sensor_msgs.msg import Imu
from std_msgs.msg import String

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

    def __init__(self, *options, patient=True, program="ahead.frob", executable=None):
        self.errors = open(os.path.join(FOLDER, "errors"), "w+", encoding="utf-8")
        OPEN.append(self.abandon)
        # frobc replaces itself with the program.
        self.process = subprocess.Popen(
            (
                [os.path.join(FOLDER, "with"), executable]
                if executable
                else [FROBC, "run", "--ros2", os.path.join(FOLDER, program)]
            )
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
    write(
        "paced.frob",
        "import Robot\n\nparam pace :: Velocity = 0.2[m/s]\n\n"
        "main :: DiffDrive o => Program i o\n"
        "main = reactimateRobot (proc _ -> roMake (setVelTR pace 0))\n",
    )
    base = robot()
    run = Run("--ros-args", "-p", "pace:=0.125", program="paced.frob")
    base.until(lambda: base.v == 0.125, "the robot drives at the pace of the parameter")
    run.end()
    base.close()


TUNED = """import Robot

param gain :: Float = 2
param rays :: Int = 4

main :: (HasConsole i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (speed i) 0)) where
    speed i = if toggle "moves" True i then knob "pace" 0 0.5[m/s] 0.1[m/s] i else 0
"""


CLAIMS = """import Robot

main :: (HasOdometry i, DiffDrive o) => Program i o
main = reactimateRobot drive

drive :: (HasOdometry i, DiffDrive o) => SF i o
drive = proc i -> roMake (setVelTR 0.2[m/s] 0) where
    assert "stays near" ((place i).x < 0.4[m])
    assert "stays on the floor" True
"""


def write(name, text):
    """Writes a program."""
    with open(os.path.join(FOLDER, name), "w", encoding="utf-8") as file:
        file.write(text)


def set_one(base, client, name, value):
    """Sets a parameter; returns whether it succeeded, and the reason."""
    answer = base.call(lambda: client.set_parameters([Parameter(name, value=value)]))
    return answer.results[0].successful, answer.results[0].reason


def test_parameter_services():
    """Other nodes list, read, describe and set parameters of the node."""
    write("tuned.frob", TUNED)
    base = robot()
    record = os.path.join(FOLDER, "tuned.csv")
    events = []
    base.node.create_subscription(ParameterEvent, "/parameter_events", events.append, 10)
    run = Run(
        *["--record", record],
        *["--ros-args", "-p", "gain:=3.5", "-p", "pace:=0.2"],
        program="tuned.frob",
    )
    client = AsyncParameterClient(base.node, "/tuned")
    base.until(lambda: base.v == 0.2, "an argument sets a knob")
    assert client.wait_for_services(timeout_sec=10)
    names = base.call(client.list_parameters).result.names
    assert names == ["gain", "rays", "moves", "pace", "use_sim_time"], names
    got = base.call(lambda: client.get_parameters(["gain", "rays", "moves", "pace", "other"]))
    values = [(v.type, v.double_value, v.integer_value, v.bool_value) for v in got.values]
    assert values == [
        (3, 3.5, 0, False),
        (2, 0.0, 4, False),
        (1, 0.0, 0, True),
        (3, 0.2, 0, False),
        (0, 0.0, 0, False),
    ], values
    assert list(base.call(lambda: client.get_parameter_types(["gain", "x"])).types) == [3, 0]
    described = base.call(lambda: client.describe_parameters(["gain", "pace"])).descriptors
    assert described[0].read_only and not described[1].read_only
    assert described[1].description == "m/s; knob on the program's console", described[1]
    assert described[1].floating_point_range[0].to_value == 0.5
    assert set_one(base, client, "pace", 0.3) == (True, "")
    base.until(lambda: base.v == 0.3, "a knob is set during the run")
    ok, reason = set_one(base, client, "pace", 5.0)
    assert not ok and reason == "`pace` must be a number from 0 to 0.5 m/s, not 5", reason
    ok, reason = set_one(base, client, "pace", "fast")
    assert not ok and "has the type double, but the value has the type string" in reason, reason
    ok, reason = set_one(base, client, "gain", 1.0)
    assert not ok and reason.startswith("`gain` is fixed during a run"), reason
    ok, reason = set_one(base, client, "speed", 1.0)
    assert not ok and reason.startswith("the node has no parameter `speed`"), reason
    both = [Parameter("moves", value=False), Parameter("pace", value=9.0)]
    answer = base.call(lambda: client.set_parameters_atomically(both)).result
    assert not answer.successful and "pace" in answer.reason, answer
    time.sleep(0.3)
    assert base.v == 0.3, "nothing is set if one value is refused"
    both = [Parameter("moves", value=False), Parameter("pace", value=0.4)]
    assert base.call(lambda: client.set_parameters_atomically(both)).result.successful
    base.until_stopped()
    base.until(lambda: len(events) >= 3, "each change is an event")
    assert events[0].node == "/tuned", events[0]
    os.kill(run.children()[1], 9)
    # Requests may still go to the node that was killed.
    futures = []

    def answered():
        if not futures or time.monotonic() > futures[-1][0] + 1:
            request = client.get_parameters(["moves", "pace"])
            futures.append((time.monotonic(), request))
        return any(f.done() for _, f in futures)

    base.until(answered, "another node offers the services", 40)
    got = next(f.result() for _, f in futures if f.done())
    assert got.values[1].double_value == 0.4 and not got.values[0].bool_value, got
    _, errors = run.end()
    with open(record, encoding="utf-8") as file:
        lines = file.read().splitlines()
    assert lines[0] == "# param gain=3.5", lines[0]
    replayed = subprocess.run(
        [FROBC, "trace", "--robot", "ros", os.path.join(FOLDER, "tuned.frob"), "--input", record],
        check=True,
        capture_output=True,
        text=True,
    ).stdout.splitlines()
    speeds = [row.split(",")[1] for row in replayed[1:]]
    start = next(i for i, line in enumerate(lines) if line.startswith("time")) + 1
    column = lines[start - 1].split(",").index("out.forward")
    assert speeds == [line.split(",")[column] for line in lines[start:]], errors
    base.close()


def test_parameter_file():
    """Parameter files set parameters, as launch files do."""
    write("tuned.frob", TUNED)
    write("values.yaml", "/**:\n  ros__parameters:\n    pace: 0.25\n    gain: 3.0\n    rays: 7\n")
    base = robot()
    record = os.path.join(FOLDER, "tuned.csv")
    values = os.path.join(FOLDER, "values.yaml")
    run = Run("--record", record, "--ros-args", "--params-file", values, program="tuned.frob")
    base.until(lambda: base.v == 0.25, "the file sets a knob")
    run.end()
    with open(record, encoding="utf-8") as file:
        assert [next(file).strip() for _ in range(2)] == ["# param gain=3", "# param rays=7"]
    write("values.yaml", "tuned:\n  ros__parameters:\n    pace: fast\n")
    run = Run("--ros-args", "--params-file", values, program="tuned.frob")
    run.process.wait(timeout=20)
    _, errors = run.end()
    assert "`pace` has the type double, but the value has the type string" in errors, errors
    base.close()


def test_simulated_time():
    """The instants follow /clock, at any speed, and after a restart of the simulator."""
    base = robot()
    base.simulated = 0.25
    record = os.path.join(FOLDER, "log.csv")
    run = Run("--record", record, "--ros-args", "-p", "use_sim_time:=true")
    base.until_driving()
    time.sleep(4)
    base.restarted = 500
    time.sleep(4)
    _, errors = run.end()
    assert "the time of /clock jumped back by 500" in errors or "by 499.9" in errors, errors
    with open(record, encoding="utf-8") as file:
        times = [float(line.split(",")[0]) for line in file.readlines()[1:]]
    assert times == sorted(times) and 1.2 < times[-1] < 3.5, times[-1]
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


def test_diagnostics():
    """The verdicts on assertions are published on /diagnostics."""
    write("claims.frob", CLAIMS)
    base = robot()
    seen = []
    base.node.create_subscription(DiagnosticArray, "/diagnostics", seen.append, 10)
    run = Run(program="claims.frob")
    base.until(lambda: seen and seen[-1].status[0].level == b"\2", "an assertion fails")
    run.end()
    assert seen[0].status[0].level == b"\0", seen[0]
    last = seen[-1].status
    assert last[0].name == "claims: stays near" and "violated" in last[0].message, last
    assert last[1].level == b"\0" and last[1].message == "held", last
    base.close()


def test_durability():
    """A subscriber of velocities with another durability is reported."""
    base = robot(cmd_vel="other")
    old = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    base.node.create_subscription(Twist, "cmd_vel", base.command, old)
    run = Run()
    time.sleep(4)
    _, errors = run.end()
    assert "subscribes to /cmd_vel with the durability" in errors, errors
    assert base.received == 0
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
    assert "there is another node named /ahead" in errors, errors
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
    assert "its position is not a finite number" in errors, errors
    assert "jumped back by 30" in errors or "jumped back by 29.9" in errors, errors
    base.close()


class Served:
    """The simulated robot, as a node."""

    def __init__(self, *options):
        self.errors = open(os.path.join(FOLDER, "serve_errors"), "w+", encoding="utf-8")
        OPEN.append(self.abandon)
        self.process = subprocess.Popen(
            [FROBC, "serve", "--robot", "ros", *options],
            stdout=subprocess.PIPE,
            stderr=self.errors,
            text=True,
        )
        self.names = [self.process.stdout.readline().strip() for _ in range(5)]

    def abandon(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()

    def end(self):
        """Interrupts it, and returns its summary as a table, and its messages."""
        self.process.send_signal(signal.SIGINT)
        output, _ = self.process.communicate(timeout=20)
        self.errors.seek(0)
        rows = [line.split(": ", 1) for line in output.splitlines() if ": " in line]
        return dict(rows), self.errors.read()


def teleop(*arguments):
    """Runs the third-party node, and returns what it prints."""
    here = os.path.dirname(os.path.abspath(__file__))
    return subprocess.run(
        [sys.executable, os.path.join(here, "teleop.py"), *arguments],
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    ).stdout


def distance(summary):
    """The driven distance in a summary."""
    return float(summary["distance driven"].split()[0])


def test_simulator():
    """A plain rclpy node drives the simulated robot, which stops when the node has ended."""
    served = Served()
    assert served.names == [
        "node: /robot",
        "odometry: /odom",
        "lidar: /scan",
        "imu: /imu",
        "velocity: /cmd_vel",
    ], served.names
    seen = teleop("6")
    time.sleep(1)
    summary, errors = served.end()
    counts = eval(seen[: seen.index("}") + 1])  # noqa: S307
    assert counts["odom"] > 100 and counts["scan"] > 20 and counts["imu"] > 100, seen
    assert counts["clock"] > 200 and seen.strip().endswith("back 0"), seen
    # Until the robot stops, it drives on for up to half a second.
    assert 0.8 < distance(summary) < 2.1, (summary, seen)
    assert errors == "", errors


def test_simulator_stamped():
    """The simulated robot takes TwistStamped with --stamped, and otherwise names that option."""
    served = Served("--stamped", "--ros-args", "-r", "odom:=base/odom", "-r", "__ns:=/sim", "--")
    assert served.names[:2] == ["node: /sim/robot", "odometry: /sim/base/odom"], served.names
    served.end()
    served = Served("--stamped")
    teleop("8", "stamped")
    summary, errors = served.end()
    assert distance(summary) > 0.2 and errors == "", (summary, errors)
    served = Served()
    teleop("6", "stamped")
    summary, errors = served.end()
    assert distance(summary) == 0 and "add --stamped" in errors, (summary, errors)


def test_simulator_and_program():
    """A program drives the simulated robot through ROS 2, in the time of /clock."""
    served = Served()
    record = os.path.join(FOLDER, "log.csv")
    run = Run("--for", "6s", "--record", record, "--ros-args", "-p", "use_sim_time:=true", "--")
    run.process.wait(timeout=60)
    output, errors = run.end()
    assert run.process.returncode == 0, errors
    summary, _ = served.end()
    assert 0.6 < distance(summary) < 2, (summary, output, errors)


def colcon_build(program):
    """Exports a program as a package, builds it with colcon, and returns its executable."""
    workspace = os.path.join(FOLDER, "workspace")
    shutil.rmtree(workspace, ignore_errors=True)
    package = os.path.join(workspace, "src", program)
    subprocess.run(
        [FROBC, "export", os.path.join(FOLDER, program + ".frob"), "--ros2", package], check=True
    )
    prefix = os.environ["AMENT_PREFIX_PATH"]
    built = subprocess.run(
        [os.path.join(prefix, "bin", "colcon"), "--log-base", "log", "build"],
        cwd=workspace,
        capture_output=True,
        text=True,
        env={
            **os.environ,
            "PATH": os.path.join(prefix, "bin") + ":" + os.environ["PATH"],
            "CMAKE_PREFIX_PATH": prefix,
            # The libraries of the wheels refer to Python.
            "LDFLAGS": "-Wl,--allow-shlib-undefined",
        },
    )
    assert built.returncode == 0, built.stdout[-2000:] + built.stderr[-2000:]
    share = os.path.join(workspace, "install", program, "share", program)
    assert os.path.exists(os.path.join(share, "launch", program + ".launch.py"))
    return os.path.join(workspace, "install", program, "lib", program, program)


# `frobc run` has units in its options, and an executable has not.
EXECUTABLE_PATIENT = ["--patience", "1", "--set", "late=1"]


def test_package():
    """colcon builds an exported package, and its node drives a robot."""
    node = colcon_build("ahead")
    base = robot()
    run = Run(*EXECUTABLE_PATIENT, patient=False, executable=node)
    base.until_driving()
    run.end()
    base.until_stopped()
    base.close()


class Recorder:
    """Records all messages of some topics in a bag, as `ros2 bag record` does."""

    def __init__(self, base, topics):
        self.topics = topics
        self.messages = []  # (topic, time of arrival, data)
        qos = QoSProfile(depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        for topic, (kind, _) in topics.items():
            base.node.create_subscription(
                kind,
                topic,
                lambda data, topic=topic: self.messages.append((topic, time.time_ns(), data)),
                qos if kind is String else 10,
                raw=True,
            )

    def write(self, folder, plugin):
        """Writes the bag."""
        shutil.rmtree(folder, ignore_errors=True)
        store = get_typestore(Stores.ROS2_JAZZY)
        with Writer(folder, version=9, storage_plugin=plugin) as writer:
            connections = {
                topic: writer.add_connection(topic, name, typestore=store)
                for topic, (_, name) in self.topics.items()
            }
            for topic, at, data in self.messages:
                writer.write(connections[topic], at, bytes(data))


def outputs(text):
    """The outputs in a recording or a trace."""
    rows = list(csv.reader(line for line in text.splitlines() if not line.startswith("#")))
    forward, turn = rows[0].index("out.forward"), rows[0].index("out.turn")
    return [(row[forward], row[turn]) for row in rows[1:]]


def test_bag():
    """A bag is replayed, and the outputs are equal bit for bit."""
    base = robot()
    base.wall = 1.5
    text = (String, "std_msgs/msg/String")
    recorder = Recorder(
        base,
        {
            "/approach/columns": text,
            "/approach/instants": text,
            "/odom": (Odometry, "nav_msgs/msg/Odometry"),
        },
    )
    record = os.path.join(FOLDER, "log.csv")
    run = Run("--record", record, "--for", "4s", program="approach.frob")
    run.process.wait(timeout=60)
    _, errors = run.end()
    time.sleep(0.5)
    base.close()
    with open(record, encoding="utf-8") as file:
        recorded = outputs(file.read())
    assert len(recorded) > 100 and errors == "", (len(recorded), errors)
    for plugin in [StoragePlugin.SQLITE3, StoragePlugin.MCAP]:
        bag = os.path.join(FOLDER, "bag")
        recorder.write(bag, plugin)
        replayed = subprocess.run(
            [FROBC, "trace", os.path.join(FOLDER, "approach.frob"), "--input", bag],
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        assert outputs(replayed) == recorded, plugin


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


def run_tests(tests):
    """Runs the functions whose names begin with test_, or those that the command line names."""
    failures = 0
    for name, test in list(tests.items()):
        if not name.startswith("test_"):
            continue
        if len(sys.argv) > 3 and name not in sys.argv[3:]:
            continue
        try:
            test()
            print(f"ok {test.__doc__}", flush=True)
        except (AssertionError, LookupError, OSError, subprocess.SubprocessError) as error:
            failures += 1
            print(f"FAIL {test.__doc__}\n{error}", flush=True)
        while OPEN:
            OPEN.pop()()
    sys.exit(1 if failures else 0)


def main():
    with open(os.path.join(FOLDER, "ahead.frob"), "w", encoding="utf-8") as file:
        file.write(PROGRAM)
    here = os.path.dirname(os.path.abspath(__file__))
    shutil.copy(os.path.join(here, "..", "approach.frob"), FOLDER)
    run_tests(globals())


if __name__ == "__main__":
    main()
