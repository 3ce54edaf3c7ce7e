"""Tests margins of assertions, and the search for violations."""

import os
import random
import shlex
import subprocess
import sys
import unittest
import unittest.mock

import numpy as np

import checks
import frob
from frob import library, search
from frob.judging import FAILS, Subject, _seen

SIGNALS = ["i.x", "i.y", "i.z"]


def condition(r, depth):
    if depth == 0:
        s, t = r.sample(SIGNALS, 2)
        other = r.choice([t, f"{r.randrange(-3, 4)}"])
        return r.choice(
            [
                f"({s} > {other})",
                f"({s} <= {other})",
                f"({s} == {other})",
                f"({s} /= {other})",
                f"(round {s} >= round {t})",
                "i.b",
                f"(i.b == ({s} < 1))",
                "(time () > 7[s])",
            ]
        )
    f, g = condition(r, depth - 1), condition(r, r.randrange(depth))
    q = r.choice(["0[s]", "1[s]", "2.5[s]", "patience", "100[s]"])
    return r.choice(
        [
            f"(not {f})",
            f"({f} && {g})",
            f"({f} || {g})",
            f"(if {f} then i.b else i.x < i.y)",
            f"(holds (implies {f} {g}))",
            f"(ever {f})",
            f"(always {f})",
            f"(since ({f}, {g}))",
            f"(within {q} {f})",
            f"(heldFor {q} {f})",
            f"(holds (afterwards ({f}, {g})))",
            f"(holds (respondsWithin {q} ({f}, {g})))",
            f"(holds (by {q} {f}))",
            f"(helper {f} {g})",
            f"(inside ({f}, {g}))",
            f"(local {f})",
            f"(holds (max (verdict {f}) ({g} `implies` {f})))",
            f"(delay True {f} || {g})",
        ]
    )


def program(claims):
    return """import Past
data In = In { x :: Float, y :: Float, z :: Float, b :: Bool }
param patience :: Time = 3[s]

helper :: Bool -> Bool -> Bool
helper p q = if r then q else not p where
    r = p && q

inside :: SF (Bool, Bool) Bool
inside = proc (p, q) -> y where
    y    = been || q
    been = within 2[s] p

local :: SF Bool Bool
local = proc p -> heldFor 1[s] p || not (delay False p)

main :: SF In Float
main = proc i -> i.x where
""" + "".join(f'    assert "{k}" {claim}\n' for k, claim in enumerate(claims))


def built(text):
    with open("it.frob", "w") as file:
        file.write(text)
    return library.build("it.frob", "main", None, (), asserts="margin")


CRUISE = """import Past
data In = In { wanted :: Velocity, ahead :: Distance }

param most :: Velocity = 0.5[m/s]
param brakes :: Bool = True

main :: SF In Velocity
main = proc i -> v where
    near = brakes && i.ahead < 0.3[m]
    v    = if near then 0 else min most i.wanted
    assert "stops" (i.ahead < 0.25[m] `implies` (v == 0))
    assert "is slow" (v <= 0.8[m/s])
    assume "is in front" (i.ahead > 0)
"""
# Without parentheses around its first argument it would be another program.
CRUISE = CRUISE.replace("(i.ahead < 0.25[m] `implies`", "((i.ahead < 0.25[m]) `implies`")

INPUTS = {"in.wanted": "-1 to 1", "in.ahead": "-1 to 3"}


