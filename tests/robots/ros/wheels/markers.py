"""Tests the markers of programs that draw. usage: markers.py FROBC FOLDER"""

import os
import subprocess

import nodes
from visualization_msgs.msg import Marker, MarkerArray

DRAWS = """import Display
import Geometry
import Robot

main :: (HasOdometry i, DiffDrive o, HasDisplay o) => Program i o
main = reactimateRobot (proc i -> marks i (roMake (setVelTR 0.2[m/s] 0))) where
    marks i = if (place i).x < 0.4[m] then near . always i else always i
    always i = draw (InWorld Red (Circle goal 0.5[m])) . draw (InWorld Yellow (Cross (place i)))
    near = draw (OnRobot Green (Arrow zero ahead)) . draw (OnRobot Blue (label zero "near \\\"it\\\""))
    goal = Vec2 { x = 2[m], y = 1[m] }
    zero = Vec2 { x = 0, y = 0 }
    ahead = Vec2 { x = 0.5[m], y = 0 }
"""


class Viewer:
    """Shows markers as rviz does."""

    def __init__(self, base, topic="/draws/markers"):
        self.shown, self.received = {}, 0
        base.node.create_subscription(MarkerArray, topic, self.show, 10)

    def show(self, message):
        self.received += 1
        for marker in message.markers:
            if marker.action == Marker.ADD:
                self.shown[marker.ns, marker.id] = marker
            elif marker.action == Marker.DELETE:
                self.shown.pop((marker.ns, marker.id), None)

    def of_type(self, type_):
        return [marker for marker in self.shown.values() if marker.type == type_]


def test_markers():
    """A node publishes what the program draws, and removes what it no longer draws."""
    nodes.write("draws.frob", DRAWS)
    base = nodes.robot()
    viewer = Viewer(base)
    run = nodes.Run(program="draws.frob")
    base.until(lambda: len(viewer.shown) == 4, "four markers appear", 60)
    (circle,) = viewer.of_type(Marker.LINE_STRIP)
    assert circle.header.frame_id == "odom" and circle.ns == "draws", circle
    assert len(circle.points) == 37 and circle.points[0] == circle.points[-1]
    assert abs(circle.points[0].x - 2.5) < 1e-9 and circle.color.a == 1.0, circle
    (arrow,) = viewer.of_type(Marker.ARROW)
    assert arrow.header.frame_id == "base_link" and arrow.points[1].x == 0.5, arrow
    (text,) = viewer.of_type(Marker.TEXT_VIEW_FACING)
    assert text.text == 'near "it"', text
    base.until(lambda: len(viewer.shown) == 2, "two of them are removed")
    (cross,) = viewer.of_type(Marker.LINE_LIST)
    assert len(cross.points) == 4 and cross.points[0].x > 0.3, cross
    _, errors = run.end()
    assert "ignored" not in errors, errors
    base.until(lambda: not viewer.shown, "the others are removed at the end")
    base.close()


def test_executable():
    """The executable of `frobc build` has markers if the user asks for them."""
    nodes.write("draws.frob", DRAWS)
    base = nodes.robot()
    viewer = Viewer(base)
    path = os.path.join(nodes.FOLDER, "draws")
    build = [nodes.FROBC, "build", "--ros2", path + ".frob", "-o", path]
    subprocess.run(build, check=True)
    run = nodes.Run("--patience", "1", "--set", "late=1", patient=False, executable=path)
    base.until(lambda: base.x > 0.1, "the robot drives", 30)
    run.end()
    assert viewer.received == 0, viewer.shown
    subprocess.run([*build, "--markers"], check=True)
    run = nodes.Run("--patience", "1", "--set", "late=1", patient=False, executable=path)
    base.until(lambda: viewer.received > 3, "markers arrive", 30)
    run.end()
    base.close()


if __name__ == "__main__":
    nodes.run_tests(globals())
