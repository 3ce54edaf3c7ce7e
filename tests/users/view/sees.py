"""usage: sees.py FROBC RUN.csv FILE ROBOT

A program that looks through a camera is looked at while it runs, and afterwards: both see
what it saw, and each signal is as `frobc trace` says."""

import asyncio
import subprocess
import sys

import live
import viewer
from viewer import check

follow = "../../../examples/follow_ball/follow_ball.frob"
camera = "in.console.camera"


async def while_it_runs(frobc):
    arguments = ["--for", "4s", "--record"]
    subprocess.run([frobc, "run", *arguments, live.path("plain.csv"), follow], check=True,
                   stdout=subprocess.DEVNULL)
    run = viewer.Run(frobc, [*arguments, live.path("seen.csv"), follow])
    async with live.Page(run) as page:
        await page.until(lambda p: p.live and p.live["instants"] > 5)
        await page.send("speed 100")
        await page.to_end()
        names = [signal["name"] for signal in page.program["signals"]]
        cells = [(await page.ask(f"instant {k}"))["cells"][names.index(camera)]
                 for k in range(0, 40)]
        check("frames are named as they come", any("Image" in cell for cell in cells)
              and "" in cells)
        check("its instants are as traced",
              await live.as_traced(page, run, "seen.csv", follow, "pioneer"))
    check("it ends as without", run.process.wait(10) == 0)
    check("and is recorded as without", live.read("plain.csv") == live.read("seen.csv"))


async def afterwards(frobc):
    shown = viewer.Viewer(frobc, live.path("plain.csv"), follow)
    async with live.Page(shown) as page:
        names = [signal["name"] for signal in page.program["signals"]]
        rows = viewer.trace(frobc, live.path("plain.csv"), follow, "pioneer")
        differing = 0
        for k in range(0, len(rows), 7):
            instant = await page.ask(f"instant {k}")
            differing += instant["cells"] != [rows[k][name] for name in names]
        check("a recording is as traced", differing == 0)


async def main(frobc):
    await while_it_runs(frobc)
    await afterwards(frobc)


asyncio.run(main(sys.argv[1]))
sys.exit(viewer.failures > 0)
