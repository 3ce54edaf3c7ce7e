"""usage: left_behind.py ROOT FROBC

Kills each command by SIGKILL, and by SIGTERM, while all of its processes run: compilers, hosts,
viewers, cameras. Sends the signal only to the process that the user started. Soon after, no other
process may remain, and a robot that was driven must stand still."""

import contextlib
import ctypes
import ctypes.util
import os
import signal
import subprocess
import sys
import tempfile
import time

ROOT, FROBC = (os.path.abspath(path) for path in sys.argv[1:3])
BUG = os.path.join(ROOT, "examples/bug/bug.frob")
DOCK = os.path.join(ROOT, "examples/dock_tag")
PATIENCE = 60  # seconds, for a busy machine; a process that is left behind never ends
ATTEMPTS = 3

failures = 0


def check(name, holds):
    global failures
    print("ok" if holds else "FAIL", name, flush=True)
    failures += not holds


def marked(mark):
    """The names of the processes that have inherited this mark, by process id."""
    found = {}
    for number in os.listdir("/proc"):
        with contextlib.suppress(OSError):
            if number.isdigit():
                with open(f"/proc/{number}/environ", "rb") as file:
                    if f"FROB_MARK={mark}".encode() in file.read().split(b"\0"):
                        with open(f"/proc/{number}/comm") as name:
                            found[int(number)] = name.read().strip()
    return found


def until(condition):
    end = time.monotonic() + PATIENCE
    while not condition() and time.monotonic() < end:
        time.sleep(0.05)
    return condition()


class Started:
    """A command in its own folder. It counts as running when processes of these names exist."""

    def __init__(self, name, how, awaited, command, **environment):
        self.name, self.how, self.awaited = name, how, list(awaited)
        self.mark = f"{os.getpid()}-{how.name}-{name.replace(' ', '-')}"
        self.folder = os.path.join(os.getcwd(), self.mark)
        self.command, self.environment = command, environment
        os.mkdir(self.folder)
        self.start()

    def start(self):
        with open(os.path.join(self.folder, "said"), "w") as said:
            self.process = subprocess.Popen(
                self.command,
                cwd=self.folder,
                stdin=subprocess.DEVNULL,
                stdout=said,
                stderr=said,
                start_new_session=True,
                env={**os.environ, **self.environment, "FROB_MARK": self.mark},
            )

    def runs(self):
        names = list(marked(self.mark).values())
        return all(names.count(name) >= self.awaited.count(name) for name in self.awaited)

    def said(self):
        with open(os.path.join(self.folder, "said")) as file:
            return file.read()

    def until_it_runs(self):
        """Whether all processes of the command run at the same time at some point. On a busy
        machine, a run may end before that, because the robot or the controller is too slow. Then
        the command starts again."""
        for _ in range(ATTEMPTS):
            if until(lambda: self.runs() or self.process.poll() is not None) and self.runs():
                return True
            if self.process.poll() is None:
                return False
            print(self.name, "ended by itself:", self.said())
            self.start()
        return False

    def judge(self):
        it_ran = self.until_it_runs()
        if not it_ran:
            print(self.name, "ran not:", marked(self.mark), self.said())
        self.process.send_signal(self.how)
        self.process.wait(PATIENCE)
        is_alone = until(lambda: not marked(self.mark))
        if not is_alone:
            print(self.name, "left:", marked(self.mark))
        check(f"{self.how.name} of {self.name}", it_ran and is_alone)


# A slow compiler, which starts a child process.
SLOW = "#!/bin/sh\nsleep 600; exit 1\n"

TRIAL = """import Robot
import Trial
import WallFollow

main :: (HasSonar i, DiffDrive o) => Program i o
main = reactimateRobot (wallFollow1 (gap / 1))

param gap :: Distance = 0.3[m]

trial "is long" = Trial { world = "room.toml", lasts = 100000[s], seeds = 1 `to` 50, judge = neverTouches }
"""

PLAN = """program = "trial.frob"
robots = ["pioneer"]
[params]
gap = ["0.2[m]", "0.3[m]"]
"""

FALSIFIED = """import Robot
import WallFollow

main :: (HasSonar i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> wallFollow1 0.3[m] i where
    assert "is there" (frontSonar i > -1[m]))
"""

DRIVES = """import Robot

main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[m/s] 0))
"""


def file(name, text, mode=0o644):
    path = os.path.abspath(name)
    with open(path, "w") as out:
        out.write(text)
    os.chmod(path, mode)
    return path


def fifo(name):
    """A pipe that has a writer but never any data."""
    os.mkfifo(name)
    os.open(name, os.O_RDWR)
    return os.path.abspath(name)


