"""Tests bumpers and the battery against rclpy. usage: bumpers.py FROBC FOLDER"""

import math
import os
import time

import nodes
from geometry_msgs.msg import Twist
from peer import Base
from rclpy.qos import qos_profile_sensor_data as SENSOR_DATA
from sensor_msgs.msg import BatteryState
from std_msgs.msg import Bool

# Drives ahead until the bumper or the battery says otherwise.
CAREFUL = """import Robot

main :: (HasBumpers i, HasBattery i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (speed i) 0)) where
    speed i = if bumpedLeft i then 0
              else if batteryVoltage i < 11[V] then 0.1[m/s] else 0.2[m/s]
"""

WALL = """[start]
x = 0.5
y = 1
[[wall]]
points = [[1, 0], [1, 2]]
"""

LEFT = ["--ros-args", "-r", "bumper_left:=base/bumper"]


def test_bumper():
    """A program stops at a bumper, whose topic the user names."""
    nodes.write("careful.frob", CAREFUL)
    base = nodes.robot()
    publisher = base.node.create_publisher(Bool, "base/bumper", 10)
    run = nodes.Run(*LEFT, program="careful.frob")
    base.until_driving()
    base.until(lambda: publisher.get_subscription_count() > 0, "the node subscribes")
    publisher.publish(Bool(data=True))
    base.until_stopped()
    publisher.publish(Bool(data=False))
    base.until_driving()
    run.end()
    base.close()


def test_battery():
    """The program reads the voltage of the battery; NaN until a message arrives."""
    nodes.write("careful.frob", CAREFUL)
    base = nodes.robot()
    publisher = base.node.create_publisher(BatteryState, "battery_state", 10)
    record = os.path.join(nodes.FOLDER, "log.csv")
    run = nodes.Run("--record", record, *LEFT, "--", program="careful.frob")
    base.until(lambda: base.v == 0.2, "it drives")
    base.until(lambda: publisher.get_subscription_count() > 0, "the node subscribes")
    publisher.publish(BatteryState(voltage=10.5))
    base.until(lambda: base.v == 0.1, "it drives slowly")
    _, errors = run.end()
    assert "battery" not in errors, errors
    with open(record, encoding="utf-8") as file:
        header = file.readline().strip().split(",")
        column = header.index("in.battery")
        voltages = [float(line.split(",")[column]) for line in file]
    assert math.isnan(voltages[0]) and voltages[-1] == 10.5, voltages[-1]
    base.close()


def test_not_configured():
    """A program that reads a bumper without a topic does not start."""
    nodes.write("careful.frob", CAREFUL)
    run = nodes.Run(program="careful.frob")
    run.process.wait(timeout=30)
    _, errors = run.end()
    assert run.process.returncode == 2, run.process.returncode
    assert "careful reads the left bumper of the robot (`bumpedLeft`)" in errors, errors
    assert "add `--ros-args -r bumper_left:=TOPIC`" in errors, errors


def test_simulator():
    """The simulated robot publishes its bumpers and its battery."""
    nodes.write("close.toml", WALL)
    served = nodes.Served("--world", os.path.join(nodes.FOLDER, "close.toml"))
    base = Base(name="observer", odom="unused_odom", cmd_vel="unused_cmd_vel")
    nodes.OPEN.append(base.close)
    seen, voltages = set(), []
    for side in ["left", "right", "back"]:
        base.node.create_subscription(
            Bool,
            f"bumper_{side}",
            lambda message, side=side: seen.add((side, message.data)),
            SENSOR_DATA,
        )
    base.node.create_subscription(
        BatteryState, "battery_state", lambda m: voltages.append(m.voltage), SENSOR_DATA
    )
    base.until(lambda: len(seen) == 3 and voltages, "bumpers and battery arrive")
    assert all(not pressed for _, pressed in seen), seen
    driver = base.node.create_publisher(Twist, "cmd_vel", 10)
    ahead = Twist()
    ahead.linear.x = 0.2

    def bumps():
        driver.publish(ahead)
        return ("left", True) in seen

    base.until(bumps, "the robot bumps into the wall", 30)
    time.sleep(0.1)
    assert ("back", True) not in seen, seen
    assert abs(voltages[-1] - 14.4) < 0.01, voltages[-1]
    _, errors = served.end()
    assert errors == "", errors
    base.close()


if __name__ == "__main__":
    nodes.run_tests(globals())
