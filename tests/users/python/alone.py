"""Tests the package with a bare Python installation."""

import subprocess
import sys
from importlib.metadata import version

import frob
import frob.tools

with open("half.frob", "w") as file:
    file.write("main :: SF Float Float\nmain = proc x -> sin x / 2\n")
half = frob.compile("half.frob")
assert half.step(0.1, 0) == 0
assert half.run([0, 0], time=[0, 1]) == [0, 0]
try:
    half.run({"in": [1.0]}, dt=1)
except frob.Error as error:
    assert str(error).startswith("columns and arrays need numpy, which is not installed"), error
else:
    sys.exit("columns without numpy")
with open("go.frob", "w") as file:
    file.write("import Robot\nmain :: Program RobotInput RobotOutput\n")
    file.write("main = reactimateRobot (proc _ -> roMake (setVelTR 0.1[m/s] 0))\n")
run = frob.simulate("go.frob", duration=1)
assert isinstance(run, frob.Columns) and len(run["time"]) == 51 and run.attrs["params"] == {}
with open("go.frob") as file:
    text = file.read()
with open("go.frob", "w") as file:
    file.write("import Trial\n" + text)
    file.write('trial "goes" = Trial { world = "room.toml", lasts = 1[s], ')
    file.write("seeds = 1 `to` 3, judge = neverTouches }\n")
with open("go.toml", "w") as file:
    file.write('program = "go.frob"\n')
runs = frob.sweep("go.toml")
assert isinstance(runs, frob.Columns) and runs["run"] == [1, 2, 3], runs
assert runs["fate"] == ["held"] * 3 and runs["driven"][0] > 0, runs
compiler = subprocess.run(
    [frob.tools.frobc(), "--version"], stdout=subprocess.PIPE, text=True, check=True
)
assert version("frobc") == compiler.stdout.strip(), (version("frobc"), compiler.stdout)
print("ok   the package with nothing but Python")
