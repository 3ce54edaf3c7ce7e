"""Tests recordings from other programs: options of `frob.read`, and times to the nanosecond."""

import decimal
import subprocess
import unittest

import numpy as np
import pandas as pd

import checks
import frob
from frob import tools

PROGRAM = """
data In = In { speed :: Velocity, ok :: Bool }

main :: SF In (Distance, Time)
main = proc i -> (integral (if i.ok then i.speed else 0), time ())
"""

LOG = """Time;wheel_speed;flag;note
1700000000,10;0,5;true;start of it
1700000000,123456789;Inf;true;
1700000000,123456790;NaN;false;
1700000001,5;-Infinity;true;
"""

OPTIONS = {
    "separator": ";",
    "decimal_comma": True,
    "time_column": "Time",
    "columns": {"in.speed": "wheel_speed", "in.ok": "flag"},
}


def put(name, text):
    with open(name, "w") as file:
        file.write(text)


class Others(unittest.TestCase):
    def setUp(self):
        put("speed.frob", PROGRAM)
        put("log.csv", LOG)
        self.program = frob.compile("speed.frob")

    def test_as_trace(self):
        log = frob.read("log.csv", **OPTIONS)
        self.assertEqual(list(log), ["time", "in.speed", "in.ok", "note"])
        self.assertEqual(log.attrs["origin_ns"], 1700000000100000000)
        found = self.program.run(log)
        options = ["--separator", ";", "--decimal-comma", "--time-column", "Time"]
        options += ["--column", "in.speed=wheel_speed", "--column", "in.ok=flag"]
        command = [tools.frobc(), "trace", "speed.frob", "--input", "log.csv", *options]
        with open("trace.csv", "w") as out:
            subprocess.run(command, check=True, stdout=out)
        traced = frob.read("trace.csv")
        for name in ("time", "out.1", "out.2"):
            np.testing.assert_array_equal(found[name], traced[name])

    def test_told(self):
        for options, text in (
            ({}, 'its columns are separated by semicolons: pass `separator=";"`'),
            ({"separator": ";"}, 'time_column="Time"'),
            ({"separator": ";", "time_column": "Time"}, "decimal_comma=True"),
            ({"separator": ";", "time_column": "Zeit"}, "there is no column `Zeit`"),
            ({**OPTIONS, "columns": {"in.speed": "x"}}, "there is no column `x`"),
            (
                {"time_column": "Time"},
                'its columns are separated by semicolons: pass `separator=";"`',
            ),
            ({"separator": ";;"}, "separator: expected"),
            ({"decimal_comma": 1}, "decimal_comma: expected"),
            ({"time_column": 1}, "time_column: expected"),
            ({"columns": ["a"]}, "columns: expected"),
        ):
            with self.subTest(options=options), self.assertRaisesRegex(frob.Error, text):
                frob.read("log.csv", **options)

    def test_names_of_no_numbers(self):
        put("e.csv", "time,in\n0,\n1,NaN\n2,-Infinity\n3,INF\n")
        self.assertEqual(
            str(list(frob.read("e.csv")["in"])), "[None, Data('Event', nan), -inf, inf]"
        )
        put("m.csv", 'time,in\n0,Just NaN\n1,"[Inf, -INF]"\n2,Info\n')
        values = list(frob.read("m.csv")["in"])
        self.assertEqual(str(values), "[Data('Just', nan), [inf, -inf], Data('Info')]")

    def test_too_large(self):
        found = "expected a number up to 1.79e308, or `inf`, found"
        for cell in ("1e400", "-1e400", "1" * 400, "Just 1e400"):
            put("large.csv", f"time,in\n0,1e-400\n1,{cell}\n")
            with (
                self.subTest(cell=cell),
                self.assertRaisesRegex(frob.Error, f"large.csv:3: .*{found}"),
            ):
                frob.read("large.csv")
        put("large.csv", "# param a=1e400[m]\ntime,in\n0,1\n")
        with self.assertRaisesRegex(frob.Error, f"large.csv:1: parameter `a`: {found}"):
            frob.read("large.csv")

    def test_decimal_comma_without_separator(self):
        put("comma.csv", "time,in\n0,5,1,5\n")
        with self.assertRaisesRegex(frob.Error, 'comma.csv:2: .* pass `separator=";"`'):
            frob.read("comma.csv", decimal_comma=True)

    def test_smaller_units_of_time(self):
        inputs = {"in.speed": [1.0], "in.ok": [True]}
        for time, unit in ((1.7e12, "milli"), (1.7e15, "micro"), (1.7e18, "nano")):
            for given in ([time], [str(int(time))], np.array([time])):
                with (
                    self.subTest(given=given),
                    self.assertRaisesRegex(
                        frob.InputError, f"this looks like {unit}seconds, so divide the times by 1e"
                    ),
                ):
                    self.program.run(inputs, time=given)

    def test_times(self):
        exact = np.array([0, 1e-9, 4e-9])
        texts = ["1700000000.100000001", "1700000000.100000002", "1.700000000100000005e9"]
        whole = ["2024-01-01T00:00:00.000000001", "2024-01-01T00:00:00.000000002"]
        dates = np.array([*whole, "2024-01-01T00:00:00.000000005"], "datetime64[ns]")
        inputs = {"in.speed": [1.0] * 3, "in.ok": [True] * 3}
        for time in (texts, [decimal.Decimal(text) for text in texts], dates, pd.Series(dates)):
            np.testing.assert_array_equal(self.program.run(inputs, time=time)["out.2"], exact)
        steps = [{"speed": 1, "ok": True}] * 3
        self.assertEqual([t for _, t in self.program.run(steps, time=texts)], list(exact))
        floats = self.program.run(inputs, time=[1.7e9, 1.7e9 + 0.25, 1.7e9 + 0.75])["out.2"]
        self.assertEqual(list(floats), [0, 0.25, 0.75])
        for late in (
            4000000001,
            1e10,
            "4000000000.000000001",
            np.datetime64("3000"),
            np.datetime64("NaT"),
        ):
            with self.subTest(late=late), self.assertRaisesRegex(frob.InputError, "time"):
                self.program.run(inputs, time=np.array([late] * 3))


if __name__ == "__main__":
    checks.main("recordings of others in Python")
