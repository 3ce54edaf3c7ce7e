"""Measures the response times of the language server: python3 latency.py FOLDER COUNT"""

import json
import random
import re
import sys
import time

from client import Client

folder, count = sys.argv[1], int(sys.argv[2])
rng = random.Random(1)
client = Client(folder)
uri = client.open("lines_2000.frob")
client.told(uri)
original = client.texts[uri][0]
numbers = [m for m in re.finditer(r"\d+\.\d+", original)]
lines = original.split("\n")


def position(offset):
    before = original[:offset]
    return {"line": before.count("\n"), "character": offset - before.rfind("\n") - 1}


def processor():
    """Processor time that the server has used, in seconds; Linux only."""
    with open("/proc/%d/schedstat" % client.process.pid) as file:
        return int(file.read().split()[0]) * 1e-9


changes, hovers, work, hover_work = [], [], [], []
for k in range(count):
    m = rng.choice(numbers)
    start, stop = position(m.start()), position(m.end())
    new = "1.5" if k % 2 else "1.5 +"  # every second change breaks the program
    begin, before = time.perf_counter(), processor()
    client.edit(uri, {"start": start, "end": stop}, new)
    client.told(uri)
    changes.append(time.perf_counter() - begin)
    work.append(processor() - before)
    stop = {"line": start["line"], "character": start["character"] + len(new)}
    at = position(rng.choice(numbers).start())
    begin, before = time.perf_counter(), processor()
    client.ask_all("hover", uri, position=at)
    hovers.append(time.perf_counter() - begin)
    hover_work.append(processor() - before)
    client.edit(uri, {"start": start, "end": stop}, m.group())
    client.told(uri)
client.end()


def tell(measure, times, aim):
    p95 = 1000 * sorted(times)[int(0.95 * len(times))]
    print(
        json.dumps(
            {
                "program": "lines_2000",
                "measure": measure,
                "compiler": "frobc lsp",
                "value": round(p95, 1),
                "reference": aim,
                "ratio": round(p95 / aim, 3),
                "unit": "ms",
            }
        )
    )


tell("change to messages, 95 %", changes, 100)
tell("of that processor, 95 %", work, 100)
tell("hover, 95 %", hovers, 10)
tell("of that processor, 95 %", hover_work, 10)
