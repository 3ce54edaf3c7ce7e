"""Tests programs whose console other nodes operate. usage: consoles.py FROBC FOLDER"""

import math

import nodes
from frames import says
from sensor_msgs.msg import Joy
from std_msgs.msg import Bool, Empty

HELD = """import Robot

main :: (HasConsole i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (speed i) (turn i))) where
    speed i = if buttonHeld "drive" i then knob "pace" 0 0.6[m/s] 0.2[m/s] i else 0
    turn = proc i -> if hold False (tag (buttonPressed "go left!" i) True) then 0.5[rad/s] else 0
"""

JOYSTICK = ["--set", "joy.drive=1", "--set", "joy.pace=0"]


class Joystick:
    """Publishes the state of a joystick twenty times a second."""

    def __init__(self, base):
        self.base = base
        self.axes, self.buttons = [0.0, 0.0], [0, 0]
        self.publisher = base.node.create_publisher(Joy, "joy", 10)
        self.timer = base.node.create_timer(0.05, self.publish)

    def publish(self):
        message = Joy(axes=self.axes, buttons=self.buttons)
        message.header.stamp = self.base.now().to_msg()
        self.publisher.publish(message)


def started(*options):
    """A robot and a program that runs."""
    nodes.write("held.frob", HELD)
    base = nodes.robot()
    joystick = Joystick(base)
    run = nodes.Run(*options, program="held.frob")
    base.until(lambda: base.received > 0, "the program runs", 60)
    return base, joystick, run


def test_joystick():
    """A joystick holds a button and moves a knob."""
    base, joystick, run = started(*JOYSTICK)
    joystick.buttons = [0, 1]
    base.until(lambda: base.v == 0.2, "an axis at rest is the initial value")
    joystick.axes = [1.0, 0.0]
    base.until(lambda: base.v == 0.6, "its end is the maximum")
    joystick.axes = [-0.5, 0.0]
    base.until(lambda: abs(base.v - 0.1) < 1e-9, "between the minimum and the initial value")
    joystick.buttons = [1, 0]
    base.until_stopped()
    _, errors = run.end()
    assert "ignored" not in errors, errors
    base.close()


def test_silent_joystick():
    """A button is released when the joystick falls silent."""
    base, joystick, run = started(*JOYSTICK)
    joystick.buttons = [0, 1]
    base.until_driving()
    joystick.timer.cancel()
    base.until_stopped()
    run.end()
    base.close()


def test_bad_joystick():
    """Messages without the button, or with an axis that is not a number, are reported."""
    base, joystick, run = started(*JOYSTICK)
    joystick.buttons = [1]
    base.until(
        lambda: says(run, "`joy.drive=1` needs 2 buttons, but the joystick has 1"),
        "a missing button is reported",
    )
    joystick.buttons, joystick.axes = [0, 1], [math.nan]
    base.until(lambda: says(run, "an axis is not a finite number"), "NaN is reported")
    assert base.v == 0
    run.end()
    base.close()


def test_press():
    """A message presses a button, and so does a button of the joystick."""
    base, _, run = started(*JOYSTICK)
    publisher = base.node.create_publisher(Empty, "/held/buttons/go_left_", 10)
    base.until(lambda: publisher.get_subscription_count() > 0, "the node subscribes")
    publisher.publish(Empty())
    base.until(lambda: base.turn == 0.5, "the robot turns")
    run.end()
    base.close()
    base, joystick, run = started(*JOYSTICK, "--set", "joy.go left!=0")
    base.until(lambda: joystick.publisher.get_subscription_count() > 0, "the node subscribes")
    joystick.buttons = [0, 1]
    base.until_driving()
    joystick.buttons = [1, 1]
    base.until(lambda: base.turn == 0.5, "the robot turns")
    run.end()
    base.close()


def test_wrong_type():
    """A publisher of another type is reported."""
    base, _, run = started(*JOYSTICK)
    base.node.create_publisher(Bool, "/held/buttons/go_left_", 10)
    base.until(lambda: says(run, "this program needs std_msgs/msg/Empty"), "the type is reported")
    run.end()
    base.close()


if __name__ == "__main__":
    nodes.run_tests(globals())
