"""Starts `frobc view`, or `frobc run --view`, for a test, and ends it again."""

import atexit
import csv
import os
import re
import signal
import subprocess
import tempfile

# Isolate the state that pages keep for the next run of a program, so that tests do not affect each
# other.
state = tempfile.TemporaryDirectory()
os.environ["XDG_STATE_HOME"] = state.name


def guard(group):
    """Starts a process that ends a process group when this process has ended, for whatever reason.
    Returns it, for `dismiss`."""
    command = 'read told || kill -KILL "-$0"'
    return subprocess.Popen(
        ["sh", "-c", command, str(group)],
        stdin=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )


def dismiss(guard):
    """Ends the guard, because there is nothing left for it to end."""
    guard.communicate(b"\n")


class Process:
    """A process that prints the address of a page in its first line."""

    def __init__(self, command):
        self.process = subprocess.Popen(
            command, stdout=subprocess.PIPE, text=True, start_new_session=True
        )
        self.guard = guard(self.process.pid)
        atexit.register(self.kill)
        line = self.process.stdout.readline()
        match = re.match(r"view: (http://(127\.0\.0\.1:(\d+))/#([0-9a-f]{32}))", line)
        self.address, self.host, port, self.token = match.groups()
        self.port = int(port)

    def kill(self):
        """Kills the process and all that it has started."""
        atexit.unregister(self.kill)
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        dismiss(self.guard)


class Viewer(Process):
    """The viewer of a recording."""

    def __init__(self, frobc, recording, program, *options):
        super().__init__([frobc, "view", "--print", *options, recording, program])
        self.frobc = frobc

    def end(self):
        self.process.terminate()
        return self.process.wait(timeout=10)


class Run(Process):
    """The viewer of a live run."""

    def __init__(self, frobc, arguments, how="print"):
        super().__init__([frobc, "run", f"--view={how}", *arguments])
        self.frobc = frobc
        self.host_process = self.host_of(self.process.pid)
        self.viewer = next(
            pid for pid in children(self.host_process) if name_of(pid) == "frob-view"
        )

    @staticmethod
    def host_of(pid):
        """Returns the host's process: frobc starts the simulator as a child, but a program for a
        real robot replaces frobc.
        """
        return next((child for child in children(pid) if name_of(child) == "frob-sim"), pid)


def children(pid):
    with open(f"/proc/{pid}/task/{pid}/children") as file:
        return [int(child) for child in file.read().split()]


def name_of(pid):
    with open(f"/proc/{pid}/comm") as file:
        return file.read().strip()


def arguments_of(pid):
    with open(f"/proc/{pid}/cmdline") as file:
        return file.read().split("\0")[1:-1]


def trace(frobc, recording, program, robot, *params):
    """Returns the output of `frobc trace` for each instant: a dictionary by column."""
    settings = [word for setting in params for word in ("--param", setting)]
    rows = subprocess.run(
        [
            frobc,
            "trace",
            "--modes",
            "--probe",
            "all",
            "--robot",
            robot,
            "--input",
            recording,
            *settings,
            program,
        ],
        check=True,
        stdout=subprocess.PIPE,
        text=True,
    ).stdout.splitlines()
    with open(recording, newline="") as file:
        lines = (line for line in file if not line.startswith("#"))
        return [
            dict(recorded, **computed)
            for recorded, computed in zip(csv.DictReader(lines), csv.DictReader(rows))
        ]


failures = 0


def check(name, holds):
    global failures
    print("ok" if holds else "FAIL", name, flush=True)
    failures += not holds
