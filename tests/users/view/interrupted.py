"""usage: interrupted.py FROBC RUN.csv FILE ROBOT

Checks that a test of the page leaves no process running when it is killed."""

import os
import signal
import subprocess
import sys
import time

import viewer
from viewer import check


def is_running(pid):
    try:
        with open(f"/proc/{pid}/stat") as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def started():
    """Starts a test's viewer; the test then waits to be killed."""
    frobc, recording, program, _ = sys.argv[1:5]
    print(viewer.Viewer(frobc, recording, program).process.pid, flush=True)
    time.sleep(60)


def main():
    for how in (signal.SIGKILL, signal.SIGTERM, signal.SIGINT):
        test = subprocess.Popen(
            [sys.executable, "-B", __file__, *sys.argv[1:5], "start"],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        pid = int(test.stdout.readline())
        there = is_running(pid)
        os.kill(test.pid, how)
        test.wait()
        for _ in range(100):
            if not is_running(pid):
                break
            time.sleep(0.1)
        check(f"a test that gets {how.name} leaves no viewer", there and not is_running(pid))


if __name__ == "__main__":
    if sys.argv[5:] == ["start"]:
        started()
    else:
        main()
        sys.exit(viewer.failures > 0)
