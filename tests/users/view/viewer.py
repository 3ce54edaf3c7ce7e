"""Starts `frobc view` for a test, and ends it again."""

import atexit
import csv
import re
import subprocess


class Viewer:
    def __init__(self, frobc, recording, program):
        self.process = subprocess.Popen(
            [frobc, "view", "--print", recording, program], stdout=subprocess.PIPE, text=True
        )
        atexit.register(self.end)
        line = self.process.stdout.readline()
        match = re.match(r"view: (http://(127\.0\.0\.1:(\d+))/#([0-9a-f]{32})) ", line)
        self.address, self.host, port, self.token = match.groups()
        self.port = int(port)

    def end(self):
        self.process.terminate()
        return self.process.wait(timeout=10)


def trace(frobc, recording, program, robot):
    """What `frobc trace` says of each instant: a dictionary by column."""
    rows = subprocess.run(
        [frobc, "trace", "--modes", "--probe", "all", "--robot", robot, "--input", recording,
         program],
        check=True, stdout=subprocess.PIPE, text=True,
    ).stdout.splitlines()
    with open(recording, newline="") as file:
        return [dict(recorded, **computed)
                for recorded, computed in zip(csv.DictReader(file), csv.DictReader(rows))]


failures = 0


def check(name, holds):
    global failures
    print("ok" if holds else "FAIL", name, flush=True)
    failures += not holds
