"""Tests the Gymnasium environment: without an agent it performs the same run as `frob.simulate`. If
gymnasium is not installed, tests the layer below it.
"""

import os
import threading
import unittest
import warnings

import numpy as np

import checks
import frob
from frob.drive import Drive

try:
    import frob.gym
except frob.Error:
    pass

FOLLOW = """import Robot
import WallFollow

param distance :: Distance = 0.3[m]

main :: Program RobotInput RobotOutput
main = reactimateRobot (wallFollow1 distance)
"""

KNOB = """import Robot

main :: (HasConsole i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (knob "speed" 0 0.4[m/s] 0.1[m/s] i) 0))
"""


def write(name, text):
    with open(name, "w") as file:
        file.write(text)
    return name


def drive(name, **options):
    given = dict(world=None, robot=None, entry="main", sources=(), rate=50.0, picture=False)
    return Drive(name, **{**given, **options})


class Driven(unittest.TestCase):
    def setUp(self):
        self.file = write("follow.frob", FOLLOW)

    def test_as_simulated(self):
        """Bit for bit the same if nothing is overridden."""
        table = frob.simulate(self.file, duration=4, seed=5, params={"distance": 0.4})
        driven = drive(self.file)
        names = [name for name in table if name.startswith("in") and name != "in.key"]
        for _ in range(2):
            driven.start(5, {"distance": 0.4})
            for row in range(len(table)):
                self.assertEqual(driven.time, table["time"][row])
                for name, value in zip(names, driven.values(names)):
                    told = table[name][row]
                    told = told.item() if hasattr(told, "item") else told
                    self.assertEqual(repr(value), repr(told), (name, row))
                driven.step({}, {})
                self.assertEqual(
                    driven.values(["out.forward", "out.turn"]),
                    table[["out.forward", "out.turn"]].iloc[row].tolist(),
                )

    def test_an_outage_of_the_world(self):
        """As in `frobc run`, the program has no instant during an outage, and the first command
        after it is a stop, although the program outputs a speed."""
        world = write(
            "away.toml", "[start]\nx = 1\ny = 1\n[outage]\nfrom = 1\nlasts = 0.5\nevery = 2\n"
        )
        file = write(
            "drives.frob",
            "import Robot\nmain :: DiffDrive o => Program i o\n"
            "main = reactimateRobot (proc _ -> roMake (setVelTR (0.1[m/s^2] * time ()) 0))\n",
        )
        table = frob.simulate(file, world=world, robot="pioneer", duration=4)
        names = [name for name in table if name.startswith("in") and name != "in.key"]
        driven = drive(file, world=world, robot="pioneer", lasts=4.0)
        driven.start(1, {})
        for row in range(len(table)):
            self.assertEqual(driven.time, table["time"][row])
            for name, value in zip(names, driven.values(names)):
                told = table[name][row]
                self.assertEqual(repr(value), repr(told.item() if hasattr(told, "item") else told))
            driven.step({}, {})
            self.assertEqual(driven.values(["out.forward"])[0], table["out.forward"][row])
        times = table["time"].tolist()
        self.assertEqual([b - a > 0.5 for a, b in zip(times, times[1:])].count(True), 2)
        self.assertGreaterEqual(driven.time, 4)

    def test_an_outage_that_does_not_end(self):
        world = write("gone.toml", "[start]\nx = 1\ny = 1\n[outage]\nfrom = 1\nlasts = 1e5\n")
        driven = drive(self.file, world=world, robot="pioneer", lasts=2.0)
        driven.start(1, {})
        for _ in range(50):
            driven.step({}, {})
        self.assertEqual(driven.time, 2)

    def test_a_robot_of_ones_own(self):
        example = os.path.abspath(f"{os.environ['FROB_ROOT']}/examples/light_seek")
        moth, body = f"{example}/Moth.frob", f"{example}/moth_body.c"
        file = f"{example}/light_seek.frob"
        table = frob.simulate(file, robot=moth, sources=[body], duration=1, seed=2)
        driven = drive(file, robot=moth, sources=[body])
        driven.start(2, {})
        for row in range(len(table)):
            driven.step({}, {})
            self.assertEqual(
                driven.values(["out.forward", "out.turn"]),
                table[["out.forward", "out.turn"]].iloc[row].tolist(),
            )

    def test_another_acts(self):
        driven = drive(self.file)
        driven.start(1, {})
        for _ in range(100):
            driven.step({}, {"out.forward": -0.2, "out.turn": 0.0})
        self.assertLess(driven.truth().x, 1.0)
        blind = drive(self.file)
        blind.start(1, {})
        sonars = [f"in.sonar[{k}]" for k in range(16)]
        for _ in range(5):
            blind.step({name: 0.05 for name in sonars}, {})
        self.assertLessEqual(blind.values(["out.forward"])[0], 0)

    def test_knob(self):
        driven = drive(write("knob.frob", KNOB), robot="pioneer")
        driven.start(1, {})
        driven.step({}, {})
        self.assertEqual(driven.values(["out.forward"]), [0.1])
        driven.step({"in.console.speed": 0.3}, {})
        self.assertEqual(driven.values(["out.forward"]), [0.3])

    def test_mistakes(self):
        driven = drive(self.file)
        with self.assertRaisesRegex(frob.Error, "has not been started, or is closed: reset it"):
            driven.step({}, {})
        driven.start(1, {})
        driven.close()
        driven.close()
        with self.assertRaisesRegex(frob.Error, "has not been started, or is closed"):
            driven.truth()
        with self.assertRaisesRegex(
            frob.InputError, "follow has no numeric column `out.left`; it has: in.od"
        ):
            driven.numbers(["out.left"])
        with self.assertRaisesRegex(frob.Error, "a world needs a table .start."):
            drive(self.file, world=write("empty.toml", ""))
        with self.assertRaisesRegex(frob.Error, "has several robots"):
            text = "[[start]]\nx = 1\ny = 1\n[[start]]\nx = 3\ny = 3\n"
            drive(self.file, world=write("two.toml", text)).start(1, {})
        with self.assertRaisesRegex(frob.Error, "is not a robot program"):
            drive(write("half.frob", "main :: SF Float Float\nmain = proc x -> x / 2\n"))

    def test_threads(self):
        """Closing while another thread drives raises an error and does not crash."""
        driven = drive(self.file)
        driven.start(1, {})
        sim = driven._sim
        told = []

        def go():
            try:
                while True:
                    driven.step({}, {})
            except frob.Error as error:
                told.append(str(error))

        thread = threading.Thread(target=go)
        thread.start()
        sim.close()
        thread.join()
        self.assertEqual(told, ["the simulation is closed"])


