"""usage: faults.py FROBC FOLDER COUNT SEED

Measures how many controllers with a planted fault the trials and tests of the examples catch. It
uses all examples without cameras and C, unchanged, and plants the same number of faults in each.
The seed determines the faults: first a kind (see plant.py), then a place. If the program with a
fault does not compile, another fault is drawn. A fault is caught if `frobc test` reports a failed
trial or test. A fault that is not caught does not count if it has no effect: if the program has the
same outputs as the original at each instant of all runs of the trials.

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


def with_tests(program):
    """Returns the text of a program and of its test file."""
    tests = program.removesuffix(".frob") + ".test.frob"
    text = ""
    for path in program, tests:
        if os.path.exists(path):
            with open(path) as file:
                text += file.read()
    return text


def examples():
    """Returns the programs that have trials and need neither a camera nor C, with their texts."""
    for path in sorted(glob.glob("examples/*/*.frob")):
        if path.endswith(".test.frob"):
            continue
        with open(path) as file:
            text = file.read()
        world = os.path.join(os.path.dirname(path), "world.toml")
        in_c = glob.glob(os.path.join(os.path.dirname(path), "*.c"))
        if in_c or not re.search(r"^trial ", with_tests(path), re.MULTILINE):
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
    """Returns the program's outputs in each run of its trials: the columns `out.` of the
    recordings.
    """
    done = []
    for trial in re.split(r"^trial ", with_tests(program), flags=re.MULTILINE)[1:]:
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
    """Yields faults of a program in random order without repetition, choosing a random kind each
    time.
    """
    left = {
        kind: random_source.sample(places, len(places)) for kind, places in faults(text).items()
    }
    while left:
        kind = random_source.choice(sorted(left))
        yield kind, left[kind].pop()
        if not left[kind]:
            del left[kind]


def judge(path, text, wanted):
    """Tests `wanted` faults. Returns the number that were caught, a line for each missed one, and
    the number without effect.
    """
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
