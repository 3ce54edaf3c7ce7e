"""usage: sees.py FROBC FOLDER

Measures a recording of a program with a camera, which draws marks on the image: the time to get the
frame of any instant with its marks, from the viewer and on the screen."""

import asyncio
import os
import random
import subprocess
import sys
import time

from figures import example, figure, processor_time, quantile, scrub

import viewer
from journey import Page, start
from protocol import connect

INSTANTS = 1000


def tell(measure, took, aim):
    for name, share in ("median", 0.5), ("99 %", 0.99):
        figure("follow_ball", f"{measure}, {name}", quantile(took, share), aim, "ms")


async def answered(v):
    """Times requests for frames of 320 by 240 pixels. The first one does not count, because it
    waits until the recording has been read.
    """
    async with connect(v) as client:
        await client.send(f"hello {v.token}")
        took, begun = [], 0
        for k in [INSTANTS - 1] + [random.randrange(9, INSTANTS) for _ in range(500)]:
            before = time.perf_counter()
            await client.send(f"picture {k} 320 0")
            while not isinstance(answer := await client.recv(), bytes):
                pass
            took.append((time.perf_counter() - before) * 1e3)
            assert len(answer) > 320 * 240 * 3
            begun = begun or processor_time(v.process.pid)
        return took[1:], 1e3 * (processor_time(v.process.pid) - begun) / len(took[1:])


def on_screen(v):
    driver = start(1280, 720)
    try:
        page = Page(driver, v.address)
        page.at(0)
        driver.set_script_timeout(10)
        # alternate, so that each request is for a different frame
        return [
            driver.execute_async_script(scrub, "#camera p", (k % 2 + random.random()) / 2)
            for k in range(200)
        ]
    finally:
        driver.quit()


def main():
    frobc, folder = sys.argv[1:]
    recording = os.path.join(folder, "seen.csv")
    program = example("follow_ball")
    subprocess.run(
        [frobc, "run", program, "--for", f"{INSTANTS / 50}s", "--record", recording],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    v = viewer.Viewer(frobc, recording, program)
    took, worked = asyncio.run(answered(v))
    figure("follow_ball", "the image of any instant, the viewer's processor time", worked, 5, "ms")
    tell("the image of any instant from the viewer", took, 5)
    tell("the image of any instant on the screen", on_screen(v), 33)
    v.end()


main()
