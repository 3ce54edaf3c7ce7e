"""usage: kills.py FROBC COUNT SEED

Programs drive the three served robots. COUNT times on each, processes of the run are killed with
SIGKILL: the supervisor, the controller, a guard, or two of them, in random order, simultaneously or
up to 0.15 s apart. In every case the robot must receive the stop command in time, and no process
may remain; if only guards are killed, the run must continue with new guards.

The times of commands come from the robot's log. Where the system permits it, the run and the robot
have real-time priority, so that other work on the machine does not delay them. They still wait: for
a processor, which the kernel reports for each process, and for the kernel's own thread that carries
bytes through a pseudo-terminal, which a canary measures. The test subtracts these waits from the
delay of the stop command. If they are longer than the delay that is allowed, the machine is too busy
to judge the delay, and the test counts this. It always checks that the stop command arrives."""

import contextlib
import os
import random
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time

FROBC, COUNT, SEED = os.path.abspath(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
HALL = os.path.abspath("../robot/hall.toml")
STATED = 0.1  # seconds from the last kill until the stop command, or until guards are back
PATIENCE = 30  # timeout in seconds for events that must happen, however busy the machine is
LOOK = 0.005
BUSY = STATED  # if processes wait longer for a processor, in seconds, the delay is not judged

# The robot drives in circles, so that it meets no obstacle.
DRIVES = """import Robot
main = reactimateRobot (proc _ -> roMake (setVelTR 0.1[m/s] 0.5[rad/s]))
"""

# Starts a command with real-time priority.
PRIORITY = ["chrt", "-r", "1"]
if subprocess.run([*PRIORITY, "true"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
    PRIORITY = []

# Sends a byte through a pseudo-terminal every 5 ms. Writes the time of the last byte to one file.
# If a byte took much longer, writes the start and end of the delay to another file. Ends when its
# standard input does.
CANARY = """
import os, select, struct, sys, time, tty
near, far = os.openpty()
tty.setraw(far)
with open(sys.argv[1], "a", buffering=1) as file, open(sys.argv[2], "wb", buffering=0) as last:
    before = time.monotonic()
    while not select.select([0], [], [], 0.005)[0]:
        os.write(far, b"x")
        os.read(near, 1)
        now = time.monotonic()
        if now - before > 0.015:
            print(before, now, file=file)
        os.pwrite(last.fileno(), struct.pack("d", now), 0)
        before = now
"""

MOTION = ("VEL", "VM", "DRIVE_DIRECT", "STOP", "ST")
failures = []


def moves(words):
    """Whether a speed command of the log has a speed other than zero."""
    return any(word.strip("-").isdigit() and int(word) for word in words[2:])


def session(process):
    try:
        return os.getsid(process)
    except ProcessLookupError:
        return None


class Run:
    """A run of the program on a robot. Its processes are recognized by an inherited mark."""

    def __init__(self, robot, number):
        self.robot, self.mark = robot, f"{os.getpid()}-{robot.kind}-{number}"
        self.told_from = len(robot.log())
        self.messages = open(f"{self.mark}.messages", "w+")
        self.process = subprocess.Popen(
            [*PRIORITY, robot.program, "--device", robot.device, "--patience", "0.4"],
            stdout=subprocess.DEVNULL,
            stderr=self.messages,
            start_new_session=True,
            env={**os.environ, "FROB_MARK": self.mark},
        )

    def processes(self):
        found = []
        for number in os.listdir("/proc"):
            with contextlib.suppress(OSError):
                if number.isdigit():
                    with open(f"/proc/{number}/environ", "rb") as file:
                        if f"FROB_MARK={self.mark}".encode() in file.read().split(b"\0"):
                            found.append(int(number))
        return found

    def guards(self):
        """The guards, which lead their own sessions."""
        return [p for p in self.processes() if p != self.process.pid and session(p) == p]

    def controller(self):
        return next(p for p in self.processes() if session(p) != p)

    def log(self):
        return [line.split() for line in self.robot.log()[self.told_from :]]

    def told(self):
        """Returns the speed commands: the time, and whether any speed is not zero."""
        return [
            (float(words[0]), moves(words))
            for words in self.log()
            if len(words) > 1 and words[1] in MOTION
        ]

    def driven_by_nobody(self):
        """Whether the robot's own watchdog had to stop it."""
        drives = False
        for words in self.log():
            if len(words) > 1 and words[1] in MOTION:
                drives = moves(words)
            elif "watchdog" in words and drives:
                return True
        return False

    def drives(self):
        return any(moves for _, moves in self.told()[-3:])

    def guards_lost(self):
        return self.said().count("starting another one")

    def said(self):
        self.messages.seek(0)
        return self.messages.read()


class Canary:
    """Measures when the machine stood still."""

    def __init__(self):
        self.path, self.last = os.path.abspath("stalls"), os.path.abspath("last")
        self.process = subprocess.Popen(
            [*PRIORITY, sys.executable, "-c", CANARY, self.path, self.last], stdin=subprocess.PIPE
        )
        until(lambda: os.path.exists(self.last))

    def knows(self, end):
        with open(self.last, "rb") as file:
            word = file.read()
        return len(word) == 8 and struct.unpack("d", word)[0] >= end

    def stalls(self, begin, end):
        """Seconds between these two times in which no byte got through."""
        until(lambda: self.knows(end))
        total = 0.0
        with open(self.path) as file:
            for line in file.read().split("\n")[:-1]:
                first, last = map(float, line.split())
                total += max(0.0, min(last, end) - max(first, begin))
        return total

    def end(self):
        self.process.communicate()


def waited(process):
    """Time that a process has spent waiting for a processor, in seconds; 0 if it has ended."""
    try:
        with open(f"/proc/{process}/schedstat") as file:
            return int(file.read().split()[1]) * 1e-9
    except (OSError, IndexError):
        return 0.0


class Waits:
    """Measures how long the processes of a run and its robot wait for a processor, from now on."""

    def __init__(self, run):
        self.run = run
        self.first = {p: waited(p) for p in [*run.processes(), run.robot.process.pid]}
        self.last = dict(self.first)
        self.late = 0.0

    def look(self):
        for process in self.last:
            self.last[process] = max(self.last[process], waited(process))

    def until(self, condition):
        """Whether the condition becomes true."""
        before = time.monotonic()
        end = before + PATIENCE
        while not condition():
            if before > end:
                return False
            self.look()
            time.sleep(LOOK)
            # The delay of the observer itself, also for processes that have ended or started since.
            now = time.monotonic()
            before, self.late = now, max(self.late, now - before - LOOK)
        self.late = max(self.late, time.monotonic() - before)
        self.look()
        return True

    def sum(self, begin, took):
        """Seconds after `begin` that lie within the intervals in `took`."""
        waits = self.late + sum(self.last[p] - self.first[p] for p in self.last)
        return waits + self.run.robot.canary.stalls(begin, begin + took)


class Robot:
    def __init__(self, kind, canary):
        self.canary = canary
        self.judged = self.not_judged = 0
        self.lines, self.read_to, self.rest, self.worst = [], 0, "", 0.0
        self.kind, self.path = kind, os.path.abspath(f"{kind}.log")
        self.program = os.path.abspath(f"drive-{kind}")
        subprocess.run(
            [FROBC, "build", "drives.frob", "--robot", kind, "-o", self.program], check=True
        )
        self.process = subprocess.Popen(
            [*PRIORITY, FROBC, "serve", "--robot", kind, "--world", HALL, "--log", self.path],
            stdout=subprocess.PIPE,
            text=True,
        )
        self.device = self.process.stdout.readline().split()[1]

    def log(self):
        """Returns the lines of the log so far. The file only grows."""
        if os.path.exists(self.path):
            with open(self.path) as file:
                file.seek(self.read_to)
                text = self.rest + file.read()
                self.read_to = file.tell()
            *lines, self.rest = text.split("\n")
            self.lines += lines
        return self.lines

    def judge_time(self, what, killed, took, allowed, waits):
        """Returns an error message if a delay is too long."""
        waited_for = waits.sum(killed, took)
        if waited_for > BUSY:
            self.not_judged += 1
            return None
        self.judged += 1
        self.worst = max(self.worst, took - waited_for)
        if took - waited_for > allowed:
            return f"{what} after {took:.3f} s, of which the machine took {waited_for:.3f} s"
        return None

    def end(self):
        self.process.terminate()
        self.process.wait()


def until(condition):
    """Whether the condition becomes true."""
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(LOOK)
    return True


def kill(victims, gap, waits):
    """Returns the time of the last kill."""
    for victim in victims:
        if victim != victims[0]:
            time.sleep(gap)
        before = time.monotonic()
        with contextlib.suppress(ProcessLookupError):
            os.kill(victim, signal.SIGKILL)
    waits.late = time.monotonic() - before
    return before


def judge_stop(run, killed, waits):
    """Checks that the stop arrives in time, only zeros follow it, and no process remains."""
    stopped = waits.until(lambda: run.told() and not run.told()[-1][1])
    run.process.wait()
    gone = until(lambda: not run.processes())
    driven = max([at for at, drives in run.told() if drives], default=0.0)
    if run.driven_by_nobody() and run.robot.canary.stalls(killed, time.monotonic()) > BUSY:
        run.robot.not_judged += 1
        return None
    if not stopped or run.told()[-1][1] or run.driven_by_nobody():
        return "it was not told to stop"
    took = min(at for at, drives in run.told() if not drives and at >= driven) - killed
    fault = run.robot.judge_time("it was told to stop", killed, took, STATED, waits)
    if fault:
        return fault
    if not gone:
        return f"processes are left: {run.processes()}"
    return None


def judge_guards(run, killed, lost, waits):
    """Checks that the run continues, and that all guards are back in time."""
    back = waits.until(lambda: len(run.guards()) == 2 and run.guards_lost() >= lost)
    took = time.monotonic() - killed
    if not back or not until(run.drives):
        return f"guards are not back: {run.guards()}, {run.guards_lost()} told"
    # Checking takes time, too.
    return run.robot.judge_time("guards were back", killed, took, STATED + 0.05, waits)


def one(robot, number, random):
    began = time.monotonic()
    run = Run(robot, number)
    ready = until(lambda: run.process.poll() is not None or run.drives() and len(run.guards()) == 2)
    if run.process.poll() == 2:  # the previous run still has the line
        return one(robot, number + COUNT, random)
    if not ready or run.process.poll() is not None:
        run.process.kill()
        if robot.canary.stalls(began, time.monotonic()) > BUSY:
            robot.not_judged += 1
            return one(robot, number + COUNT, random)
        return f"it does not drive: {run.told()[-3:]}, {len(run.guards())} guards, {run.said()!r}"
    time.sleep(random.uniform(0, 0.1))
    names = {"supervisor": run.process.pid, "controller": run.controller()}
    names.update(zip(("first guard", "second guard"), run.guards()))
    chosen = random.sample(sorted(names), random.choice((1, 2)))
    gap = random.choice((0, random.uniform(0, 0.15)))
    waits = Waits(run)
    killed = kill([names[name] for name in chosen], gap, waits)
    if "supervisor" in chosen or "controller" in chosen:
        fault = judge_stop(run, killed, waits)
    else:
        fault = judge_guards(run, killed, len(chosen), waits)
        waits = Waits(run)
        fault = judge_stop(run, kill([run.process.pid], 0, waits), waits) or fault
    return fault and f"{' and '.join(chosen)}, {gap:.3f} s apart: {fault}"


def drive(kind, canary):
    robot = Robot(kind, canary)
    chance = random.Random(f"{SEED} {kind}")
    faults = 0
    for number in range(COUNT):
        fault = one(robot, number, chance)
        if fault:
            faults += 1
            print(f"FAIL {kind} {number}: {fault}", flush=True)
    robot.end()
    failures.append(faults)
    print(
        f"{'FAIL' if faults else 'ok'} the {kind} stops, of {COUNT} kills with seed {SEED}: "
        f"{faults} faults, {robot.judged} delays judged (at most {robot.worst:.3f} s), "
        f"{robot.not_judged} could not be judged",
        flush=True,
    )


def main():
    # In memory, because a disk may make the robot wait.
    memory = "/dev/shm" if os.path.isdir("/dev/shm") else None
    with tempfile.TemporaryDirectory(dir=memory) as folder:
        os.chdir(folder)
        with open("drives.frob", "w") as file:
            file.write(DRIVES)
        canary = Canary()
        lanes = [
            threading.Thread(target=drive, args=[kind, canary])
            for kind in ("pioneer", "scout", "create")
        ]
        for lane in lanes:
            lane.start()
        for lane in lanes:
            lane.join()
        canary.end()
        os.chdir("/")
    sys.exit(len(failures) != 3 or sum(failures) > 0)


main()
