"""usage: operate.py FROBC RUN.csv FILE ROBOT

Tests operator input on the page of a run: it must reach the program, be recorded, and replay. A
held button must be released when its page falls silent, for whatever reason."""

import asyncio
import csv
import math
import os
import subprocess
import sys
import time

import viewer
from live import PATIENCE, Page, path
from viewer import check

teleop = "../../../examples/teleop/teleop.frob"
go_there = "../../../examples/teleop/go_there.frob"
bug = "../../../examples/bug/clicked.frob"


class Panel:
    """The program's console, with controls by label."""

    def __init__(self, page):
        self.page = page
        self.controls = page.program["console"]
        self.labels = [control["label"] for control in self.controls]
        self.names = [signal["name"] for signal in page.program["signals"]]

    async def set(self, label, x, cell):
        """Sets a control until the program has taken the value: repeats it if it was late."""
        while True:
            await self.page.insist(f"touch {self.labels.index(label)} {x} 0")
            end = self.page.live["instants"] + 100
            await self.page.until(
                lambda p: self.input(label) == cell or p.live["instants"] > end or p.refused
            )
            if self.input(label) == cell:
                return

    async def click(self, label, x, y):
        """Clicks once. Returns the instant at which the program has taken it."""
        return await self.page.until_taken(
            f"touch {self.labels.index(label)} {x} {y}", self.names.index(f"in.console.{label}")
        )

    async def hold(self, label, x):
        await self.page.socket.send(f"hold {self.labels.index(label)} {x}")

    async def hold_until(self, label, condition):
        """Holds a button, renewing it ten times a second."""
        end = time.monotonic() + PATIENCE
        while not condition() and time.monotonic() < end:
            await self.hold(label, 1)
            next_hold = time.monotonic() + 0.1
            while not condition() and time.monotonic() < next_hold:
                await self.page.hear()

    async def press_once(self, label):
        """Sends a single hold until the program has taken it: repeats it if it was late."""
        while self.input(label) != "true":
            await self.hold(label, 1)
            end = self.page.live["instants"] + 100
            await self.page.until(lambda p: self.input(label) == "true" or p.live["instants"] > end)

    def value(self, name):
        return self.page.live["newest"]["cells"][self.names.index(name)]

    def input(self, label):
        return self.value(f"in.console.{label}")

    async def until(self, label, cell):
        await self.page.until(lambda p: self.input(label) == cell)


def rows(name):
    with open(path(name), newline="") as file:
        return list(csv.DictReader(file))


def replays(run, recording, program, robot):
    """Checks that both engines reproduce the run's outputs."""
    for engine in "c", "interp":
        traced = subprocess.run(
            [
                run.frobc,
                "trace",
                program,
                "--robot",
                robot,
                "--input",
                path(recording),
                "--engine",
                engine,
            ],
            check=True,
            stdout=subprocess.PIPE,
            text=True,
        ).stdout
        for row, other in zip(rows(recording), csv.DictReader(traced.splitlines()), strict=True):
            if any(row[name] != other[name] for name in other):
                return False
    return True


