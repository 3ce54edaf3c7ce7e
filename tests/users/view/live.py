"""usage: live.py FROBC RUN.csv FILE ROBOT

Tests viewers of live runs: the viewer must report what `frobc trace` reports later, commands to the
run must be carried out, and whatever happens to the viewer must not change the recording."""

import asyncio
import json
import os
import random
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time

import websockets

import viewer
from viewer import check
from way import is_followed

PATIENCE = 120  # seconds for anything that must happen, however busy the machine is

# The page's message that a command was not executed because the run's process was frozen, or had
# no processor, for longer than a command may wait. On a busy machine this is right.
LATE = (
    "the run is not responding, so the request was ignored",
    "the request came too late and was ignored",
)

folder = tempfile.mkdtemp()
stick = "../../../examples/safe_stick/safe_stick.frob"


def path(name):
    return os.path.join(folder, name)


def read(name):
    with open(path(name), "rb") as file:
        return file.read()


class Page:
    """A WebSocket client that separates unsolicited messages from answers."""

    def __init__(self, run):
        self.run = run
        self.live = self.state = self.program = None
        self.refused = []
        self.fates = []

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
        received = await asyncio.wait_for(self.socket.recv(), PATIENCE)
        if isinstance(received, bytes):
            head, _, pixels = received.partition(b"\n")
            return dict(json.loads(head), pixels=pixels)
        message = json.loads(received)
        if message["is"] == "live":
            self.live = message
            await self.socket.send("more")
        elif message["is"] == "beat" and message.get("fate", "") not in ("", *self.fates):
            self.fates.append(message["fate"])
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
        end = time.monotonic() + PATIENCE
        while not condition(self):
            if time.monotonic() > end:
                raise TimeoutError(f"not within {PATIENCE} s; the newest is {self.live}")
            await self.hear()

    async def insist(self, command):
        """Sends a command again for as long as the run's process is too late to carry it out.
        Returns the other refusals."""
        end = time.monotonic() + PATIENCE
        while True:
            refused = await self.send(command)
            others = [why for why in refused if why not in LATE]
            if others or refused == [] or time.monotonic() > end:
                return others if others else refused

    async def stands(self):
        """Waits until no instant has come for half a second. Returns the number of instants."""
        end = time.monotonic() + PATIENCE
        count = None
        while True:
            before, count = count, (await self.ask("program"))["instants"]
            if count == before:
                return count
            if time.monotonic() > end:
                raise TimeoutError(f"the run goes on: {before}, then {count} instants")
            await asyncio.sleep(0.5)

    async def until_taken(self, event, signal):
        """Sends an event until the program has taken it: once, unless the run's process reports
        that it was late. Returns the instant, or None if the event was lost without a report."""
        while True:
            k = (await self.ask("program"))["instants"]
            refused = await self.insist(event)
            end = k + 500
            while not refused and k < end:
                await self.until(lambda p: p.live["instants"] > k or p.refused)
                if self.refused:
                    break
                if (await self.ask(f"instant {k}"))["cells"][signal] != "":
                    return k
                k += 1
            if not self.refused or any(why not in LATE for why in self.refused):
                return None

    async def send(self, command):
        """Sends a command to the run; returns the answer."""
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
    """Views a run, with a second page that never reads."""
    arguments = ["--for", "60s", "--record"]  # longer than opening a page takes
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
        check("it can be made faster", await page.insist("speed 100") == [])
        await page.to_end()
        check(
            "its instants are as traced", await as_traced(page, run, "looked.csv", program, robot)
        )
        series = await page.ask("series 0 0 1e6 100000")
        check("a plot has all of it", len(series["times"]) == page.live["instants"])
        places = [
            [instant["time"], *instant["truth"][0][:2]]
            for k in range(0, page.live["instants"], 7)
            for instant in [await page.ask(f"instant {k}")]
        ]
        way = await page.ask("way 0 100000")
        check("and so has the way", is_followed(way["points"], places))
        rest = await page.ask(f"way 0 100000 {way['next']}")
        check(
            "which is continued from its last corner",
            rest["points"] == way["points"][-2:] and rest["next"] == way["next"],
        )
        check(
            "when it is over nothing can be done to it",
            await page.send("pause") == ["this run is over"] and not page.state["paused"],
        )
    check("it ends as without", run.process.wait(PATIENCE) == 0)
    check("and is recorded as without", read("plain.csv") == read("looked.csv"))


blind = """
import Lidar
import Robot

scans :: HasLidar i => SF i Int
scans = proc i -> accumHoldBy (\\n _ -> n + 1) 0 (lidar i :: Event (Scan 36))

main :: (HasLidar i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (if scans i > 0 then 0.3[m/s] else 0) 0))
"""
room = """
[start]
x = 2
y = 2
[[wall]]
points = [[0, 0], [4, 0], [4, 4], [0, 4]]
closed = true
[lidar]
"""


