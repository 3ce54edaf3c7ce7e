"""Tests the inputs and outputs of programs in Python, and the messages for invalid inputs."""

import copy
import os
import pickle
import subprocess
import sys
import threading
import unittest
from pathlib import Path

import numpy as np
import pandas as pd

import checks
import frob
from frob import tools


def program(text, name="it.frob", **options):
    with open(name, "w") as file:
        file.write(text)
    return frob.compile(name, **options)


PAIR = """
data Way = Idle | Ahead | Turn Float
data Pose = Pose { x :: Distance, way :: Way }

main :: SF (Pose, Array 2 Int, Event Float) (Maybe Float, Array 2 Int, Pose, Event ())
main = proc (p, a, e) -> (kept e, map (* 2) a, p, e `tag` ())

kept :: Event a -> Maybe a
kept e = case e of
    NoEvent -> Nothing
    Event x -> Just x
"""

GAIN = """
param gain :: Float[1/s] = 2[1/s]
param turbo :: Bool = False

main :: SF Float[m] Float[m/s]
main = proc x -> (if turbo then 10 else 1) * gain * x + integral x / 1[s^2]
"""

HALF = "main :: SF Float Float\nmain = proc x -> x / 2\n"
ODD = "main :: SF (Int, Bool) (Int, Bool)\nmain = proc (n, b) -> (n + 1, not b)\n"


