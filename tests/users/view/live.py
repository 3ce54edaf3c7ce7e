"""usage: live.py FROBC RUN.csv FILE ROBOT

Runs that are looked at while they go on: what their viewer says is what `frobc trace` says
later, what may be done to them is done, and whatever happens to the viewer, recordings are the
same."""

import asyncio
import json
import os
import random
import re
import signal
import subprocess
import sys
import tempfile

import websockets

import viewer
from viewer import check

folder = tempfile.mkdtemp()
stick = "../../../examples/safe_stick/safe_stick.frob"


def path(name):
    return os.path.join(folder, name)


def read(name):
    with open(path(name), "rb") as file:
        return file.read()


class Page:
    """A WebSocket client that keeps what comes by itself apart from answers."""

    def __init__(self, run):
        self.run = run
        self.live = self.state = self.program = None
        self.refused = []

    async def __aenter__(self):
        self.socket = await websockets.connect(
            f"ws://{self.run.host}/",
            subprotocols=["frob-view"],
            origin=f"http://{self.run.host}",
            max_size=None,
        )
        await self.socket.send(f"hello {self.run.token}")
        self.program = await self.answer("program")
        return self

    async def __aexit__(self, *_):
        await self.socket.close()

    async def hear(self):
        received = await asyncio.wait_for(self.socket.recv(), 20)
        if isinstance(received, bytes):
            head, _, pixels = received.partition(b"\n")
            return dict(json.loads(head), pixels=pixels)
        message = json.loads(received)
        if message["is"] == "live":
            self.live = message
            await self.socket.send("more")
        elif message["is"] == "run":
            self.state = message
        elif message["is"] == "refused":
            self.refused.append(message["why"])
        return message

    async def answer(self, kind):
        while True:
            message = await self.hear()
            if message["is"] == kind:
                return message

    async def ask(self, request):
        await self.socket.send(request)
        return await self.answer(request.split()[0])

    async def until(self, condition):
        while not condition(self):
            await self.hear()

    async def send(self, command):
        """Something that is done to the run, and what is said of it."""
        self.refused.clear()
        await self.socket.send(command)
        await self.answer("run")
        await self.socket.send("program")
        await self.answer("program")
        return self.refused

    async def to_end(self):
        await self.until(lambda p: p.live and not p.live["live"])


async def as_traced(page, run, recording, program, robot):
    rows = viewer.trace(run.frobc, path(recording), program, robot)
    names = [signal["name"] for signal in page.program["signals"]]
    await page.until(lambda p: p.live["replayed"] == p.live["instants"])
    differing = page.live["instants"] != len(rows)
    for k in random.Random(3).sample(range(len(rows)), min(len(rows), 300)):
        instant = await page.ask(f"instant {k}")
        differing += instant["cells"] != [rows[k][name] for name in names]
    return differing == 0