async def collisions(frobc):
    """Views a robot with a lidar that drives straight into a wall."""
    for name, text in (("blind.frob", blind), ("room.toml", room)):
        with open(path(name), "w") as file:
            file.write(text)
    options = ["--robot", "pioneer", "--world", path("room.toml"), "--for", "60s"]
    run = viewer.Run(frobc, [*options, path("blind.frob")])
    async with Page(run) as page:
        await page.until(lambda p: p.live and p.live["instants"] > 10)
        scans = [cell for *_, cell in (await page.ask("instant 10"))["recent"] if type(cell) is str]
        check(
            "an instant has the last scan",
            len(scans) == 1
            and scans[0].startswith("Scan {ranges = [")
            and scans[0].count("Just") > 9,
        )
        await page.insist("speed 100")
        await page.to_end()
        contacts = await page.ask("contacts")
        check("a collision is counted", contacts["count"] == len(contacts["all"]) == 1)
        at, x, _ = contacts["all"][0]
        check("with its time and place", 6 < at < 6.5 and 3.6 < x < 3.8)
    run.process.wait(PATIENCE)


async def full_speed(frobc, program):
    """A run at full speed has more instants than the shared memory; the viewer gets all of them."""
    run = viewer.Run(frobc, ["--for", "600s", program])
    async with Page(run) as page:
        await page.until(lambda p: p.live and p.live["instants"] > 10)
        check("a run can go at full speed", await page.insist("speed 4000") == [])
        await page.to_end()
        check("and none of its instants is missing", page.live["instants"] == 30001)
        check("nor is anything to be told", page.live["notes"] == "")
    run.process.wait()


async def commands(frobc, program):
    run = viewer.Run(frobc, ["--record", path("commands.csv"), program])
    async with Page(run) as page, Page(run) as other:
        await page.until(lambda p: p.live and p.live["instants"] > 5)
        check("a run can be paused", await page.insist("pause") == [])
        at = await page.stands()
        check("a run that is paused stands", page.state["paused"])
        check(
            "it takes single instants",
            [await page.insist("step") for _ in range(3)] == [[], [], []],
        )
        await page.until(lambda p: p.live["instants"] >= at + 3)
        check("and no others", await page.stands() == at + 3)
        check(
            "another page may not",
            await other.send("go") == ["another page is operating this run"]
            and not other.state["operates"],
        )
        await other.send("take")
        await page.until(lambda p: not p.state["operates"])
        check("unless it takes over", other.state["operates"] and await other.insist("go") == [])
        await page.until(lambda p: p.live["instants"] > at + 10)
        check("and then it goes on", not page.state["paused"])
        for speed in ("0", "0.05", "1000001", "nan", "-1", "1e9", "x"):
            if await other.send(f"speed {speed}") == []:
                check(f"speed {speed} is refused", False)
        check("speeds out of range are refused", page.state["speed"] == 1)
        check(
            "a command that was long on its way is not done, and that is said",
            await other.send("at 0 pause") == ["the request came too late and was ignored"]
            and not other.state["paused"],
        )
        await other.insist("pause")
        await other.stands()
        # While the run is paused, it takes no events. So 64 events fill the queue, which is emptied
        # only if the run's process is frozen for half a second.
        other.refused.clear()
        for _ in range(300):
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
            "at",
            "at 5",
            "at x go",
            "at nan go",
            "at 1e999 go",
        ):
            if await other.send(nonsense) == []:
                check(f"{nonsense} is refused", False)
        check("nonsense is refused", not page.state["stopping"])
        await page.socket.send("stop")
        await page.to_end()
        check("any page stops it", True)
    check("a run that is stopped ends well", run.process.wait(PATIENCE) == 0)
    check("with a summary", "time simulated:" in run.process.stdout.read())


async def events(frobc):
    """Keys pressed on a page must be in the recording, and replay."""
    run = viewer.Run(frobc, ["--robot", "pioneer", "--record", path("keys.csv"), stick])
    async with Page(run) as page:
        names = [signal["name"] for signal in page.program["signals"]]
        key, forward = names.index("in.key"), names.index("out.forward")
        await page.until(lambda p: p.live and p.live["instants"] > 5)
        taken = [await page.until_taken(f"key {ord('w')}", key) for _ in "ww"]
        await page.until(lambda p: float(p.live["newest"]["cells"][forward]) > 0.05)
        check("a program reacts to a key", None not in taken)
        await page.send("stop")
        await page.to_end()
        pressed = [
            k
            for k in range(page.live["instants"])
            if (await page.ask(f"instant {k}"))["cells"][key] != ""
        ]
        check("each key is there once", pressed == taken)
        check("and all is as traced", await as_traced(page, run, "keys.csv", stick, "pioneer"))
    run.process.wait(PATIENCE)


