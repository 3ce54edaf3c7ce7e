"""Checks that the package raises only `frob.Error`, whatever the arguments are, and never fails
silently.
"""

import decimal
import fractions
import unittest

import numpy as np
import pandas as pd

import checks
import frob

GAIN = """
param gain :: Float[1/s] = 2[1/s]
param turbo :: Bool = False
param n :: Int = 3

main :: SF Float[m] Float[m/s]
main = proc x -> (if turbo then 10 else 1) * gain * x + integral x / 1[s^2] + toFloat n * 1[m/s]
"""

PAIR = """
data Way = Idle | Ahead | Turn Float
data Pose = Pose { x :: Distance, way :: Way }

main :: SF (Pose, Array 2 Int, Event Float) (Maybe Float, Bool)
main = proc (p, a, e) -> (case e of
    NoEvent -> Nothing
    Event x -> Just (x + p.x / 1[m]), a ! 0 > 1)
"""


class Refuses:
    def __float__(self):
        raise ValueError("no")

    def __index__(self):
        raise ValueError("no")

    def __len__(self):
        return 3


class Odd:
    def __float__(self):
        return "x"


def hostile():
    itself = []
    itself.append(itself)
    numbers = [None, float("nan"), float("inf"), 10**400, -(10**400), -1, True, 1j, 1e300]
    numbers += [decimal.Decimal(x) for x in ("0.5", "nan", "sNaN", "1e500")]
    numbers += [fractions.Fraction(1, 3), fractions.Fraction(10**400, 3), Refuses(), Odd()]
    texts = ["", "x", "(" * 2000, "(" * 2000 + "1" + ")" * 2000, "[" * 5000, "Pose {x = " * 1500]
    texts += ["Just (" * 3000 + "1" + ")" * 3000, "1" * 5000, "1e999999", "1_0", "\ud800", "a\0b"]
    lists = [b"x", object(), {}, {"x": 1}, {1}, [], [1], [1, 2, 3], [[1], [2, 3]], itself, ()]
    lists += [range(3), (i for i in range(3)), memoryview(b"abc"), ["1", "2", "3"], [10**400] * 3]
    lists += [["(" * 2000] * 3, {"in": [1, 2, 3], "time": [0, 10**400, 2]}, {None: [1]}]
    arrays = [np.array(1.0), np.ones(3), np.ones((3, 2)), np.ones((3, 1, 1)), np.ones(3, complex)]
    arrays += [np.array(["2020-01-01", "NaT", "2021-01-01"], "datetime64[s]"), np.ones(6)[::-2]]
    arrays += [np.array([1, None, "x"], object), np.array([10**400, 1, 2], object)]
    arrays += [np.array(["a", "b", "c"]), np.zeros(3, [("a", "f8")]), np.empty((0, 1))]
    arrays += [np.ma.masked_array([1.0, 2, 3], [0, 1, 0]), np.array([2**64 - 1] * 3, np.uint64)]
    arrays += [np.ones(3, ">f8"), np.str_("1"), np.bool_(True)]
    frames = [
        pd.NA,
        pd.NaT,
        pd.Series([1, 2, 3], index=[9, 9, 9]),
        pd.Series(["a"] * 3, dtype="category"),
    ]
    frames += [
        pd.Series([1, None, 3], dtype="Int64"),
        pd.DataFrame(np.ones((3, 2)), columns=["in", "in"]),
    ]
    frames += [pd.DataFrame({0: [1, 2, 3]}), pd.Timestamp("2020-01-01"), pd.Timedelta("1s")]
    data = [
        frob.Data("Turn", 0.5),
        frob.Data("Nope"),
        frob.Data("Event", frob.Data("Event", 1)),
        int,
    ]
    return [*numbers, *texts, *lists, *arrays, *frames, *data]


