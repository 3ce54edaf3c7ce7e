"""usage: faults.py FROBC FOLDER COUNT SEED

How many controllers with a planted fault the trials and tests of the examples catch: those of all
examples without cameras and C, as they stand. As many faults in each example, drawn by the seed:
first a kind (see plant.py), then a place. What does not compile is no controller, and another is
drawn. A fault is caught if `frobc test` says that a trial or a test fails. If not, and if the
program has the same outputs as the one without it at each instant of all runs of the trials, then
it is no fault, and does not count.

Prints a row for each example, and a line for each fault that was missed.
"""

import concurrent.futures
import csv
import glob
import os
import random
import re
import shutil
import subprocess
import sys

from plant import faults

frobc, folder, count, seed = sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4]
WORKERS = 2


def examples():
    """The programs that have trials, and need neither a camera nor C."""
    for path in sorted(glob.glob("examples/*/*.frob")):
        with open(path) as file:
            text = file.read()
        world = os.path.join(os.path.dirname(path), "world.toml")
        in_c = glob.glob(os.path.join(os.path.dirname(path), "*.c"))
        if in_c or not re.search(r"^trial ", text, re.MULTILINE):
            continue
        with open(world) as file:
            if not re.search(r"^\[(camera|stereo)\]", file.read(), re.MULTILINE):
                yield path, text


def ask(command, *words):
    done = subprocess.run(
        [frobc, command, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    if done.returncode not in (0, 1):
        sys.exit(f"frobc {command} {' '.join(words)}: status {done.returncode}\n{done.stdout}")
    return done.returncode == 0, done.stdout


def outputs(program):
    """What the program does in each run of its trials: the columns `out.` of the recordings."""
    with open(program) as file:
        text = file.read()
    done = []
    for trial in re.split(r"^trial ", text, flags=re.MULTILINE)[1:]:
        world = re.search(r'world = "(.*)"', trial).group(1)
        lasts = re.search(r"lasts = (\S+)\[(\w+)\]", trial)
        first, last = re.search(r"seeds = (\d+) `to` (\d+)", trial).groups()
        for run in range(int(first), int(last) + 1):
            log = program + ".csv"
            there = os.path.join(os.path.dirname(program), world)
            ran, said = ask("run", program, "--world", there, "--for", "".join(lasts.groups()),
                            "--seed", str(run), "--record", log)  # fmt: skip
            if not ran:
                sys.exit(f"{program} does not run\n{said}")
            with open(log, newline="") as file:
                rows = [row for row in csv.reader(file) if not row[0].startswith("#")]
            columns = [at for at, name in enumerate(rows[0]) if name.startswith("out.")]
            if not columns or len(rows) < 2:
                sys.exit(f"{log} has no outputs")
            done.append([[row[at] for at in columns] for row in rows])
    return done


def draw(text, random_source):
    """Faults of a program in random order: by turns of any kind, none twice."""
    left = {
        kind: random_source.sample(places, len(places)) for kind, places in faults(text).items()
    }
    while left:
        kind = random_source.choice(sorted(left))
        yield kind, left[kind].pop()
        if not left[kind]:
            del left[kind]


def judge(path, text, wanted):
    """Of so many faults: how many are caught, the lines of those missed, how many are none."""
    name = os.path.basename(path)
    there = os.path.join(folder, name)
    shutil.copytree(os.path.dirname(path), there)
    program = os.path.join(there, name)
    holds, said = ask("test", program, "--jobs", "1", "--keep", there + "/failed")
    if not holds:
        sys.exit(f"{path} fails without a fault\n{said}")
    right = outputs(program)
    caught, missed, none = 0, [], 0
    for kind, (start, end, instead) in draw(text, random.Random(f"{seed} {path}")):
        if caught + len(missed) == wanted:
            break
        with open(program, "w") as file:
            file.write(text[:start] + instead + text[end:])
        if not ask("check", program)[0]:
            continue
        holds, said = ask("test", program, "--jobs", "1", "--keep", there + "/failed")
        if not holds and "\nFAIL" not in "\n" + said:
            sys.exit(f"{path}, {kind}, {text[start:end]}, {instead}: no trial failed\n{said}")
        if not holds:
            caught += 1
        elif outputs(program) == right:
            none += 1
        else:
            line = text.count("\n", 0, start) + 1
            old, new = (" ".join(what.split()) for what in (text[start:end], instead))
            left_out = f"without `{old}`"
            missed.append(
                f"{path}:{line}: {kind}: " + (f"`{new}` for `{old}`" if new else left_out)
            )
    return path, caught, missed, none


def main():
    programs = list(examples())
    each, over = divmod(count, len(programs))
    caught, none, misses = 0, 0, []
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        jobs = [pool.submit(judge, *one, each + (at < over)) for at, one in enumerate(programs)]
        for job in jobs:
            path, got, missed, same = job.result()
            planted = got + len(missed)
            print(f"{path:<44} {got:3} of {planted:3} caught; {same:3} changed nothing", flush=True)
            caught, none, misses = caught + got, none + same, misses + missed
    planted = caught + len(misses)
    share = 100 * caught / planted
    print(f"{'all':<44} {caught:3} of {planted:3} caught, {share:.1f} %; {none} changed nothing")
    for miss in misses:
        print(f"missed: {miss}")


main()
