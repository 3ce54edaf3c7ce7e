"""usage: figures.py FROBC FOLDER RUNS

Measures a sweep in the folder, with two workers, and prints JSON:

- `sweep`, `sweep, processor time`: the time that all its runs take, in seconds, compared with the
  limits: 10 ms for each run, and twice that for the processor time of both workers together;
- `sweep, a run`: the processor time of a run of 60 s, including its part of the sweep's other work,
  in milliseconds, compared with the same runs made by the simulator's host alone, one after another
  in one process, without storing the rows;
- `sweep, killed`: the percentage of runs that were repeated or lost because 20 processes (for a
  short sweep, one) were killed at random moments, either the sweep itself or one of its workers;
  compared with the limit, 1. The script also checks that the table is the same.
"""

import filecmp
import json
import os
import random
import resource
import signal
import subprocess
import sys
import time

frobc, folder, runs = sys.argv[1], sys.argv[2], int(sys.argv[3])
# Use few kills for few runs, so that the sweep does not end before the kills.
KILLS, COMPARED, TIMES = min(20, max(1, runs // 300)), max(1, runs // 10), 3
os.chdir(folder)


def plan(name, count):
    with open(name + ".toml", "w") as file:
        file.write(f'program = "wall_follow.frob"\nseeds = [1, {count}]\n')
    return [frobc, "sweep", name + ".toml", "-j", "2"]


def used():
    """Processor time of all children that have ended, in seconds."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def workers(sweep):
    """The workers of a sweep that perform runs: pid and command line of each."""
    try:
        with open(f"/proc/{sweep}/task/{sweep}/children") as file:
            children = file.read().split()
    except OSError:
        return []
    found = []
    for child in children:
        try:
            with open(f"/proc/{child}/cmdline") as file:
                words = file.read().split("\0")[:-1]
        except OSError:
            continue
        if "--runs" in words and words[words.index("--for") + 1] != "0":
            found.append((int(child), words))
    return found


def start(command, told):
    with open(told, "w") as out:
        return subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT)


def run(command, told):
    if start(command, told).wait() != 0:
        with open(told) as file:
            sys.exit(f"{' '.join(command)}: {file.read()}")


def row(measure, value, reference, unit):
    result = {"program": "wall_follow", "measure": measure, "compiler": "gcc", "value": value}
    result.update(reference=reference, ratio=round(value / reference, 3), unit=unit)
    print(json.dumps(result), flush=True)


# Time of all runs.
whole = plan("whole", runs)
before, used_before = time.monotonic(), used()
sweep = start(whole, "whole.told")
alone = []
while not alone and sweep.poll() is None:
    alone = [words for _, words in workers(sweep.pid)]
    time.sleep(0.005)
if sweep.wait() != 0 or not alone:
    sys.exit("the sweep failed; see whole.told")
took = time.monotonic() - before
row("sweep", round(took, 1), runs * 0.01, "s")
row("sweep, processor time", round(used() - used_before, 1), runs * 0.02, "s")

# Alternate the two commands, because the speed of the machine varies.
part = plan("part", COMPARED)
at = alone[0].index("--runs")
by_itself = alone[0][:at] + ["--seed", "1", "--last-seed", str(COMPARED)]
costs = ([], [])
for turn in range(TIMES):
    for command, each in ((by_itself, costs[0]), (part + ["--rows", f"part{turn}"], costs[1])):
        before = used()
        run(command, "part.told")
        each.append((used() - before) / COMPARED * 1000)
row("sweep, a run", round(min(costs[1]), 2), round(min(costs[0]), 2), "ms")

# Kill processes during the sweep.
random.seed(1)
killed = plan("killed", runs)
sweep, in_vain, kills = start(killed, "killed.told"), 0, 0
while kills < KILLS:
    time.sleep(random.uniform(0, (1.5 if KILLS > 10 else 0.7) * took / KILLS))
    if sweep.poll() is not None:
        sys.exit(f"the sweep ended after {kills} kills")
    if random.random() < 0.5:
        sweep.kill()
        sweep.wait()
        sweep = start(killed, "killed.told")
        kills += 1
        continue
    victims = workers(sweep.pid)
    if victims:
        os.kill(random.choice(victims)[0], signal.SIGKILL)
        in_vain += 1
        kills += 1
if sweep.wait() != 0:
    sys.exit("the sweep failed; see killed.told")
if not filecmp.cmp("whole.csv", "killed.csv", shallow=False):
    sys.exit("the table is another when processes are killed")
keys = []
for name in os.listdir("killed.rows"):
    with open(os.path.join("killed.rows", name)) as file:
        keys += [line.split("\t")[0] for line in file if line.endswith("\n")]
again = len(keys) - len(set(keys)) + in_vain
row("sweep, killed", round(100 * again / runs, 3), 1.0, "%")