class Hostile(unittest.TestCase):
    def setUp(self):
        for name, text in (("gain.frob", GAIN), ("pair.frob", PAIR)):
            with open(name, "w") as file:
                file.write(text)
        self.gain, self.pair = frob.compile("gain.frob"), frob.compile("pair.frob")

    def calls(self, v):
        g, p, pose = self.gain, self.pair, {"x": 1, "way": "Idle"}
        cells = {
            "in.1.x": [1.0],
            "in.1.way": ["Idle"],
            "in.2[0]": [1],
            "in.2[1]": [1],
            "in.3": [None],
        }
        yield "dt of a step", lambda: g.step(v, 1.0)
        yield "number", lambda: g.step(0.1, v)
        yield "tuple", lambda: p.step(0.1, v)
        yield "record", lambda: p.step(0.1, (v, [1, 2], None))
        yield "field", lambda: p.step(0.1, ({"x": v, "way": "Idle"}, [1, 2], None))
        yield "data", lambda: p.step(0.1, ({"x": 1, "way": v}, [1, 2], None))
        yield "carried", lambda: p.step(0.1, ({"x": 1, "way": frob.Data("Turn", v)}, [1, 2], None))
        yield "array", lambda: p.step(0.1, (pose, v, None))
        yield "element", lambda: p.step(0.1, (pose, [v, 1], None))
        yield "event", lambda: p.step(0.1, (pose, [1, 1], v))
        for dt in ({"dt": 0.1}, {"time": [0, 1, 2]}):
            yield "inputs", lambda: g.run(v, **dt)
        for rows in (np.ones(3), [1.0, 2.0, 3.0]):
            yield "dt", lambda: g.run(rows, dt=v)
            yield "time", lambda: g.run(rows, time=v)
            yield "one dt", lambda: g.run(rows, dt=[0, v, 1])
            yield "one time", lambda: g.run(rows, time=[0, v, 10**8])
        yield "element of a list", lambda: g.run([1.0, v], dt=1)
        yield "column", lambda: g.run({"in": v}, dt=1)
        yield "cell", lambda: g.run({"in": [1, v, 2]}, dt=1)
        yield "column of time", lambda: g.run({"in": [1, 2, 3], "time": v})
        yield "out", lambda: g.run(np.ones(3), dt=1, out=v)
        yield "rows", lambda: p.run(v, dt=1)
        for name in cells:
            yield name, lambda: p.run({**cells, name: [v]}, dt=1)
        yield "params", lambda: g.copy().reset(v)
        for name in ("gain", "turbo", "n"):
            yield f"param {name}", lambda: g.copy().reset({name: v})
        yield "text", lambda: str(frob.Data("A", v))

    def paths(self, v):
        yield "file", lambda: frob.compile(v)
        yield "read", lambda: frob.read(v)
        yield "entry", lambda: frob.compile("gain.frob", entry=v)
        yield "robot", lambda: v is None or frob.compile("gain.frob", robot=v)
        yield "sources", lambda: frob.compile("gain.frob", sources=v)
        yield "source", lambda: frob.compile("gain.frob", sources=[v])
        for name in ("world", "seed", "duration", "rate", "robot", "entry", "probe", "sources"):
            yield f"simulate {name}", lambda: frob.simulate("nothing.frob", **{name: v})
        for name in ("jobs", "robot", "rows", "sources"):
            yield f"sweep {name}", lambda: frob.sweep("nothing.toml", **{name: v})

    def check(self, calls):
        for what, call in calls:
            with self.subTest(what):
                try:
                    call()
                except frob.Error:
                    pass

    def test_values(self):
        for value in hostile():
            with self.subTest(value=f"{type(value).__name__} {value!r:.40}"):
                self.check(self.calls(value))

    def test_paths(self):
        for value in (None, 10**400, 1.5, "\ud800", "a\0b", b"\xff", [1], {}, object(), np.ones(2)):
            with self.subTest(value=f"{value!r:.40}"):
                self.check(self.paths(value) if not isinstance(value, (list, dict)) else ())

    def test_memory_of_its_own(self):
        inputs = np.ones((100, 1))
        dt = np.full(100, 0.01)
        right = self.gain.run(inputs, dt=dt.copy()).copy()
        with self.assertRaisesRegex(frob.InputError, "shares no memory with the inputs"):
            self.gain.run(inputs, dt=dt, out=inputs.reshape(-1))
        both = np.zeros(150)
        both[:100] = 0.01
        np.testing.assert_array_equal(self.gain.run(inputs, dt=both[:100], out=both[50:]), right)
        np.testing.assert_array_equal(self.gain.run(inputs, dt=dt, out=dt), right)
        time = np.arange(100) * 0.01
        np.testing.assert_array_equal(self.gain.run(inputs, time=time, out=time), right)


if __name__ == "__main__":
    checks.main("the Python package: hostile arguments")