class Values(unittest.TestCase):
    def test_each_kind(self):
        p = program(PAIR)
        self.assertEqual(p.inputs, ["in.1.x", "in.1.way", "in.2[0]", "in.2[1]", "in.3"])
        pose = {"x": 1, "way": frob.Data("Turn", 0.5)}
        maybe, doubled, given, unit = p.step(0.1, (pose, [1, -2], 2.5))
        self.assertEqual((maybe, doubled, unit), (2.5, [2, -4], ()))
        self.assertEqual(given, frob.Data("Pose", x=1.0, way=frob.Data("Turn", 0.5)))
        self.assertEqual((given.x, given["way"][0]), (1.0, 0.5))
        self.assertEqual(str(given), "Pose {x = 1, way = Turn 0.5}")
        self.assertEqual(pickle.loads(pickle.dumps(given)), given)
        again = p.step(0.1, (given, (1, 2), None))
        self.assertEqual((again[0], again[3]), (None, None))
        idle = p.step(
            0.1, ({"x": 1, "way": "Idle"}, np.array([3, 4]), frob.Data("Event", float("nan")))
        )
        self.assertEqual(idle[2].way, frob.Data("Idle"))
        self.assertEqual(repr(idle[0]), "Data('Just', nan)")

    def test_a_record_in_a_constructor_as_a_cell_has_it(self):
        p = program("""
data Wheel = Wheel { speed :: Float }
main :: SF (Either Bool Wheel) Float
main = proc e -> either (const 0) (\\w -> w.speed) e
""")
        self.assertEqual(p.step(0.1, "Right Wheel {speed = 0.25}"), 0.25)

    def test_shapes_of_run(self):
        half = program(HALF)
        self.assertEqual(half.run(np.array([2.0, 4.0]), dt=0.1).tolist(), [1, 2])
        self.assertEqual(half.run(np.array([[2], [4]]), dt=0.1).tolist(), [1, 2])
        self.assertEqual(half.run([2, 4], dt=0.1), [1, 2])
        self.assertEqual(half.run([], dt=0.1), [])
        self.assertEqual(half.run(np.zeros(0), dt=0.1).tolist(), [])
        self.assertEqual(half.run(np.arange(8.0)[::2], dt=np.full(4, 0.1)).tolist(), [0, 1, 2, 3])
        frame = half.run(pd.DataFrame({"time": [0, 0.1], "in": [2, 4]}, index=["a", "b"]))
        self.assertEqual(frame.loc["b"].to_dict(), {"time": 0.1, "out": 2})
        odd = program(ODD)
        self.assertEqual(odd.run(np.array([[1, 0], [2, 1]]), dt=1).tolist(), [[2, 1], [3, 0]])
        self.assertEqual(
            odd.run({"in.1": [1.0], "in.2": ["true"]}, dt=1)["out.2"].tolist(), [False]
        )

    def test_run_leaves_the_state_alone(self):
        p = program("main :: SF Float Float\nmain = proc x -> integral x / 1[s]\n")
        p.step(0, 1)
        self.assertEqual(p.run([1, 1, 1], dt=1), [0, 1, 2])
        other = copy.deepcopy(p)
        self.assertEqual([p.step(1, 1), p.step(1, 1), other.step(1, 1)], [1, 2, 1])
        p.reset()
        self.assertEqual(p.step(1, 1), 0)

    def test_code_in_c(self):
        with open("twice.c", "w") as file:
            file.write("double twice(double x) { return 2 * x; }\n")
        text = 'foreign twice :: Float -> Float = "twice"\n\nmain :: SF Float Float\nmain = proc x -> twice x\n'
        self.assertEqual(program(text, sources=["twice.c"]).step(0.1, 1.5), 3)
        with self.assertRaisesRegex(frob.Error, "there is no C file nowhere.c"):
            program(text, sources=["nowhere.c"])

    def test_a_header_is_allowed_by_name(self):
        text = 'foreign include "own.h"\nforeign own :: Float -> Float = "own"\n'
        text += "main :: SF Float Float\nmain = arr own\n"
        Path("own.h").write_text("static inline double own(double x) { return x + 1; }\n")
        with self.assertRaisesRegex(frob.Error, "the C header `own.h`.*`--with own.h`"):
            program(text)
        self.assertEqual(program(text, sources=["own.h"]).step(0.1, 1.5), 2.5)

    def test_outputs_into_an_array(self):
        half = program(HALF)
        inputs, out = np.array([2.0, 4.0]), np.zeros(2)
        self.assertIs(half.run(inputs, dt=1, out=out), out)
        self.assertEqual(out.tolist(), [1, 2])
        fixed = np.zeros(2)
        fixed.flags.writeable = False
        for wrong in (
            np.zeros(3),
            np.zeros((2, 1)),
            np.zeros(2, np.float32),
            np.zeros(4)[::2],
            np.zeros(2, ">f8"),
            fixed,
            inputs,
            [0, 0],
        ):
            with self.assertRaisesRegex(frob.InputError, "out: expected a writable float64 array"):
                half.run(inputs, dt=1, out=wrong)
        with self.assertRaisesRegex(frob.InputError, "out: expected a writable float64 array"):
            program(ODD).run(np.zeros((2, 2)), dt=1, out=np.zeros((2, 2)))
        with self.assertRaisesRegex(
            frob.InputError, "out: this is only supported if the inputs are an array"
        ):
            half.run([1], dt=1, out=out)

    def test_long_runs(self):
        """Splitting a run into many calls of C, with one dt or many, does not change the
        outputs.
        """
        p = program("main :: SF Float Float\nmain = proc x -> integral x / 1[s]\n")
        inputs = np.random.default_rng(1).random(20_000)
        told = p.run(inputs, dt=0.5)
        self.assertTrue((told == p.run(inputs, dt=np.full(20_000, 0.5))).all())
        self.assertTrue((told[:9000] == p.run(inputs[:9000].tolist(), dt=0.5)).all())

    def test_parameters(self):
        p = program(GAIN, params={"gain": 3})
        self.assertEqual(
            (p.params, p.units), ({"gain": 3, "turbo": False}, {"gain": "1/s", "turbo": ""})
        )
        self.assertEqual(p.step(0.1, 1), 3)
        p.reset(params={"turbo": True, "gain": "4[1/s]"})
        self.assertEqual((p.step(0.1, 1), p.run([1.0], dt=1)), (40, [40]))


