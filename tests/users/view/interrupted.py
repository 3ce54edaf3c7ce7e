"""usage: interrupted.py FROBC RUN.csv FILE ROBOT

Checks that a test of the page leaves no process running when it is killed, and that the address of
a live run that nobody opens in time stays valid if somebody can read it in a terminal."""

import os
import pty
import re
import signal
import subprocess
import sys
import time
import urllib.request

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


def forgotten():
    """In a terminal, runs a program that ends before a browser opens its page."""
    frobc, _, program, robot = sys.argv[1:5]
    ours, theirs = pty.openpty()
    run = subprocess.Popen(
        [frobc, "run", "--robot", robot, "--view", "--print", "--for", "100ms", program],
        stdout=theirs,
        stderr=theirs,
        start_new_session=True,
    )
    keeper = viewer.guard(run.pid)
    os.close(theirs)
    text = ""
    while "The run is over." not in text:
        text += os.read(ours, 1000).decode()
    address = re.search(r"view: (http://[^#]*)", text)[1]
    time.sleep(6)  # longer than a viewer waits without a terminal
    with urllib.request.urlopen(address) as page:
        check("a page that nobody opened in time can be opened later", page.status == 200)
    run.send_signal(signal.SIGINT)
    run.wait()
    check("until the run is interrupted", not is_running(run.pid))
    viewer.dismiss(keeper)


if __name__ == "__main__":
    if sys.argv[5:] == ["start"]:
        started()
    else:
        main()
        forgotten()
        sys.exit(viewer.failures > 0)
