"""usage: hour.py FROBC FOLDER SECONDS

Measures the page for a recording of SECONDS, or an hour, at 50 Hz, with 40 columns: the processor
time to open it, the first time (including compilation) and again; the time to show any instant with
all signals, from the viewer and on the screen; and the memory use."""

import asyncio
import os
import random
import subprocess
import sys
import time

from figures import example, figure, memory, processor_time, quantile, scrub

import viewer
import websockets
from journey import Page, start
from protocol import connect

PROBES = (
    "ahead.front,ahead.left,ahead.right,ahead.omega,explore.mode,watching.n,sides.least,ahead.mode"
)

TEN = ";".join(
    "out.forward out.turn in.battery in.leftWheel in.rightWheel in.odometry.position.x "
    "in.odometry.position.y in.odometry.heading in.frontBumper in.leftStall".split()
)


async def ask(client, request):
    await client.send(request)
    while True:
        text = await client.recv()
        if not any(kind in text[:20] for kind in ('"progress"', '"beat"')):
            return text


async def asked(v, instants):
    """Returns the viewer's processor time when the page has received the program's description, and
    when it has received the last instant; and how long requests for other instants take."""
    async with connect(v) as client:
        await ask(client, f"hello {v.token}")
        told = processor_time(v.process.pid)
        await ask(client, f"instant {instants - 1}")
        last = processor_time(v.process.pid)
        took = []
        for _ in range(1000):
            k = random.randrange(instants)
            before = time.perf_counter()
            await ask(client, f"instant {k}")
            took.append((time.perf_counter() - before) * 1e3)
        return told, last, took


def renderer(driver):
    """The process that renders the page: the largest renderer."""
    browser = driver.service.process.pid
    parents = {}
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{pid}/stat") as file:
                parents[int(pid)] = int(file.read().rsplit(")", 1)[1].split()[1])
        except OSError:
            pass

    def is_of(pid):
        return pid == browser or (pid in parents and is_of(parents[pid]))

    def is_page(pid):
        with open(f"/proc/{pid}/cmdline") as file:
            return "--type=renderer" in file.read()

    return max((pid for pid in parents if is_of(pid) and is_page(pid)), key=memory)


def main():
    frobc, folder, seconds = sys.argv[1:]
    recording = os.path.join(folder, "hour.csv")
    program = example("explore")
    subprocess.run(
        [frobc, "run", program, "--for", f"{seconds}s", "--record", recording, "--probe", PROBES],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    with open(recording) as file:
        columns = file.readline().count(",") + 1
        instants = sum(1 for _ in file)
    hour = f"{instants} x {columns}"
    os.environ["XDG_CACHE_HOME"] = os.path.join(folder, "cache")
    subprocess.run(["rm", "-rf", os.environ["XDG_CACHE_HOME"]], check=True)
    for when, aim in ("first", 1), ("again", 0.2):
        v = viewer.Viewer(frobc, recording, program)
        address = processor_time(v.process.pid)
        told, last, took = asyncio.run(asked(v, instants))
        figure("explore", f"{hour} opened {when}: the page is there", address, aim, "s")
        figure("explore", f"{hour} opened {when}: all is read", told, aim, "s")
        figure("explore", f"{hour} opened {when}: the last instant", last, aim, "s")
        if when == "first":
            v.end()
    for name, share in ("median", 0.5), ("99 %", 0.99):
        figure("explore", f"any instant from the viewer, {name}", quantile(took, share), 5, "ms")
    driver = start(1280, 720)
    try:
        driver.set_script_timeout(10)
        for plots, what in ("out.forward;out.turn", "two plots"), (TEN, "ten plots"):
            driver.get("about:blank")
            page = Page(driver, f"{v.address}&plots={plots}")
            page.at(0)
            page.wait(lambda: len(page.all("#plots canvas")) > plots.count(";"))
            took = [driver.execute_async_script(scrub, "#now", random.random()) for _ in range(200)]
            for name, share in ("median", 0.5), ("99 %", 0.99):
                measure = f"any instant on the screen, {what}, {name}"
                figure("explore", measure, quantile(took, share), 33, "ms")
        time.sleep(10)  # give the browser time to collect garbage
        figure("explore", "memory of the viewer", memory(v.process.pid), 150, "MB")
        figure("explore", "memory of the tab", memory(renderer(driver)), 150, "MB")
    finally:
        driver.quit()
    v.end()


main()
