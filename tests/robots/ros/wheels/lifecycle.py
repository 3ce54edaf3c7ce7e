"""Tests managed nodes against rclpy. usage: lifecycle.py FROBC FOLDER"""

import os
import subprocess
import time

import nodes
from lifecycle_msgs.msg import Transition, TransitionEvent
from lifecycle_msgs.srv import ChangeState, GetAvailableStates, GetAvailableTransitions, GetState
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

# Drives for the first second after its start.
BRIEF = """import Robot

main :: DiffDrive o => Program i o
main = reactimateRobot (proc _ -> roMake (setVelTR (if time () < 1[s] then 0.2[m/s] else 0) 0))
"""


class Manager:
    """Manages a node through its services."""

    def __init__(self, base, name="ahead"):
        self.base = base
        self.events = []
        self.name = name
        node = base.node
        node.create_subscription(
            TransitionEvent, f"/{name}/transition_event", self.events.append, 100
        )
        self.change = node.create_client(ChangeState, f"/{name}/change_state")
        self.get = node.create_client(GetState, f"/{name}/get_state")
        assert self.change.wait_for_service(20) and self.get.wait_for_service(20)

    def request(self, label=None, number=0):
        """Requests a transition, and returns whether it succeeded."""
        request = ChangeState.Request()
        request.transition = Transition(id=number, label=label or "")
        return self.base.call(lambda: self.change.call_async(request)).success

    def state(self):
        return self.base.call(lambda: self.get.call_async(GetState.Request())).current_state.label

    def ask(self, kind, service):
        client = self.base.node.create_client(kind, f"/{self.name}/{service}")
        assert client.wait_for_service(20)
        return self.base.call(lambda: client.call_async(kind.Request()))


def times_of(record):
    with open(record, encoding="utf-8") as file:
        lines = [line for line in file if line[0].isdigit()]
    return [float(line.split(",")[0]) for line in lines]


