"""usage: sees.py FROBC RUN.csv FILE ROBOT

Views a program with a camera during a run and afterwards. Both views must show the frames that it
saw, and each signal must be as in `frobc trace`. The image must be the frame of the instant, with
its marks; a missing or changed frame must be reported."""

import asyncio
import glob
import os
import re
import shutil
import subprocess
import sys

import live
import viewer
from viewer import check

follow = "../../../examples/follow_ball/follow_ball.frob"
camera = "in.console.camera"


async def while_it_runs(frobc):
    arguments = ["--for", "4s", "--record"]
    subprocess.run(
        [frobc, "run", *arguments, live.path("plain.csv"), follow],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    run = viewer.Run(frobc, [*arguments, live.path("seen.csv"), follow])
    async with live.Page(run) as page:
        await page.until(lambda p: p.live and p.live["instants"] > 5)
        await page.insist("speed 100")
        await page.to_end()
        names = [signal["name"] for signal in page.program["signals"]]
        cells = [
            (await page.ask(f"instant {k}"))["cells"][names.index(camera)] for k in range(0, 40)
        ]
        check(
            "frames are named as they come", any("Image" in cell for cell in cells) and "" in cells
        )
        check(
            "its instants are as traced",
            await live.as_traced(page, run, "seen.csv", follow, "pioneer"),
        )
    check("it ends as without", run.process.wait(live.PATIENCE) == 0)
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


def frame_file(recording, number):
    return glob.glob(live.path(f"{recording}.frames/{number:06d}-*.ppm"))[0]


def pixels_of(path):
    """Reads a PPM file: its width, its height, and its pixels."""
    with open(path, "rb") as file:
        lines = [line for line in iter(file.readline, b"255\n") if line[0:1] not in b"P#"]
        return *map(int, lines[0].split()), file.read()


def smaller(width, height, pixels, by):
    """Shrinks a picture: each pixel is the mean of `by` times `by`."""
    rows = []
    for y in range(0, height - by + 1, by):
        for x in range(0, width - by + 1, by):
            for c in range(3):
                total = sum(
                    pixels[3 * ((y + v) * width + x + u) + c] for v in range(by) for u in range(by)
                )
                rows.append((total + by * by // 2) // (by * by))
    return bytes(rows)


async def pictures(frobc):
    """Checks the displayed image: the frame, and the marks of the instant that showed it."""
    shown = viewer.Viewer(frobc, live.path("plain.csv"), follow)
    rows = viewer.trace(frobc, live.path("plain.csv"), follow, "pioneer")
    drawn = [
        [cell for name, cell in row.items() if re.match(r"probe\.draw\[", name) and cell]
        for row in rows
    ]
    async with live.Page(shown) as page:
        check("the program sees", page.program["sees"])
        differing = 0
        for k in range(3, len(rows), 23):
            at = max(j for j in range(k + 1) if any("Picture" in mark for mark in drawn[j]))
            picture = await page.ask(f"picture {k} 4096 0")
            width, height, pixels = pixels_of(frame_file("plain", picture["number"]))
            differing += (
                (picture["at"], picture["chosen"]) != (at, True)
                or picture["marks"] != [mark for mark in drawn[at] if "InImage" in mark]
                or f"Image {picture['number']} " not in rows[at][camera]
                or (picture["width"], picture["height"], picture["columns"])
                != (width, height, width)
                or picture["pixels"] != pixels
            )
        check("pictures and their marks are those of the instant", differing == 0)
        picture = await page.ask("picture 100 110 0")
        width, height, pixels = pixels_of(frame_file("plain", picture["number"]))
        check(
            "a smaller one is the mean of pixels",
            (picture["by"], picture["columns"], picture["rows"]) == (3, 106, 80)
            and picture["pixels"] == smaller(width, height, pixels, 3),
        )
        again = await page.ask(f"picture 100 110 {picture['at'] + 1}")
        check(
            "what the page has is not sent again",
            again["pixels"] == b"" and again["marks"] == picture["marks"],
        )
        check("before the first frame there is none", "at" not in await page.ask("picture 0 320 0"))
        newest = await page.ask("picture newest 320 0")
        check("the newest can be asked for", newest["k"] == len(rows) - 1)
        for wrong in (
            "picture",
            "picture 0",
            "picture 0 320",
            "picture 0 0 0",
            "picture 0 5000 0",
            "picture newest",
            "picture 99999 320 0",
            "picture -1 320 0",
            "picture 0 320 0 0",
        ):
            await page.socket.send(wrong)
            page.refused.clear()
            await page.answer("refused")
            check(f"`{wrong}` is refused", len(page.refused) == 1)


def copy(name):
    shutil.copy(live.path("plain.csv"), live.path(f"{name}.csv"))
    shutil.copytree(live.path("plain.frames"), live.path(f"{name}.frames"))


async def without(frobc):
    """A missing or changed frame is reported; the other frames are available."""
    copy("missing")
    os.remove(frame_file("missing", 40))
    copy("changed")
    with open(frame_file("changed", 40), "r+b") as file:
        file.seek(20000)
        file.write(b"another")
    with open(frame_file("changed", 80), "r+b") as file:
        file.seek(30000)
        file.write(b"another")
    rows = viewer.trace(frobc, live.path("plain.csv"), follow, "pioneer")
    at, later = (
        next(k for k, row in enumerate(rows) if f"Image {number} " in row[camera])
        for number in (40, 80)
    )
    for name, says in (("missing", "is not available ("), ("changed", "is not the recorded frame")):
        shown = viewer.Viewer(frobc, live.path(f"{name}.csv"), follow)
        async with live.Page(shown) as page:
            notes = (await page.ask(f"instant {at}")) and (await page.ask("program"))["notes"]
            check(f"{name}: it is told", f"frame 40 at instant {at} {says}" in notes)
            lost = await page.ask(f"picture {at} 320 0")
            check(
                f"{name}: and shown in its place",
                lost["lost"] == {"number": 40, "k": at, "changed": name == "changed"},
            )
            before, after = [await page.ask(f"picture {k} 320 0") for k in (at - 1, at + 4)]
            check(
                f"{name}: the frames before and after are there",
                before["number"] < 40 < after["number"]
                and before["chosen"]
                and not after["chosen"]
                and len(after["pixels"]) == 3 * 320 * 240,
            )
            names = [signal["name"] for signal in page.program["signals"]]
            cells = (await page.ask(f"instant {at + 4}"))["cells"]
            recorded = {
                name: cell for name, cell in rows[at + 4].items() if name.startswith("out.")
            }
            check(
                f"{name}: so is all that was recorded after it",
                all(cells[names.index(name)] == cell for name, cell in recorded.items()),
            )
            if name == "changed":
                lost = await page.ask(f"picture {later} 320 0")
                check("a second one is seen to be changed too", lost["lost"]["number"] == 80)


async def main(frobc):
    await while_it_runs(frobc)
    await afterwards(frobc)
    await pictures(frobc)
    await without(frobc)


asyncio.run(main(sys.argv[1]))
sys.exit(viewer.failures > 0)