class Margins(unittest.TestCase):
    def test_the_sign_of_a_margin_is_the_verdict(self):
        r = random.Random(7)
        certain = 0
        for _ in range(6):
            claims = [condition(r, 1 + r.randrange(3)) for _ in range(20)]
            subject = Subject(built(program(claims)), 30.0, 1.7)
            count = len(subject.time)
            draw = np.random.RandomState(r.randrange(1000))
            inputs = {
                f"in.{s}": np.repeat(draw.randint(-4, 5, count // 3 + 1) * 1.0, 3)[:count]
                for s in "xyz"
            }
            inputs["in.z"][draw.rand(count) < 0.1] = np.nan
            inputs["in.y"][draw.rand(count) < 0.1] = np.inf
            inputs["in.b"] = draw.rand(count) < 0.5
            memory = subject._output({"patience": r.choice([0.0, 2.0])}, inputs)
            for claim, text in zip(subject.claims, claims):
                _, tags = _seen(claim.verdict, memory, count, subject.code.table.output_size)
                values = {}
                for name in claim.margin.columns:
                    leaf = subject.leaves[f"probe.{name}"]
                    values[name] = _seen(leaf, memory, count, subject.code.table.output_size)[1]
                margin = claim.margin.over(subject.nanoseconds, values)
                fails = tags == FAILS
                wrong = ((margin > 0) & fails) | ((margin < 0) & ~fails)
                self.assertFalse(wrong.any(), f"{text} at {np.argmax(wrong)}: {margin[wrong]}")
                certain += int((margin != 0).sum())
        self.assertGreater(certain, 3000)

    def test_a_comparison_is_a_difference(self):
        subject = Subject(built(CRUISE), 2.0, 1.0)
        claims = {claim.label: claim for claim in subject.claims}
        ahead = np.array([1.0, 0.5, 0.4])
        inputs = {"in.wanted": np.array([0.1, 0.6, 0.2]), "in.ahead": ahead}
        value, failed = subject.judged(claims["is slow"], {"most": 0.7}, inputs)
        self.assertAlmostEqual(value, 0.8 - 0.6)
        self.assertIsNone(failed)
        value, failed = subject.judged(
            claims["is slow"], {"most": 1.0}, {**inputs, "in.wanted": ahead}
        )
        self.assertAlmostEqual(value, 0.8 - 1.0)
        self.assertEqual(failed, 0)

    def test_what_does_not_run_is_not_judged(self):
        subject = Subject(
            built("""import Past
main :: SF Float Float
main = switch (proc x -> (x, when (time () >= 3[s]))) (\\_ -> later)

later :: SF Float Float
later = proc x -> x where
    assert "less" (always (x < 5))
"""),
            6.0,
            1.0,
        )
        value, failed = subject.judged(
            subject.claims[0], {}, {"in": np.array([9.0, 9, 9, 1, 2, 3, 1])}
        )
        self.assertEqual((value, failed), (2.0, None))
        value, failed = subject.judged(
            subject.claims[0], {}, {"in": np.array([9.0, 9, 9, 1, 2, 6, 1])}
        )
        self.assertEqual((value, failed), (-1.0, 5))


class Falsify(unittest.TestCase):
    def look(self, **options):
        with open("cruise.frob", "w") as file:
            file.write(CRUISE)
        options = {"inputs": INPUTS, "duration": 5, "rate": 10, "method": "random", **options}
        return frob.falsify("cruise.frob", **options)

    def test_what_is_found_is_a_run_of_the_program(self):
        stops, slow = self.look(params={"most": "0.2[m/s] to 1[m/s]", "brakes": (False, True)})
        for label, found in [("stops", stops.found), ("is slow", slow.found)]:
            found.write("found.csv")
            settings = [f"--param={name}={value}" for name, value in found.settings.items()]
            told = subprocess.run(
                [frob.tools.frobc(), "trace", "cruise.frob", "--input", "found.csv", *settings],
                capture_output=True,
                text=True,
            )
            self.assertIn(f'"{label}": violated, first at {found.time:.3f}', told.stderr)
        self.assertLess(slow.found.margin, 0)
        self.assertIs(stops.found.params["brakes"], False)

    def test_what_cannot_fail_is_not_found(self):
        slow = self.look(only=["is slow"], runs=40)[0]
        self.assertIsNone(slow.found)
        self.assertEqual(slow.runs, 40)
        self.assertAlmostEqual(slow.nearest, 0.3)

    def test_the_same_seed_finds_the_same(self):
        params = {"most": (0.2, 1)}
        one, two = (self.look(params=params, only=["is slow"], seed=5)[0] for _ in range(2))
        self.assertEqual(one.found.params, two.found.params)
        self.assertEqual(one.runs, two.runs)

    def test_a_finer_step_has_the_last_word(self):
        with open("sum.frob", "w") as file:
            file.write("""main :: SF Float[1/s] Float
main = proc x -> y where
    y = integral x
    assert "small" (y <= 1.001)
""")
        # By time 1 s it sums everything before the last step, which is less with a finer step.
        look = dict(
            inputs={"in": (0, 1)}, duration=1.0, rate=10, points=1, method="random", runs=30
        )
        self.assertIsNone(frob.falsify("sum.frob", **look)[0].found)
        look["inputs"] = {"in": (0, 1.2)}
        self.assertIsNotNone(frob.falsify("sum.frob", **look, check_rate=1000)[0].found)

    def test_bad_input_is_told(self):
        def told(expected, **options):
            with self.assertRaises(frob.Error) as caught:
                self.look(**options)
            self.assertIn(expected, str(caught.exception))

        told("has no parameter `mot`; it has: most, brakes", params={"mot": (0, 1)})
        told(
            'param most: expected a range, such as "0.5[m/s] to …", found 0.3', params={"most": 0.3}
        )
        told(
            "param most: the range ends at 0.1, which is not more than 0.2",
            params={"most": "0.2[m/s] to 0.1[m/s]"},
        )
        told("its unit is [m/s], not [m]", params={"most": "0.2[m] to 1[m]"})
        told("expected two finite ends, found 0 to inf", params={"most": (0, float("inf"))})
        told("has no input `in.want`", inputs={"in.want": (0, 1)})
        told("the column `in.ahead` of cruise is missing", inputs={"in.wanted": (0, 1)})
        told("nothing is varied", inputs={"in.wanted": 1, "in.ahead": 2})
        told("there is no assertion `fast`; the assertions are: `stops`, `is slow`", only=["fast"])
        told("points: expected a number from 1 to 10000, found 0", points=0)
        told('method: expected "cma" or "random"', method="best")
        with open("nothing.frob", "w") as file:
            file.write("main :: SF Float Float\nmain = proc x -> x\n")
        with self.assertRaisesRegex(frob.InputError, "has no assertion"):
            frob.falsify("nothing.frob", inputs={"in": (0, 1)}, method="random")

    def test_without_the_libraries_the_cure_is_told(self):
        def told(missing, method):
            text = (
                f"import sys; sys.modules['{missing}'] = None; import frob.falsify_command as it\n"
                f"sys.exit(it.main(['cruise.frob', '--method', '{method}', '--input', 'in=0']))"
            )
            done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            return done.stderr

        self.assertEqual(
            told("numpy", "random"),
            "error: falsify needs numpy, which is not installed: run `frobc extras install search`\n",
        )
        self.assertEqual(
            told("cma", "cma"),
            "error: falsify needs cma, which is not installed: run `frobc extras install search`; or "
            "search at random (`--method random`), which takes more runs\n",
        )

    def test_a_sketch_is_a_signal_of_few_parts(self):
        space = search.Space(
            [search.Range("p", 0, 1, "float")], [search.Range("in", 0, 10, "float")], 4, "constant"
        )
        sketch = search.Sketch(space, [3], [])
        self.assertEqual(sketch.at([0.5, 0.25, 0.5, 0.1, 0.2, 0.3]), [0.5, 0.1, 0.2, 0.3, 0.3])
        # Times are sorted, in whatever order the numbers are; numbers beyond an end are clipped.
        self.assertEqual(sketch.at([0.5, 2, 0.5, 0.1, 0.2, -1]), [0.5, 0.1, 0.1, 0.2, 0.2])
        time = np.arange(9) / 8
        self.assertEqual(
            space.inputs_at([0, 0, 0.1, 0.2, 0.3], time, 1.0)["in"].tolist(),
            [0, 0, 1, 1, 2, 2, 3, 3, 3],
        )
        space = search.Space([], [search.Range("in", 0, 10, "float")], 3, "linear")
        self.assertEqual(
            space.inputs_at([0, 1, 0], time, 1.0)["in"].tolist(),
            [0, 2.5, 5, 7.5, 10, 7.5, 5, 2.5, 0],
        )
        r = random.Random(1)
        for most in (1, 2, 7):
            for _ in range(50):
                point = search.Space([], space.inputs, 9, "constant").sketch(most, r, False)
                signal = point.at(point.numbers)
                self.assertEqual(len(signal), 9)
                self.assertLess(sum(a != b for a, b in zip(signal, signal[1:])), most)


WORLD = """[start]
x = 0
y = 0

[[wall]]
points = [[-1, -2], [4, -2], [4, 2], [-1, 2]]
closed = true

[drive]
slip = 0.01
"""

STOPPING = """import Robot

-- | How far it stops from what is ahead.
param gap :: Distance = 0.5[m]

main :: (HasSonar i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
    v = if frontSonar i < gap then 0 else 0.4[m/s]
    assert "stops in time" (frontSonar i > 0.1[m]))
"""


class Simulated(unittest.TestCase):
    def look(self, **options):
        with open("stopping.frob", "w") as file:
            file.write(STOPPING)
        with open("hall.toml", "w") as file:
            file.write(WORLD)
        options = {
            "duration": 12,
            "method": "random",
            "robot": "pioneer",
            "world": "hall.toml",
            "runs": 60,
            **options,
        }
        return frob.falsify("stopping.frob", **options)

    def test_what_is_found_is_what_a_run_does(self):
        searches = self.look(
            params={"gap": "0.02[m] to 0.6[m]"},
            seeds="1 to 9",
            disturbances={"sonar.noise": (0, 0.02), "drive.slip": "0 to 0.1"},
        )
        self.assertEqual([one.label for one in searches], ["stops in time", "touches nothing"])
        for one in searches:
            found = one.found
            with open("hall-found.toml", "w") as file:
                file.write(found.drive.text)
            settings = [f"--param={name}={value}" for name, value in found.settings.items()]
            command = [
                frob.tools.frobc(),
                "run",
                "stopping.frob",
                "--robot",
                "pioneer",
                "--world",
                "hall-found.toml",
                "--seed",
                str(found.drive.seed),
                "--for",
                "12s",
                *settings,
            ]
            done = subprocess.run(command, capture_output=True, text=True)
            if one.label == "stops in time":
                self.assertIn(
                    f'"stops in time": violated, first at {found.time:.3f}',
                    done.stdout + done.stderr,
                )
                self.assertLess(found.margin, 0)
            else:
                self.assertNotIn("collisions: 0", done.stdout)
                self.assertIn("collisions: ", done.stdout)

    def test_what_cannot_fail_is_not_found(self):
        stops, touches = self.look(params={"gap": (0.5, 0.6)}, runs=5)
        self.assertEqual((stops.found, touches.found, touches.runs), (None, None, 5))
        self.assertGreater(stops.nearest, 0)
        # Measured from the centre of the robot.
        self.assertGreater(touches.nearest, 0.25)

    def test_the_world_is_as_the_file_says_but_for_what_is_varied(self):
        found = self.look(
            params={"gap": (0.02, 0.03)},
            only=["touches nothing"],
            runs=5,
            disturbances={"drive.slip": (0.2, 0.3), "sonar.noise": (0.1, 0.2), "start.x": (1, 2)},
        )[0].found
        values = found.drive.disturbances
        text = WORLD.replace("slip = 0.01", f"slip = {values['drive.slip']!r}")
        text = text.replace("x = 0\n", f"x = {values['start.x']!r}\n")
        self.assertEqual(found.drive.text, text + f"\n[sonar]\nnoise = {values['sonar.noise']!r}\n")

    def test_bad_input_is_told(self):
        def told(expected, **options):
            with self.assertRaises(frob.Error) as caught:
                self.look(**options)
            self.assertIn(expected, str(caught.exception))

        told("nothing is varied: give a range to a parameter, a disturbance or the seeds")
        told("its inputs come from the simulator", inputs={"in.x": (0, 1)})
        told(
            "expected a table and a key of the world file, such as sonar.noise",
            disturbances={"noise": (0, 1)},
        )
        told('expected a range, such as "0 to 0.1"', disturbances={"sonar.noise": 0.1})
        told("hall.toml:13:1: unknown key `noose`", disturbances={"sonar.noose": (0, 0.1)})
        told("the range ends at 0, which is not more than 1", disturbances={"sonar.noise": (1, 0)})
        told("seeds: expected whole numbers", seeds="1.5 to 2")
        told("there is no world none.toml", world="none.toml")
        with open("closed.frob", "w") as file:
            file.write(CRUISE)
        with self.assertRaisesRegex(frob.InputError, "is not a robot program, so it has no world"):
            frob.falsify("closed.frob", inputs=INPUTS, seeds=(1, 2), method="random")


class Command(unittest.TestCase):
    def setUp(self):
        # The Python that runs this test has the packages that the search needs. It may be installed
        # next to another frobc.
        folders = [os.path.dirname(path) for path in (frob.tools.frobc(), sys.executable)]
        path = os.pathsep.join([*folders, os.environ["PATH"]])
        search_path = unittest.mock.patch.dict(os.environ, {"PATH": path})
        search_path.start()
        self.addCleanup(search_path.stop)

    def test_it_tells_how_to_drive_again(self):
        with open("stopping.frob", "w") as file:
            file.write(STOPPING)
        with open("hall.toml", "w") as file:
            file.write(WORLD)
        command = [
            frob.tools.frobc(),
            "falsify",
            "stopping.frob",
            "--robot",
            "pioneer",
            "--world",
            "hall.toml",
            "--for",
            "12s",
            "--method",
            "random",
            "--seeds",
            "1 to 100",
            "--disturbance",
            "sonar.dropout=0 to 0.5",
            "--keep",
            "driven",
        ]
        found = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual((found.returncode, found.stderr), (1, ""))
        first, again, with_ = found.stdout.splitlines()[:3]
        self.assertTrue(first.startswith("violated  stops in time: at "), first)
        self.assertTrue(with_.startswith("          with sonar.dropout = "), with_)
        words = again.split()
        self.assertEqual(words[:2], ["frobc", "run"])
        driven = subprocess.run([frob.tools.frobc(), *words[1:]], capture_output=True, text=True)
        at = first[len("violated  stops in time: at ") :].split()[0]
        self.assertIn(
            f'"stops in time": violated, first at {float(at):.3f}', driven.stdout + driven.stderr
        )

    def test_it_tells_what_was_touched(self):
        """The printed command reproduces the collision in a run, even for names that a shell would
        split."""
        folder = "a 'strange' $(name)"
        os.makedirs(folder, exist_ok=True)
        file = os.path.join(folder, "it's ahead.frob")
        with open(file, "w") as text:
            text.write(
                "import Robot\nparam fast :: Velocity = 0.3[m/s]\n"
                "main :: DiffDrive o => Program i o\n"
                "main = reactimateRobot (proc _ -> roMake (setVelTR fast 0))\n"
            )
        command = [
            frob.tools.frobc(),
            "falsify",
            file,
            "--robot",
            "create",
            "--for",
            "30s",
            "--only",
            "touches nothing",
            "--method",
            "random",
            "--param",
            "fast=0.2[m/s] to 0.3[m/s]",
            "--world",
        ]
        with open(os.path.join(folder, "the hall.toml"), "w") as text:
            text.write("[start]\nx = 0\ny = 0\n[[wall]]\npoints = [[1, -1], [1, 1]]\n")
        found = subprocess.run(
            [*command, os.path.join(folder, "the hall.toml")], capture_output=True, text=True
        )
        self.assertEqual((found.returncode, found.stderr), (1, ""))
        violated, collision, again = found.stdout.splitlines()
        self.assertRegex(violated, r"^violated  touches nothing: at [0-9.]+ s, found in 1 run$")
        self.assertRegex(
            collision,
            r"^ +collision at [0-9.]+ s: the wall \(the hall.toml, line 4\), "
            r"x [0-9.]+ m, y -?[0-9.]+ m, clearance 0\.[0-9]+ m$",
        )
        shell = again.strip().replace("frobc", shlex.quote(frob.tools.frobc()), 1)
        driven = subprocess.run(["sh", "-c", shell], capture_output=True, text=True)
        self.assertIn(collision.strip(), driven.stdout)

    def test_an_outage_of_the_world(self):
        """An assertion is judged only at the instants of the program."""
        with open("lost.frob", "w") as text:
            text.write(
                "import Control\nimport Robot\nmain :: DiffDrive o => Program i o\n"
                "main = reactimateRobot (proc _ -> roMake (setVelTR 0.1[m/s] 0) where\n"
                '    assert "is not lost" (stepTime () < 1.5[s]))\n'
            )
        with open("lost.toml", "w") as text:
            text.write("[start]\nx = 0\ny = 0\n[outage]\nfrom = 1\nlasts = 1\n")
        searches = frob.falsify(
            "lost.frob",
            world="lost.toml",
            robot="pioneer",
            duration=5,
            disturbances={"outage.lasts": (1, 3)},
            method="random",
            only=["is not lost"],
            runs=100,
        )
        found = searches[0].found
        lasts = found.drive.disturbances["outage.lasts"]
        self.assertGreater(lasts, 1.4)
        self.assertAlmostEqual(found.time, 1 + lasts, delta=0.021)

    def test_it_tells_what_it_finds_and_how_to_see_it(self):
        with open("cruise.frob", "w") as file:
            file.write(CRUISE)
        command = [
            frob.tools.frobc(),
            "falsify",
            "cruise.frob",
            "--method",
            "random",
            "--for",
            "5s",
            "--input",
            "in.wanted=-1 to 1",
            "--input",
            "in.ahead=0.5",
        ]
        held = subprocess.run([*command, "--runs", "20"], capture_output=True, text=True)
        self.assertEqual((held.returncode, held.stderr), (0, ""))
        self.assertEqual(
            held.stdout.splitlines()[1],
            "held      is slow: not violated in 20 runs; the smallest margin is 0.3",
        )
        found = subprocess.run(
            [*command, "--param", "most=0.2[m/s] to 1[m/s]", "--only", "is slow"],
            capture_output=True,
            text=True,
        )
        self.assertEqual(found.returncode, 1)
        self.assertIn("violated  is slow: at ", found.stdout)
        self.assertIn(
            "frobc trace cruise.frob --input falsified/is-slow.csv --param 'most=", found.stdout
        )
        self.assertTrue(os.path.exists("falsified/is-slow.csv"))
        wrong = subprocess.run([*command, "--param", "most=1"], capture_output=True, text=True)
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("error: param most: expected a range", wrong.stderr)


if __name__ == "__main__":
    checks.main("falsify")
