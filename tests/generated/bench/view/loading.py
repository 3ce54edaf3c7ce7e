"""usage: loading.py FROBC

Measures how many bytes a browser loads before it can show a run: the files of the page, compressed."""

import os
import subprocess
import sys
import tempfile
import urllib.request

from figures import example, figure

import viewer


def main():
    frobc = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        recording = os.path.join(folder, "run.csv")
        program = example("wall_follow")
        subprocess.run(
            [frobc, "run", program, "--for", "1s", "--record", recording],
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
    figure("wall_follow", "bytes of the page on the wire", size / 1000, 160, "kB")


main()
