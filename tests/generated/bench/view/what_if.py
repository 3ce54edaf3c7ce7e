"""usage: what_if.py FROBC FOLDER COUNT

Measures the processor time of a what-if that changes a constant of the wall follower: compiling,
running on the inputs of a minute, and comparing. Each time the constant has a new value."""

import asyncio
import json
import os
import random
import subprocess
import sys

from figures import example, figure, processor_time

import viewer
from protocol import ask, connect, greet


async def tries(v, text, count):
    took = []
    async with connect(v) as client:
        await greet(v, client)
        for _ in range(count):
            edited = text.replace("kFront = 1.2[1/s]", f"kFront = {random.uniform(1, 2)!r}[1/s]")
            before = processor_time(v.process.pid)
            answer = await ask(client, f"what-if {edited}")
            took.append(processor_time(v.process.pid) - before)
            if not answer["there"]:
                sys.exit(json.dumps(answer))
    return took


def main():
    frobc, folder, count = sys.argv[1], sys.argv[2], int(sys.argv[3])
    recording, program = os.path.join(folder, "minute.csv"), example("wall_follow")
    os.environ["XDG_CACHE_HOME"] = os.path.join(folder, "cache")
    subprocess.run(
        [frobc, "run", program, "--for", "60s", "--record", recording],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    with open(program) as file:
        text = file.read()
    v = viewer.Viewer(frobc, recording, program)
    took = asyncio.run(tries(v, text, count))
    v.end()
    figure("wall_follow", "what if, on a minute", sum(took) / count, 0.3, "s")


main()