async def driving(frobc):
    run = viewer.Run(frobc, ["--robot", "pioneer", "--record", path("teleop.csv"), teleop])
    async with Page(run) as page:
        panel = Panel(page)
        check(
            "the page is told what is on the console",
            panel.controls[2]
            == {
                "kind": "knob",
                "label": "speed",
                "unit": "m/s",
                "least": 0,
                "most": 0.5,
                "first": 0.25,
                "signal": panel.names.index("in.console.speed"),
            },
        )
        await page.until(lambda p: p.live and p.live["instants"] > 5)
        check(
            "at first all is as the program says",
            panel.input("speed") == "0.25"
            and panel.input("careful") == "true"
            and panel.input("drive") == "false",
        )
        await panel.set("speed", 0.125, "0.125")
        await panel.set("turn", -9, "-1")
        check("a knob stays within its limits", True)
        await panel.set("turn", 0, "0")
        await panel.set("careful", 0, "false")
        await panel.hold_until("drive", lambda: panel.value("out.forward") == "0.125")
        check("a button that is held drives", panel.value("out.forward") == "0.125")
        await panel.hold("drive", 0)
        await panel.until("drive", "false")
        check("until it is let go of", panel.value("out.forward") == "0")
        held_once = page.live["instants"]  # from here on, the hold is not renewed
        await panel.press_once("drive")
        await panel.until("drive", "false")
        check("or until its page falls silent", True)
        for nonsense in (
            "touch",
            "touch 0",
            "touch x 1 2",
            "touch 2 nan 0",
            "touch 2 1 inf",
            "touch -1 1 0",
            "touch 1.5 1 0",
            "touch 2 1 0 0",
            "hold",
            "hold 0",
            "hold 0 1 1",
            "hold 1e99 1",
        ):
            if await page.send(nonsense) == []:
                check(f"{nonsense} is refused", False)
        for strange in ("touch 99 1 0", "hold 2 1", "touch 0 1 0", "hold 999999 1"):
            await page.send(strange)
        await asyncio.sleep(0.2)
        await page.until(lambda p: p.live["newest"])
        check(
            "what is not on the console changes nothing",
            panel.input("speed") == "0.125" and panel.input("drive") == "false",
        )
        await panel.press_once("drive")
    # The page disconnects while it holds the button.
    async with Page(run) as page:
        panel = Panel(page)
        await page.until(lambda p: p.live is not None and p.live.get("newest"))
        await panel.until("drive", "false")
        check("or until it goes away", True)
        await panel.press_once("drive")
        os.kill(run.viewer, 19)  # SIGSTOP
        await asyncio.sleep(1)
        os.kill(run.viewer, 18)  # SIGCONT
        await panel.until("drive", "false")
        check("or until the viewer does", True)
        await page.send("stop")
        await page.to_end()
    check("a run that was operated ends well", run.process.wait(PATIENCE) == 0)
    held = [row["in.console.drive"] for row in rows("teleop.csv")[held_once:]]
    longest = max(
        len(part) for part in "".join("x" if cell == "true" else " " for cell in held).split()
    )
    # 0.3 s, plus 0.1 s that a late run may catch up.
    check("no page held it for long after it was heard", 0 < longest <= 25)
    check("and replays", replays(run, "teleop.csv", teleop, "pioneer"))


async def clicking(frobc):
    run = viewer.Run(frobc, ["--robot", "pioneer", "--record", path("there.csv"), go_there])
    async with Page(run) as page:
        panel = Panel(page)
        await page.until(lambda p: p.live and p.live["instants"] > 5)
        await page.insist("speed 10")
        await panel.click("map", 0.5, 0.25)
        await panel.click("map", 0.625, 0.125)
        await page.until(lambda p: float(panel.value("in.odometry.position.x")) > 0.4)
        check("the robot goes to a click on the map", True)
        await page.send("stop")
        await page.to_end()
    run.process.wait(PATIENCE)
    clicks = [
        (k, row["in.console.map"])
        for k, row in enumerate(rows("there.csv"))
        if row["in.console.map"] != ""
    ]
    check(
        "clicks are recorded, each at an instant of its own",
        [cell for _, cell in clicks] == ["(0.5, 0.25)", "(0.625, 0.125)"]
        and clicks[0][0] < clicks[1][0],
    )
    check("and replay", replays(run, "there.csv", go_there, "pioneer"))


async def going_round(frobc):
    """Runs BUG to a clicked goal behind an obstacle, and back with another click."""
    run = viewer.Run(frobc, ["--robot", "pioneer", "--record", path("bug.csv"), bug])
    async with Page(run) as page:
        panel = Panel(page)

        def away(x, y):
            return math.hypot(
                float(panel.value("in.odometry.position.x")) - x,
                float(panel.value("in.odometry.position.y")) - y,
            )

        await page.until(lambda p: p.live and p.live["instants"] > 5)
        check("without a goal it stands", panel.value("out.forward") == "0")
        await page.insist("speed 100")
        await panel.click("map", 3.5, 0)
        await page.until(lambda p: away(3.5, 0) < 0.25)
        check(
            "BUG comes to a goal that is clicked, round what is in the way",
            panel.value("in.frontBumper") != "true",
        )
        await panel.click("map", 3, 1)
        await page.until(lambda p: away(3, 1) < 0.25)
        check("and to the next one", True)
        await page.send("stop")
        await page.to_end()
    run.process.wait(PATIENCE)
    passed = rows("bug.csv")
    first = passed[: next(k for k, row in enumerate(passed) if row["in.console.map"] == "(3, 1)")]
    check(
        "it had to go round", max(abs(float(row["in.odometry.position.y"])) for row in first) > 0.3
    )
    check("and all of it replays", replays(run, "bug.csv", bug, "pioneer"))


async def main():
    frobc = sys.argv[1]
    await driving(frobc)
    await going_round(frobc)
    await clicking(frobc)


if __name__ == "__main__":
    asyncio.run(main())
    sys.exit(viewer.failures > 0)
