"""Tests runs in the simulator, and recordings, from Python."""

import csv
import gzip
import os
import subprocess
import unittest
import unittest.mock
import xml.etree.ElementTree


import checks
import frob
from frob import tools

FOLLOW = """import Robot
import WallFollow

param distance :: Distance = 0.3[m]
param hurry :: Bool = False

main :: Program RobotInput RobotOutput
main = reactimateRobot (proc i -> wallFollow1 distance i where
    assert "moves" (velocity i > -1[m/s])
    assert "flies" (hurry || velocity i > 1[m/s]))
"""

TWO = """
[[start]]
x = 1.0
y = 1.0

[[start]]
x = 2.0
y = 3.0

[[wall]]
points = [[0, 0], [6, 0], [6, 4], [0, 4]]
closed = true
"""


class Simulate(unittest.TestCase):
    def setUp(self):
        with open("follow.frob", "w") as file:
            file.write(FOLLOW)

    def test_as_frobc_run(self):
        run = ["run", "follow.frob", "--for", "3s", "--seed", "7", "--param", "distance=0.4[m]"]
        tools.run([*run, "--param", "hurry=True", "--record", "told.csv"])
        table = frob.simulate(
            "follow.frob", duration=3, seed=7, params={"distance": 0.4, "hurry": True}, picture=True
        )
        self.assertTrue(table.equals(frob.read("told.csv")))
        with open("told.csv") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
        self.assertEqual(list(table.columns), rows[0])
        column = rows[0].index("out.forward")
        self.assertEqual(table["out.forward"].tolist(), [float(row[column]) for row in rows[1:]])
        self.assertEqual(table.attrs["params"], {"distance": 0.4, "hurry": True})
        self.assertEqual(table.attrs["units"], {"distance": "m", "hurry": ""})
        self.assertEqual(table.attrs["summary"]["time simulated"], "3.000 s")
        xml.etree.ElementTree.fromstring(table.attrs["picture"]._repr_svg_())
        texts = frob.simulate(
            "follow.frob", duration=3, seed=7, params={"distance": "40[cm]", "hurry": "True"}
        )
        self.assertTrue(table.equals(texts))
        probed = frob.simulate("follow.frob", duration=1, probe=["wallFollow1"])
        self.assertTrue(any(name.startswith("probe.wallFollow1") for name in probed))

    def test_assertions(self):
        told = frob.simulate("follow.frob", duration=1).attrs["assertions"]
        self.assertEqual(told["moves"], frob.Assertion("moves", "held", None, 0))
        self.assertEqual(told["flies"], frob.Assertion("flies", "violated", 0.0, 51))

    def test_several_robots(self):
        with open("two.toml", "w") as file:
            file.write(TWO)
        tables = frob.simulate("follow.frob", duration=1, world="two.toml").attrs["robots"]
        self.assertEqual([len(table) for table in tables], [51, 51])
        self.assertFalse(tables[0].equals(tables[1]))

    def test_mistakes(self):
        for text, options in [
            ("there is no world nowhere.toml", dict(world="nowhere.toml")),
            ("seed: expected a whole number of at least 0, found -1", dict(seed=-1)),
            (
                "duration: expected seconds from 0.001 to 100000, found nan",
                dict(duration=float("nan")),
            ),
            ("rate: expected a number, found '50'", dict(rate="50")),
            ("the program has no parameter `far`", dict(params={"far": 1})),
            ("expected the unit `m`, found `s`", dict(params={"distance": "1[s]"})),
        ]:
            with self.assertRaises(frob.Error) as caught:
                frob.simulate("follow.frob", **options)
            self.assertIn(text, str(caught.exception))


class Read(unittest.TestCase):
    def told(self, text, message):
        with open("log.csv", "w", newline="") as file:
            file.write(text)
        with self.assertRaises(frob.Error) as caught:
            frob.read("log.csv")
        self.assertEqual(str(caught.exception), message)

    def test_cells(self):
        text = '# param n=3\ntime,in.a,in.b,in.c,out\n0.000000000,At 0.5,,Idle,"Left (1, true)"\n'
        text += "0.100000000,NoWhere,nan,Idle,Right (Pose {x = -2})\n"
        with gzip.open("log.csv.gz", "wt") as file:
            file.write(text)
        table = frob.read("log.csv.gz")
        self.assertEqual(table["in.a"].tolist(), [frob.Data("At", 0.5), frob.Data("NoWhere")])
        self.assertEqual(repr(table["in.b"].tolist()), "[None, Data('Event', nan)]")
        self.assertEqual(table["in.c"].tolist(), ["Idle", "Idle"])
        pose = frob.Data("Pose", x=-2)
        self.assertEqual(
            table["out"].tolist(), [frob.Data("Left", (1, True)), frob.Data("Right", pose)]
        )
        self.assertEqual((table["time"].dtype, table.attrs["params"]), (float, {"n": 3}))

    def test_compressed(self):
        with open("log.csv", "w") as file:
            file.write("time,in\n0,1\n1,2\n")
        subprocess.run(["zstd", "-qf", "log.csv"], check=True)
        self.assertEqual(list(frob.read("log.csv.zst")["in"]), [1, 2])
        with open("log.csv", "rb") as file:
            packed = gzip.compress(file.read())
        damaged = "the archive is truncated or damaged (`frobc convert` recovers its complete rows)"
        for ending, content, reason in (
            ("gz", packed[:-9], damaged),
            ("gz", packed[:12] + b"x" + packed[13:], damaged),
            ("gz", b"time,in\n0,1\n", "its name says that it is compressed by gzip, but it is not"),
            (
                "zst",
                b"time,in\n0,1\n",
                "its name says that it is compressed by zstd, but it is not",
            ),
        ):
            with open(f"bad.csv.{ending}", "wb") as file:
                file.write(content)
            with self.assertRaises(frob.Error) as caught:
                frob.read(f"bad.csv.{ending}")
            self.assertEqual(str(caught.exception), f"cannot read bad.csv.{ending}: {reason}")
        with unittest.mock.patch.dict(os.environ, {"PATH": os.getcwd()}):
            with self.assertRaisesRegex(
                frob.Error, "this needs the program zstd, which is not installed"
            ):
                frob.read("log.csv.zst")

    def test_mistakes(self):
        with self.assertRaisesRegex(frob.Error, "cannot read nowhere.csv: No such file"):
            frob.read("nowhere.csv")
        self.told(
            "a,b\n1,2\n",
            "log.csv:1: not a recording: the first column must be `time`, not `a`; "
            "to choose the column with the times, pass `time_column=NAME`",
        )
        self.told("", "log.csv:1: not a recording: the first column must be `time`")
        self.told(
            "time,in\n0,1\n1\n",
            "log.csv:3: 2 columns, but 1 cells in this row; the recording may be truncated",
        )
        self.told(
            "# param a=1\ntime,in\n0,1\n1,(2\n", "log.csv:4: column `in`: the value ends too early"
        )
        with open("log.csv", "wb") as file:
            file.write(b"\x89PNG\xff")
        with self.assertRaisesRegex(frob.Error, "log.csv is not a recording: it is not text"):
            frob.read("log.csv")

    def test_empty(self):
        with open("log.csv", "w") as file:
            file.write("time,in,out\n")
        self.assertEqual(
            (len(frob.read("log.csv")), list(frob.read("log.csv"))), (0, ["time", "in", "out"])
        )


if __name__ == "__main__":
    checks.main("simulating and reading in Python")