class Ring:
    """The memory that a run shares with its viewer (runtime/hosts/common/ring.c)."""

    def __init__(self, viewer_process):
        arguments = viewer.arguments_of(viewer_process)
        self.name = f"/proc/{viewer_process}/fd/{arguments[arguments.index('--ring') + 1]}"

    def word(self, form, offset):
        with open(self.name, "rb") as file:
            file.seek(offset)
            return struct.unpack(form, file.read(struct.calcsize(form)))[0]

    def slots(self):
        return self.word("=I", 8)

    def published(self):
        return self.word("=Q", 96)


async def gaps(frobc, program, robot, recorded):
    """Stops the viewer for so long that instants are overwritten."""
    record = ["--record", path("gap.csv")] if recorded else []
    run = viewer.Run(frobc, ["--rate", "500", *record, program])
    async with Page(run) as page:
        await page.until(lambda p: p.live and p.live["instants"] > 5)
        await page.insist("speed 20")
        ring = Ring(run.viewer)
        os.kill(run.viewer, signal.SIGSTOP)
        overwritten, end = ring.published() + 2 * ring.slots(), time.monotonic() + PATIENCE
        while ring.published() < overwritten and time.monotonic() < end:
            await asyncio.sleep(0.1)
        check("instants are overwritten", ring.published() >= overwritten)
        os.kill(run.viewer, signal.SIGCONT)
        await page.until(lambda p: p.live["instants"] > ring.slots() or p.live["notes"])
        await page.insist("speed 1")
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
                "are missing" in page.live["notes"] and instants < rate,
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
    run.process.wait(PATIENCE)


async def misfortunes(frobc, program):
    """Stops the viewer, kills it, or runs without one."""
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
        check(
            f"with a viewer that was {name} a run ends as without", run.process.wait(PATIENCE) == 0
        )
        check("and is recorded as without", read("plain.csv") == read(name + ".csv"))
        check("and leaves no viewer", not os.path.exists(f"/proc/{run.viewer}"))
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
        and "warning: this run cannot be viewed: " in gone.stderr
        and read("plain.csv") == read("never.csv"),
    )


class Robot:
    """A simulated robot behind its own line."""

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
                and "can only watch" in (await page.insist("key 119"))[0]
                and await page.send("pause") != []
                and await page.send("speed 2") != [],
            )
            await page.send("stop")
            await page.to_end()
            await page.until(lambda p: "at rest" in p.fates)
            check("which is said when it was seen to stand", page.fates[0] == "goes on")
            check("and is as traced", await as_traced(page, run, "robot.csv", stick, "pioneer"))
            check("the command stays as long as the page", run.process.poll() is None)
        check("but stopped it can be, as with Ctrl-C", run.process.wait(PATIENCE) == 4)
        check("and then its viewer is gone", not os.path.exists(f"/proc/{run.viewer}"))
    with Robot(frobc) as device:
        run = viewer.Run(frobc, [*device, stick], how="print,control")
        async with Page(run) as page:
            names = [signal["name"] for signal in page.program["signals"]]
            key, forward = names.index("in.key"), names.index("out.forward")
            await page.until(lambda p: p.live and p.live["instants"] > 5)
            check(
                "unless more is allowed", await page.until_taken(f"key {ord('w')}", key) is not None
            )
            await page.until(lambda p: float(p.live["newest"]["cells"][forward]) > 0)
            check("and then it reacts to a key", True)
            seen = page.live["instants"]
        os.kill(run.viewer, signal.SIGKILL)
        await asyncio.sleep(2)
        check("without its viewer it goes on", run.process.poll() is None)
        run.process.send_signal(signal.SIGINT)
        check("to its end", run.process.wait(PATIENCE) == 4)
        steps = re.search(r"^steps: (\d+)$", run.process.stdout.read(), re.M)
        check("with more instants than the viewer had", int(steps[1]) > seen)


async def main():
    frobc, _, program, name = sys.argv[1:]
    await values(frobc, program, name)
    await collisions(frobc)
    await full_speed(frobc, program)
    await commands(frobc, program)
    await events(frobc)
    await gaps(frobc, program, name, recorded=False)
    await gaps(frobc, program, name, recorded=True)
    await misfortunes(frobc, program)
    await robot(frobc)


if __name__ == "__main__":
    asyncio.run(main())
    sys.exit(viewer.failures > 0)