@unittest.skipUnless(hasattr(frob, "gym"), "no gymnasium")
class Environment(unittest.TestCase):
    def environment(self, **options):
        def ahead(moment):
            return moment.truth.x - moment.before.x

        given = dict(reward=ahead, limits={"out.forward": (-0.4, 0.4), "out.turn": (-1, 1)})
        return frob.gym.RobotEnv(write("follow.frob", FOLLOW), **{**given, **options})

    def test_checked(self):
        from gymnasium.utils.env_checker import check_env

        env = self.environment(duration=1.0)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # it recommends limits for all columns
            check_env(env, skip_render_check=True)
        env.reset(seed=3)
        ends = [env.step(np.array([0.4, 0.0])) for _ in range(50)]
        self.assertEqual([cut for *_, cut, _ in ends], 49 * [False] + [True])
        self.assertGreater(sum(reward for _, reward, *_ in ends), 0.1)

    def test_collision(self):
        env = self.environment(picture=True)
        env.reset(seed=1)
        steps = 0
        while not env.step(np.array([0.4, 0.0]))[2]:
            steps += 1
            self.assertLess(steps, 2000)
        self.assertTrue(env.unwrapped._info()["truth"].touches)
        self.assertIn("<svg", env.picture())
        env.close()

    def test_sensors(self):
        """An event is observed as its last value, and as the upper limit before it first occurs."""
        env = self.environment(observation=["in.sonar[3]"], limits={"in.sonar[3]": (0, 3)})
        seen = [env.reset(seed=1)[0][0], *(env.step(np.zeros(2))[0][0] for _ in range(30))]
        events = frob.simulate("follow.frob", duration=1, seed=1)["in.sonar[3]"]
        self.assertEqual(seen[0], 3)
        self.assertTrue(any(event is None for event in events[20:30]))
        self.assertTrue(all(0 < value < 3 for value in seen[20:]))

    def test_part_of_an_output(self):
        """The program determines everything that the agent does not set."""
        env = self.environment(
            action=["out.turn"], observation=["out.forward", "in.sonar[3]"], limits={}
        )
        env.reset(seed=1)
        seen, *_ = env.step(np.array([0.0]))
        self.assertEqual(seen[0], frob.simulate("follow.frob", duration=0.01)["out.forward"][0])

    def test_operator(self):
        """A knob has its own limits; values beyond them are clipped."""
        env = frob.gym.RobotEnv(
            write("knob.frob", KNOB),
            robot="pioneer",
            reward=lambda moment: 0,
            action=["in.console.speed"],
            observation=["out.forward"],
        )
        self.assertEqual((env.action_space.low, env.action_space.high), (0, 0.4))
        env.reset(seed=1)
        self.assertEqual([env.step(np.array([x]))[0].item() for x in (0.2, 9)], [0.2, 0.4])

    def test_mistakes(self):
        for text, options in [
            ("follow has no numeric column `out.left`", dict(action=["out.left"], limits={})),
            (
                "limits: `in.x` is in neither `action` nor `observation`",
                dict(limits={"in.x": (0, 1)}),
            ),
            ("the minimum is greater than the maximum", dict(limits={"out.turn": (1, -1)})),
            ("must each name at least one column", dict(action=[], limits={})),
            ("it has no parameter|follow has no parameter `far`", dict(params={"far": 1})),
            ("duration: expected seconds, found nan", dict(duration=float("nan"))),
        ]:
            with self.assertRaisesRegex(frob.Error, text):
                self.environment(**options)
        env = self.environment()
        with self.assertRaisesRegex(frob.Error, "reset it first"):
            env.step(np.zeros(2))
        env.reset(seed=1)
        for action in (np.zeros(3), np.array([np.nan, 0])):
            with self.assertRaisesRegex(frob.InputError, r"expected an action of shape \(2,\)"):
                env.step(action)


if __name__ == "__main__":
    checks.main("the simulator in Python")
