"""usage: interpreted.py FROBC RUN.csv FILE ROBOT

Checks that the page shows what the interpreter computes, which shares no code with the C that the
viewer runs: outputs, drawings, and internal signals, which a variant of the program outputs."""

import asyncio
import csv
import os
import subprocess
import sys
import tempfile

import viewer
from protocol import ask, connect, greet
from viewer import check

inner = """\
import Control

main :: SF (Velocity, Bool) Distance
main = proc (v, turns) -> way where
    (way, _, _, _) = all (v, turns)

all :: SF (Velocity, Bool) (Distance, Velocity, Acceleration, Bool)
all = proc (v, turns) -> (way, smooth, rate, back) where
    smooth = lowPass 0.3[s] v
    rate = derivative smooth
    way = integral (if back then -smooth else smooth)
    back = delay False (turns && way > 0.5[m])
"""
# The same program with its internal signals as outputs.
outer = inner.replace(
    "SF (Velocity, Bool) Distance\nmain = proc (v, turns) -> way where\n"
    "    (way, _, _, _) = all (v, turns)",
    "SF (Velocity, Bool) (Distance, Velocity, Acceleration, Bool)\nmain = all",
)
names = ["probe.all.way", "probe.all.smooth", "probe.all.rate", "probe.all.back"]


def interpreted(frobc, program, recording, *options):
    traced = subprocess.run(
        [frobc, "trace", "--engine", "interp", "--input", recording, *options, program],
        check=True,
        stdout=subprocess.PIPE,
        text=True,
    ).stdout
    return list(csv.DictReader(traced.splitlines()))


async def shown(v, rows, columns):
    """Whether the cells of each instant equal those of the rows in these columns."""
    async with connect(v) as client:
        signals = [signal["name"] for signal in (await greet(v, client))["signals"]]
        places = {signals.index(name): column for name, column in columns.items()}
        for k, row in enumerate(rows):
            cells = (await ask(client, f"instant {k}"))["cells"]
            if any(cells[place] != row[column] for place, column in places.items()):
                return False
        return len(rows) > 100


async def main():
    frobc, recording, program, robot = sys.argv[1:]
    rows = interpreted(frobc, program, recording, "--robot", robot, "--probe", "draw")
    v = viewer.Viewer(frobc, recording, program)
    columns = [column for column in rows[0] if column != "time"]
    check(
        "outputs and what is drawn are as interpreted",
        any(column.startswith("probe.draw") for column in columns)
        and await shown(v, rows, {column: column for column in columns}),
    )
    v.end()
    with tempfile.TemporaryDirectory() as folder:

        def file(name, text):
            with open(os.path.join(folder, name), "w") as file:
                file.write(text)
            return file.name

        recording = file(
            "run.csv",
            "time,in.1,in.2\n"
            + "".join(
                f"{k * 0.05:.2f},{(k * 7 % 23) / 10},{str(k % 40 > 20).lower()}\n"
                for k in range(400)
            ),
        )
        rows = interpreted(frobc, file("outer.frob", outer), recording)
        v = viewer.Viewer(frobc, recording, file("inner.frob", inner))
        outputs = [column for column in rows[0] if column != "time"]
        check(
            "inner signals are as interpreted",
            len(outputs) == len(names)
            and {row[outputs[3]] for row in rows} == {"true", "false"}
            and await shown(v, rows, dict(zip(names, outputs))),
        )
        v.end()


asyncio.run(main())
sys.exit(viewer.failures > 0)
