"""usage: loading.py FROBC

Measures how many bytes a browser loads before it can show a run: the files of the page, compressed;
and, for a run of a minute, the time from the command to the first picture, in a browser that is
open."""

import os
import subprocess
import sys
import tempfile
import time
import urllib.request

from figures import example, figure, quantile

import viewer
from journey import Page, start

TRIES = 9


def pictures(frobc, recording, program):
    """The median time until the map is drawn, after the program was compiled once."""
    driver = start(1280, 720)
    took = []
    try:
        for _ in range(TRIES + 1):
            driver.get("about:blank")
            before = time.monotonic()
            v = viewer.Viewer(frobc, recording, program)
            page = Page(driver, v.address)
            page.wait(lambda: page.text("#now").startswith("instant 0 "))
            driver.execute_async_script("requestAnimationFrame(() => arguments[0]())")
            took.append(time.monotonic() - before)
            driver.get("about:blank")
            v.end()
    finally:
        driver.quit()
    return quantile(took[1:], 0.5)


def main():
    frobc = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        recording = os.path.join(folder, "run.csv")
        program = example("wall_follow")
        subprocess.run(
            [frobc, "run", program, "--for", "60s", "--record", recording],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        v = viewer.Viewer(frobc, recording, program)
        size = 0
        for name in "", "page.css", "page.js", "icon.svg":
            request = urllib.request.Request(
                f"http://{v.host}/{name}", headers={"Accept-Encoding": "gzip"}
            )
            with urllib.request.urlopen(request) as file:
                size += len(file.read())
        v.end()
        took = pictures(frobc, recording, program)
    figure("wall_follow", "from the command to the first picture, median", took, 1, "s")
    figure("wall_follow", "bytes of the page on the wire", size / 1000, 160, "kB")


main()