class Mistakes(unittest.TestCase):
    def told(self, text, action, kind=frob.InputError):
        with self.assertRaises(kind) as caught:
            action()
        self.assertEqual(str(caught.exception), text)

    def test_compiling(self):
        self.told(
            "there is no program nowhere.frob", lambda: frob.compile("nowhere.frob"), frob.Error
        )
        text = "main :: SF Float Float\nmain = proc x -> y\n"
        with self.assertRaises(frob.CompileError) as caught:
            program(text)
        checked = subprocess.run(
            [tools.frobc(), "check", "it.frob"], capture_output=True, text=True
        )
        self.assertEqual(str(caught.exception), checked.stderr.rstrip("\n"))
        with self.assertWarnsRegex(frob.FrobWarning, "nothing uses it"):
            program("main :: SF Float Float\nmain = proc x -> x where\n    spare = 2 * x\n")
        before = dict(os.environ)
        os.environ["CC"] = "no-such-compiler"
        try:
            with self.assertRaisesRegex(frob.Error, "there is no C compiler `no-such-compiler`"):
                program(HALF + "-- another\n")
            os.environ["FROBC"] = "/nowhere/frobc"
            self.told(
                "FROBC names /nowhere/frobc, which cannot be run: install frobc, or set FROBC to "
                "its path",
                lambda: program(HALF),
                frob.Error,
            )
        finally:
            os.environ.clear()
            os.environ.update(before)

    def test_single_values(self):
        p, pose = program(PAIR), {"x": 1, "way": "Idle"}
        step = lambda value: lambda: p.step(0.1, value)
        self.told("in: expected a tuple of 3, found 1: [1]", step([1]))
        self.told(
            "in.1.x: expected a number, found True",
            step(({"x": True, "way": "Idle"}, [1, 2], None)),
        )
        self.told("in.1: the field `way` is missing", step(({"x": 1}, [1, 2], None)))
        self.told(
            "in.1: there is no field `z`; the fields are x, way",
            step(({**pose, "z": 1}, [1, 2], None)),
        )
        self.told(
            "in.1.way: expected `Idle` or `Ahead` or `Turn`, found Data('Back')",
            step(({"x": 1, "way": "Back"}, [1, 2], None)),
        )
        self.told(
            "in.1.way: expected `Turn` with 1 argument, found Data('Turn')",
            step(({"x": 1, "way": "Turn"}, [1, 2], None)),
        )
        self.told("in.2: expected a list of 2, found 3: [1, 2, 3]", step((pose, [1, 2, 3], None)))
        self.told(
            "in.2[1]: expected a whole number from -2147483648 to 2147483647, found 2147483648",
            step((pose, [1, 2**31], None)),
        )
        self.told("in.3: expected a number, found [1]", step((pose, [1, 2], [1])))
        self.told(
            "dt: nan is not a duration: give a non-negative number of seconds",
            lambda: p.step(float("nan"), (pose, [1, 2], None)),
        )
        self.told("dt: expected seconds, found '1'", lambda: p.step("1", (pose, [1, 2], None)))

    def test_columns(self):
        odd, half = program(ODD), program(HALF, "half.frob")
        self.told(
            "the column `in.2` of it is missing; the columns are in.1, in.2, found in.1",
            lambda: odd.run({"in.1": [1]}, dt=1),
        )
        self.told(
            "in.1, row 1: expected a whole number from -2147483648 to 2147483647, found 1.5",
            lambda: odd.run({"in.1": [1, 1.5], "in.2": [True, True]}, dt=1),
        )
        self.told(
            "in.1, row 1: expected a whole number from -2147483648 to 2147483647, found nan",
            lambda: odd.run(pd.DataFrame({"in.1": [1, None], "in.2": [True, True]}), dt=1),
        )
        self.told(
            "in.2, row 0: expected True or False, found 1",
            lambda: odd.run({"in.1": [1], "in.2": [1]}, dt=1),
        )
        self.told(
            "row 1: expected 0 or 1 for a truth value, found 2",
            lambda: odd.run(np.array([[1, 1], [1, 2]]), dt=1),
        )
        self.told(
            "in, row 1: expected a number, found None", lambda: half.run({"in": [1, None]}, dt=1)
        )
        self.told(
            "`in.2` has 1 rows, but `in.1` has 2",
            lambda: odd.run({"in.1": [1, 2], "in.2": [True]}, dt=1),
        )
        self.told(
            "in.1: expected a column, found 5", lambda: odd.run({"in.1": 5, "in.2": [True]}, dt=1)
        )
        self.assertEqual(odd.run({"in.1": [], "in.2": []}, dt=1)["out.2"].tolist(), [])
        self.told(
            "time, row 1: 'a' is not a time in seconds", lambda: half.run([1, 2], time=[0, "a"])
        )
        self.told(
            "time, row 1: the time goes backwards: 0 comes after a later time",
            lambda: half.run([1, 2], time=[1, 0]),
        )
        self.told(
            "give the time between instants, `dt`, in seconds, or the `time` of each instant",
            lambda: half.run(np.zeros(3)),
        )
        self.told(
            "time, row 2: the time goes backwards: 0.5 comes after a later time",
            lambda: half.run(np.zeros(3), time=[0, 1, 0.5]),
        )
        self.told(
            "time, row 1: nan is not a time in seconds",
            lambda: half.run(np.zeros(2), time=[0, float("nan")]),
        )
        self.told("dt has 2 rows, but the input has 3", lambda: half.run(np.zeros(3), dt=[1, 1]))
        self.told(
            "dt, row 1: -1.0 is not a duration: give a non-negative number of seconds",
            lambda: half.run(np.zeros(2), dt=[1, -1]),
        )
        self.told(
            "expected an array of 1 columns (in), found the shape (2, 3)",
            lambda: half.run(np.zeros((2, 3)), dt=1),
        )
        self.told(
            "expected an array of 1 columns (in), found the shape (2, 0)",
            lambda: half.run(np.zeros((2, 0)), dt=1),
        )
        self.told(
            "`in.1.way` of it is not a number (`Idle` or `Ahead` or `Turn`), but an array can "
            "only contain numbers: give a mapping of columns, or a DataFrame",
            lambda: program(PAIR).run(np.zeros((2, 5)), dt=1),
        )
        self.told(
            "the array: values are masked: fill them, or remove their rows",
            lambda: half.run(np.ma.masked_equal([1.0, 2.0], 2), dt=1),
        )
        self.told(
            "expected an array, a mapping of columns, a DataFrame or a list, found 3",
            lambda: half.run(3, dt=1),
        )

    def test_nan_is_a_number(self):
        half = program(HALF)
        for inputs in (np.array([float("nan")]), {"in": [float("nan")]}, [float("nan")]):
            result = half.run(inputs, dt=1)
            self.assertEqual(
                repr(float(list(result.values())[0][0] if isinstance(result, dict) else result[0])),
                "nan",
            )

    def test_parameters(self):
        self.told(
            "it has no parameter `gian`; it has: gain, turbo",
            lambda: program(GAIN, params={"gian": 1}),
        )
        self.told(
            "params: expected a mapping of names, found [1]", lambda: program(GAIN, params=[1])
        )
        self.told(
            "param gain: its unit is [1/s], not [1/m]",
            lambda: program(GAIN, params={"gain": "1[1/m]"}),
        )
        self.told(
            "param turbo: expected True or False, found 1",
            lambda: program(GAIN, params={"turbo": 1}),
        )


class Interpreter(unittest.TestCase):
    def test_threads(self):
        """Two threads that step the same program take turns; runs have separate states."""
        p = program("main :: SF Int Int\nmain = proc n -> sum where\n    sum = delay 0 sum + n\n")
        results = []

        def steps():
            for _ in range(2000):
                p.step(0.1, 1)

        def runs():
            results.append(p.run(np.ones(200_000), dt=0.1)[-1])

        threads = [threading.Thread(target=work) for work in (steps, steps, runs, runs)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((p.step(0.1, 0), results), (4000, [200_000, 200_000]))

    def test_outlives_all_else(self):
        step = program(HALF).step
        self.assertEqual([step(0.1, n) for n in (1, 2)], [0.5, 1])
        first, second = program(HALF), program(HALF.replace("2", "4"))
        self.assertEqual((first.step(0.1, 1), second.step(0.1, 1)), (0.5, 0.25))
        with self.assertRaisesRegex(TypeError, "cannot be sent to another process"):
            pickle.dumps(first)

    def test_imports_little(self):
        code = "import sys, frob; print([m for m in ('numpy', 'pandas') if m in sys.modules])"
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual(done.stdout, "[]\n")


if __name__ == "__main__":
    checks.main("the Python package")
