"""Tests sweeps from Python on one machine."""

import math
import os
import shutil
import unittest
import xml.etree.ElementTree

import checks
import frob
from frob import tools

FOLLOW = """import Robot
import Trial
import WallFollow

param gap :: Distance = 0.3[m]
param on :: Bool = True

main :: (HasSonar i, DiffDrive o) => Program i o
main = reactimateRobot (wallFollow1 gap)

trial "keeps off" = Trial {
    world = "room.toml", lasts = 4[s], seeds = 1 `to` 10, judge = proc t -> neverTouches t where
        error = meanOf (t.clearance - gap)
        assert "stays" (t.driven < 1.2[m])
}
"""

PLAN = """program = "follow.frob"
robots = ["pioneer", "scout"]
[params]
gap = "20[cm] to 0.4[m], 3 steps"
on = [true, false]
"""


def write(name, text):
    with open(name, "w") as file:
        file.write(text)


class Sweep(unittest.TestCase):
    def setUp(self):
        write("follow.frob", FOLLOW)
        write("gaps.toml", PLAN)
        shutil.rmtree("gaps.rows", ignore_errors=True)

    def test_is_frobc_sweep(self):
        told = tools.run(["sweep", "gaps.toml", "--rows", "others", "--table", "swept.csv"])
        runs = frob.sweep("gaps.toml", jobs=2, picture=True)
        with open("swept.csv") as file:
            names, *rows = [line.rstrip("\n").split(",") for line in file]
        self.assertEqual(list(runs.columns), names)
        self.assertEqual(len(runs), 120)
        for name, texts in zip(names, zip(*rows)):
            for value, text in zip(runs[name].tolist(), texts):
                if isinstance(value, bool):
                    self.assertEqual(text, str(value).lower())
                elif isinstance(value, str):
                    self.assertEqual(text, value)
                elif math.isnan(value):
                    self.assertEqual(text, "")
                else:
                    self.assertEqual(float(text), value)
        kinds = {
            name: runs[name].dtype.kind for name in ("run", "seed", "touches", "gap", "on", "error")
        }
        self.assertEqual(
            kinds, {"run": "i", "seed": "i", "touches": "i", "gap": "f", "on": "b", "error": "f"}
        )
        self.assertEqual(set(runs["fate"]), {"held", "violated"})
        self.assertEqual(runs.attrs["summary"] + "\ntable: swept.csv\n", told)
        xml.etree.ElementTree.fromstring(runs.attrs["picture"])
        self.assertFalse(os.path.exists("gaps.csv"))

    def test_goes_on(self):
        before = frob.sweep("gaps.toml")
        os.utime("gaps.rows", (0, 0))
        self.assertTrue(frob.sweep("gaps.toml").equals(before))
        self.assertEqual(os.path.getmtime("gaps.rows"), 0)
        self.assertTrue(frob.sweep("gaps.toml", rows="new/../gaps.rows").equals(before))

    def test_robot(self):
        write("follow.frob", FOLLOW.replace("        error = meanOf (t.clearance - gap)\n", ""))
        write("any.toml", 'program = "follow.frob"\nseeds = [7, 8]\nlasts = 0.1\n')
        runs = frob.sweep("any.toml", robot="create", picture=True)
        self.assertIn("fraction of runs that held", runs.attrs["picture"])
        self.assertEqual(list(runs["robot"]), ["create", "create"])
        self.assertEqual(list(runs["seed"]), [7, 8])

    def test_errors(self):
        with self.assertRaisesRegex(frob.Error, "^there is no plan none.toml$"):
            frob.sweep("none.toml")
        with self.assertRaisesRegex(
            frob.InputError, "^jobs: expected a whole number of at least 1, found 0$"
        ):
            frob.sweep("gaps.toml", jobs=0)
        write("wrong.toml", PLAN + "gp = 3\n[more]\n")
        with self.assertRaisesRegex(frob.Error, r"^error: wrong.toml:7:2: unknown key `more`"):
            frob.sweep("wrong.toml")
        write("wrong.toml", PLAN.replace("follow", "wrong"))
        write("wrong.frob", FOLLOW.replace("wallFollow1 gap", "gap"))
        with self.assertRaisesRegex(frob.CompileError, "wrong.frob:9:25"):
            frob.sweep("wrong.toml")


if __name__ == "__main__":
    checks.main("sweeps from Python")