async def values(frobc, program, robot):
    """A run that is looked at, with a second page that never reads."""
    arguments = ["--for", "10s", "--record"]
    subprocess.run(
        [frobc, "run", *arguments, path("plain.csv"), program],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    run = viewer.Run(frobc, [*arguments, path("looked.csv"), program])
    async with (
        Page(run) as page,
        websockets.connect(
            f"ws://{run.host}/", subprotocols=["frob-view"], origin=f"http://{run.host}"
        ) as deaf,
    ):
        await deaf.send(f"hello {run.token}")
        await page.until(lambda p: p.live and p.live["instants"] > 25)
        check(
            "a run is seen while it goes on",
            page.live["live"] and page.live["newest"]["k"] == page.live["instants"] - 1,
        )
        check("it may be paced, and sent events", page.state["paces"] and page.state["sends"])
        moved = page.live["newest"]["truth"][0]
        early = await page.ask("instant 10")
        check("an instant of before can be asked for", early["k"] == 10)
        check("and where the robot really was", moved[0] != early["truth"][0][0])
        check("it can be made faster", await page.send("speed 100") == [])
        await page.to_end()
        check(
            "its instants are as traced", await as_traced(page, run, "looked.csv", program, robot)
        )
        series = await page.ask("series 0 0 1e6 100000")
        check("a plot has all of it", len(series["times"]) == page.live["instants"])
        check("and so has the way", len((await page.ask("way 0 1000"))["points"]) == 501)
        check(
            "when it is over nothing can be done to it",
            await page.send("pause") == [] or page.refused != [],
        )
    check("it ends as without", run.process.wait(10) == 0)
    check("and is recorded as without", read("plain.csv") == read("looked.csv"))


async def commands(frobc, program):
    run = viewer.Run(frobc, ["--record", path("commands.csv"), program])
    async with Page(run) as page, Page(run) as other:
        await page.until(lambda p: p.live and p.live["instants"] > 5)
        await page.send("pause")
        at = (await page.ask("program"))["instants"]
        await asyncio.sleep(0.3)
        at = (await page.ask("program"))["instants"]
        await asyncio.sleep(0.5)
        check(
            "a run that is paused stands",
            (await page.ask("program"))["instants"] == at and page.state["paused"],
        )
        for _ in range(3):
            await page.send("step")
        await page.until(lambda p: p.live["instants"] == at + 3)
        await asyncio.sleep(0.3)
        check("it takes single instants", (await page.ask("program"))["instants"] == at + 3)
        check(
            "another page may not",
            await other.send("go") == ["another page operates this run"]
            and not other.state["operates"],
        )
        await other.send("take")
        await page.until(lambda p: not p.state["operates"])
        check("unless it takes over", other.state["operates"] and await other.send("go") == [])
        await page.until(lambda p: p.live["instants"] > at + 10)
        check("and then it goes on", not page.state["paused"])
        for speed in ("0", "0.05", "101", "nan", "-1", "1e9", "x"):
            if await other.send(f"speed {speed}") == []:
                check(f"speed {speed} is refused", False)
        check("speeds out of range are refused", page.state["speed"] == 1)
        await other.send("pause")
        other.refused.clear()
        for _ in range(100):
            await other.socket.send("key 119")
        await other.send("take")
        check("of a flood of events not all are taken", len(other.refused) > 0)
        for nonsense in (
            "stop now",
            "key",
            "key -1",
            "key x",
            "key 1e99",
            "step 3",
            "pause x",
            "speed",
            "take it",
            "go go",
        ):
            if await other.send(nonsense) == []:
                check(f"{nonsense} is refused", False)
        check("nonsense is refused", not page.state["stopping"])
        await page.socket.send("stop")
        await page.to_end()
        check("any page stops it", True)
    check("a run that is stopped ends well", run.process.wait(10) == 0)
    check("with a summary", "time simulated:" in run.process.stdout.read())


async def events(frobc):
    """Keys that are pressed on a page are in the recording, and replay."""
    run = viewer.Run(frobc, ["--robot", "pioneer", "--record", path("keys.csv"), stick])
    async with Page(run) as page:
        names = [signal["name"] for signal in page.program["signals"]]
        key, forward = names.index("in.key"), names.index("out.forward")
        await page.until(lambda p: p.live and p.live["instants"] > 5)
        for _ in "ww":
            await page.send(f"key {ord('w')}")
        await page.until(lambda p: float(p.live["newest"]["cells"][forward]) > 0.05)
        check("a program reacts to a key", True)
        await page.send("stop")
        await page.to_end()
        pressed = [
            k
            for k in range(page.live["instants"])
            if (await page.ask(f"instant {k}"))["cells"][key] != ""
        ]
        check("each key is there once", len(pressed) == 2)
        check("and all is as traced", await as_traced(page, run, "keys.csv", stick, "pioneer"))
    run.process.wait(10)


async def gaps(frobc, program, robot, recorded):
    """A viewer that was stopped for so long that instants were overwritten."""
    record = ["--record", path("gap.csv")] if recorded else []
    run = viewer.Run(frobc, ["--rate", "500", *record, program])
    async with Page(run) as page:
        await page.until(lambda p: p.live and p.live["instants"] > 5)
        await page.send("speed 20")
        os.kill(run.viewer, signal.SIGSTOP)
        await asyncio.sleep(2)
        os.kill(run.viewer, signal.SIGCONT)
        await page.until(lambda p: p.live["newest"]["time"] > 3)
        await page.send("speed 1")
        await page.send("stop")
        await page.to_end()
        instants, newest = page.live["instants"], page.live["newest"]
        rate = round(newest["time"] / newest["dt"]) + 1 if newest["dt"] else 0
        if recorded:
            check(
                "what was missed comes from the recording",
                page.live["notes"] == "" and instants == rate,
            )
            check("and is as traced", await as_traced(page, run, "gap.csv", program, robot))
        else:
            check(
                "without a recording a gap is told",
                "were missed" in page.live["notes"] and instants < rate,
            )
            inner = [
                i for i, s in enumerate(page.program["signals"]) if s["side"] in ("probe", "mode")
            ]
            before = (await page.ask("instant 3"))["cells"]
            check("before it all is known", any(before[i] for i in inner))
            check(
                "after it what comes and goes",
                newest["cells"][0] != "" and not any(newest["cells"][i] for i in inner),
            )
            for request in (
                f"series {inner[0]} 0 1e6 1000",
                f"find 0 {page.program['signals'][0]['name']} > 1",
            ):
                await page.socket.send(request)
                await page.answer("series" if request[0] == "s" else "found")
    run.process.wait(10)


async def misfortunes(frobc, program):
    """The viewer is stopped, killed, or was never there."""
    arguments = ["--for", "3s", "--record"]
    subprocess.run(
        [frobc, "run", *arguments, path("plain.csv"), program],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    runs = {}
    for name, number in (("stopped", signal.SIGSTOP), ("killed", signal.SIGKILL)):
        runs[name] = viewer.Run(frobc, [*arguments, path(name + ".csv"), program])
        if name == "killed":
            async with Page(runs[name]) as page:
                await page.send("pause")
        command = viewer.arguments_of(runs[name].host_process)
        os.kill(runs[name].viewer, number)
    for name, run in runs.items():
        check(f"with a viewer that was {name} a run ends as without", run.process.wait(20) == 0)
        check("and is recorded as without", read("plain.csv") == read(name + ".csv"))
    os.kill(runs["stopped"].viewer, signal.SIGKILL)
    simulator = os.path.join(os.path.dirname(frobc), "..", "lib", "frobc", "frob-sim")
    command = command[: command.index("--viewer")]
    command[command.index("--record") + 1] = path("never.csv")
    gone = subprocess.run(
        [simulator, *command, "--viewer", path("gone")],
        stderr=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        text=True,
    )
    check(
        "without a viewer, too",
        gone.returncode == 0
        and "warning: this run cannot be looked at: " in gone.stderr
        and read("plain.csv") == read("never.csv"),
    )


class Robot:
    """A simulated one behind a line of its own."""

    def __init__(self, frobc):
        self.process = subprocess.Popen(
            [frobc, "serve", "--tcp", "0"], stdout=subprocess.PIPE, text=True
        )
        self.device = self.process.stdout.readline().removeprefix("device:").strip()

    def __enter__(self):
        return ["--robot", "pioneer", "--device", self.device]

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(10)


async def robot(frobc):
    with Robot(frobc) as device:
        run = viewer.Run(frobc, [*device, "--record", path("robot.csv"), stick])
        async with Page(run) as page:
            await page.until(lambda p: p.live and p.live["instants"] > 50)
            check("a robot's run is seen while it goes on", page.live["live"])
            check(
                "a real robot is only looked at",
                not page.state["sends"]
                and not page.state["paces"]
                and "only looked at" in (await page.send("key 119"))[0]
                and await page.send("pause") != []
                and await page.send("speed 2") != [],
            )
            await page.send("stop")
            await page.to_end()
            check("but stopped it can be, as with Ctrl-C", run.process.wait(10) == 4)
            check("and is as traced", await as_traced(page, run, "robot.csv", stick, "pioneer"))
    with Robot(frobc) as device:
        run = viewer.Run(frobc, [*device, "--for", "4s", stick], how="print,control")
        async with Page(run) as page:
            forward = [s["name"] for s in page.program["signals"]].index("out.forward")
            await page.until(lambda p: p.live and p.live["instants"] > 5)
            check("unless more is allowed", await page.send(f"key {ord('w')}") == [])
            await page.until(lambda p: float(p.live["newest"]["cells"][forward]) > 0)
            check("and then it reacts to a key", True)
        os.kill(run.viewer, signal.SIGKILL)
        check("without its viewer it goes on", run.process.wait(10) == 0)
        steps = re.search(r"^steps: (\d+)$", run.process.stdout.read(), re.M)
        check("to its end", int(steps[1]) > 100)


async def main():
    frobc, _, program, name = sys.argv[1:]
    await values(frobc, program, name)
    await commands(frobc, program)
    await events(frobc)
    await gaps(frobc, program, name, recorded=False)
    await gaps(frobc, program, name, recorded=True)
    await misfortunes(frobc, program)
    await robot(frobc)


if __name__ == "__main__":
    asyncio.run(main())
    sys.exit(viewer.failures > 0)