def test_lifecycle():
    """A managed node waits, drives while it is active, and ends when it is shut down."""
    base = nodes.robot()
    record = os.path.join(nodes.FOLDER, "log.csv")
    run = nodes.Run("--lifecycle", "--record", record)
    manager = Manager(base)
    assert manager.state() == "unconfigured"
    time.sleep(1)
    assert base.received == 0
    assert manager.request("configure") and manager.state() == "inactive"
    time.sleep(0.5)
    assert base.received == 0
    assert manager.request(number=Transition.TRANSITION_ACTIVATE)
    base.until_driving()
    assert manager.state() == "active"
    assert manager.request("deactivate")
    base.until_stopped()
    time.sleep(0.2)
    received = base.received
    time.sleep(1)
    assert base.received == received, "an inactive node publishes nothing"
    assert manager.request("activate")
    base.until_driving()
    assert manager.request("shutdown")
    base.until_stopped()
    run.process.wait(timeout=20)
    _, errors = run.end()
    assert run.process.returncode == 0, errors
    replayed = subprocess.run(
        [
            nodes.FROBC,
            "trace",
            "--robot",
            "ros",
            os.path.join(nodes.FOLDER, "ahead.frob"),
            "--input",
            record,
        ],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    with open(record, encoding="utf-8") as file:
        assert nodes.outputs(replayed) == nodes.outputs(file.read())
    times = times_of(record)
    # Its time stands still while it is inactive.
    assert times[0] == 0 and max(b - a for a, b in zip(times, times[1:])) < 0.9, times
    goals = [event.goal_state.label for event in manager.events]
    assert goals[:4] == ["configuring", "inactive", "activating", "active"], goals
    base.close()


def test_refused():
    """A transition that is not possible is refused and reported."""
    base = nodes.robot()
    run = nodes.Run("--lifecycle")
    manager = Manager(base)
    assert not manager.request("activate")
    assert not manager.request(number=Transition.TRANSITION_DEACTIVATE)
    assert manager.state() == "unconfigured"
    states = manager.ask(GetAvailableStates, "get_available_states").available_states
    assert {"unconfigured", "inactive", "active", "finalized"} <= {s.label for s in states}
    possible = manager.ask(GetAvailableTransitions, "get_available_transitions")
    labels = [t.transition.label for t in possible.available_transitions]
    assert labels == ["configure", "shutdown"], labels
    graph = manager.ask(GetAvailableTransitions, "get_transition_graph").available_transitions
    assert len(graph) > 20 and graph[0].start_state.label != "", len(graph)
    _, errors = run.end()
    assert base.received == 0
    assert (
        "the transition `activate` is not possible in the state `unconfigured`; possible: "
        "`configure`, `shutdown`" in errors
    ), errors
    base.close()


def test_reset():
    """A node that is configured again starts from the program's initial state."""
    nodes.write("brief.frob", BRIEF)
    base = nodes.robot()
    record = os.path.join(nodes.FOLDER, "log.csv")
    kept = QoSProfile(depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    instants = []
    base.node.create_subscription(String, "/brief/instants", instants.append, kept)
    run = nodes.Run("--lifecycle", "--record", record, program="brief.frob")
    manager = Manager(base, "brief")
    for label in ["configure", "activate"]:
        assert manager.request(label), label
    base.until_driving()
    base.until_stopped()
    time.sleep(0.5)
    for label in ["deactivate", "activate"]:
        assert manager.request(label), label
    time.sleep(1)
    assert base.v == 0, "without a reset, the program goes on"
    for label in ["deactivate", "cleanup", "configure", "activate"]:
        assert manager.request(label), label
    base.until_driving()
    base.until_stopped()
    _, errors = run.end()
    assert "the recording ends here, because the program was reset" in errors, errors
    assert len(times_of(record)) > 50
    firsts = [message.data for message in instants if message.data.startswith("0 ")]
    assert len(firsts) == 2, "the instants of the second run start again at 0"
    base.close()


PACED = """import Robot

main :: (HasConsole i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (knob "pace" 0 0.5[m/s] 0.1[m/s] i) 0))
"""


def test_parameters():
    """Parameters can be set in all states, and keep their values."""
    nodes.write("paced.frob", PACED)
    base = nodes.robot()
    run = nodes.Run("--lifecycle", program="paced.frob")
    manager = Manager(base, "paced")
    client = AsyncParameterClient(base.node, "/paced")
    assert client.wait_for_services(timeout_sec=20)
    assert nodes.set_one(base, client, "pace", 0.3) == (True, "")
    for label in ["configure", "activate"]:
        assert manager.request(label), label
    base.until(lambda: base.v == 0.3, "it drives at the pace that was set before")
    assert manager.request("deactivate") and manager.request("cleanup")
    base.until_stopped()
    for label in ["configure", "activate"]:
        assert manager.request(label), label
    base.until(lambda: base.v == 0.3, "the parameter has kept its value")
    run.end()
    base.close()


def test_deactivation():
    """Deactivation publishes zero at once."""
    base = nodes.robot()
    run = nodes.Run("--lifecycle")
    manager = Manager(base)
    assert manager.request("configure")
    found = []
    for _ in range(int(os.environ.get("KILLS", "10"))):
        assert manager.request("activate")
        base.until_driving()
        time.sleep(0.1)
        at = time.monotonic()
        assert manager.request("deactivate")
        found.append((base.until_stopped() - at) * 1000)
    run.end()
    found.sort()
    print(
        f"  stopped after deactivation: median {found[len(found) // 2]:.1f} ms, most {found[-1]:.1f} ms"
    )
    base.close()


def test_node_killed():
    """A managed node that is replaced has to be configured and activated again."""
    base = nodes.robot()
    run = nodes.Run("--lifecycle", "--reconnect", "60s")
    manager = Manager(base)
    assert manager.request("configure") and manager.request("activate")
    base.until_driving()
    os.kill(run.children()[1], 9)
    time.sleep(5)
    received = base.received
    time.sleep(1)
    assert base.received == received, "the new node is not active"
    end = time.monotonic() + 60
    again = Manager(base)
    while time.monotonic() < end:
        try:
            if again.state() == "unconfigured":
                break
        except AssertionError:
            continue
    assert again.request("configure") and again.request("activate")
    base.until(lambda: base.received > received, "the node drives again")
    run.end()
    base.close()


if __name__ == "__main__":
    nodes.write("ahead.frob", nodes.PROGRAM)
    nodes.run_tests(globals())