def serve(robot, *options):
    served = subprocess.Popen(
        [FROBC, "serve", "--robot", robot, "--tcp", "0", *options],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    lines = [served.stdout.readline() for _ in range(1 + options.count("--camera"))]
    return served, [line.split(": ", 1)[1].strip() for line in lines]


def commands(how):
    trial, plan = file("trial.frob", TRIAL), file("plan.toml", PLAN)
    slow = file("slow_cc", SLOW, 0o755)
    path = {"PATH": "/usr/bin:" + os.environ["PATH"]}  # Debian's Python, for its packages
    python = {"PYTHONPATH": os.path.join(ROOT, "runtime/python"), "FROBC": FROBC}
    run = [FROBC, "run", BUG, "--robot", "pioneer", "--realtime"]
    yield "run", ["frob-sim"], run, {}
    yield "run with a page", ["frob-sim", "frob-view"], [*run, "--view=print"], {}
    yield "run with a packed record", ["frob-sim", "gzip"], [*run, "--record", "r.csv.gz"], {}
    yield (
        "view",
        ["frob-view"],
        [FROBC, "view", "--print", "--robot", "pioneer", os.path.abspath("bug.csv"), BUG],
        {},
    )
    yield "test", ["frob-sim"], [FROBC, "test", trial, "--robot", "pioneer", "-j", "1"], {}
    yield "sweep", ["frob-sim"], [FROBC, "sweep", plan, "--rows", "rows", "-j", "1"], {}
    if (
        subprocess.run(
            ["python3", "-c", "import numpy"], env=path, stderr=subprocess.DEVNULL
        ).returncode
        == 0
    ):
        yield (
            "falsify",
            ["python3"],
            [
                FROBC,
                "falsify",
                file("falsified.frob", FALSIFIED),
                "--robot",
                "pioneer",
                "--runs",
                "1000000",
                "--for",
                "1000s",
                "--method",
                "random",
                "--seeds",
                "1 to 9",
            ],
            {**python, **path},
        )
    yield "serve", ["frob-serve"], [FROBC, "serve", "--robot", "create"], {}
    waits = fifo(f"waits{how.name}.csv")
    yield "trace", ["frob-trace"], [FROBC, "trace", BUG, "--robot", "pioneer", "--input", waits], {}
    yield (
        "trace with a picture",
        ["frobc", "frob-trace"],
        [FROBC, "trace", BUG, "--robot", "pioneer", "--input", waits, "--picture", "p.svg"],
        {},
    )
    yield (
        "trace of the interpreter",
        ["frobc"],
        [FROBC, "trace", BUG, "--robot", "pioneer", "--input", waits, "--engine", "interp"],
        {},
    )
    yield (
        "trace of a packed recording",
        ["frob-trace", "gzip"],
        [FROBC, "trace", BUG, "--robot", "pioneer", "--input", fifo(f"waits{how.name}.csv.gz")],
        {},
    )
    yield "build", ["slow_cc", "sleep"], [FROBC, "build", trial, "--robot", "pioneer"], {"CC": slow}
    yield (
        "Python's frob.compile",
        ["frobc", "slow_cc", "sleep"],
        [sys.executable, "-c", f"import frob; frob.compile({BUG!r}, robot='pioneer')"],
        {**python, "CC": slow},
    )


def robots(how):
    """Programs that drive served robots, one with a camera, tags and a page."""
    drives = file("drives.frob", DRIVES)
    for robot in ("pioneer", "scout", "create"):
        log = os.path.abspath(f"{robot}-{how.name}.log")
        served, [device] = serve(robot, "--log", log)
        yield (
            Started(
                f"run on the {robot}",
                how,
                [],
                [
                    FROBC,
                    "run",
                    drives,
                    "--robot",
                    robot,
                    "--device",
                    device,
                    "--view=print",
                    "--patience",
                    "2s",
                ],
            ),
            served,
            log,
        )
    if ctypes.util.find_library("apriltag"):
        served, [device, camera] = serve(
            "pioneer", "--world", f"{DOCK}/world.toml", "--camera", "0"
        )
        yield (
            Started(
                "run with tags",
                how,
                [],
                [
                    FROBC,
                    "run",
                    f"{DOCK}/dock_tag.frob",
                    "--device",
                    device,
                    "--camera",
                    camera,
                    "--view=print",
                    "--record",
                    "seen.csv",
                ],
            ),
            served,
            None,
        )


def speeds(log):
    with open(log) as lines:
        words = [line.split()[1:] for line in lines]
    return [w for w in words if w and w[0] in ("VEL", "VM", "DRIVE_DIRECT", "STOP", "ST")]


def judge_robots(how):
    for started, served, log in list(robots(how)):
        # The supervisor, its controller, two guards and the viewer; with tags three processes for a
        # camera, too.
        count = 5 if log else 8
        started.runs = lambda s=started, n=count: len(marked(s.mark)) >= n and (
            log is None or os.path.getsize(log) > 0 and moves(log)
        )
        started.judge()
        if log:
            check(f"{how.name}: {started.name.split()[-1]} stands", until(lambda: not moves(log)))
        served.terminate()
        served.wait(PATIENCE)


def moves(log):
    """Whether the last speed command to the robot is not zero."""
    told = speeds(log)
    return bool(told) and any(word.strip("-").isdigit() and int(word) != 0 for word in told[-1][1:])


def viewer_ends_by_itself():
    """The viewer of a killed run ends normally, not because of the alarm that limits the time to
    end. This process receives its exit status, because it becomes the viewer's parent when the
    original parent has ended."""
    PR_SET_CHILD_SUBREAPER = 36
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    run = [FROBC, "run", BUG, "--robot", "pioneer", "--realtime", "--view=print"]
    started = Started("run that is killed", signal.SIGKILL, ["frob-sim", "frob-view"], run)
    until(lambda: started.runs() and "view: " in started.said())
    viewer = next(pid for pid, name in marked(started.mark).items() if name == "frob-view")
    started.process.kill()
    started.process.wait(PATIENCE)
    _, status = os.waitpid(viewer, 0)
    check("the viewer of a killed run ends by itself", os.WIFEXITED(status))
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 0, 0, 0, 0)


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        subprocess.run(
            [FROBC, "run", BUG, "--robot", "pioneer", "--for", "1s", "--record", "bug.csv"],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        for how in (signal.SIGKILL, signal.SIGTERM):
            for started in [
                Started(name, how, awaited, command, **environment)
                for name, awaited, command, environment in commands(how)
            ]:
                started.judge()
            judge_robots(how)
        viewer_ends_by_itself()
        os.chdir("/")


if __name__ == "__main__":
    main()
    sys.exit(failures > 0)
