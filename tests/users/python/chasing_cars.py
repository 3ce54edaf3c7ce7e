"""`make falsify`: runs Chasing Cars of ARCH-COMP's falsification category, ten searches for each
requirement, and compares with Psy-TaLiRo on the same program.

chasing_cars.py EXAMPLE [TRIES]   uses cma, and psy-taliro if it is installed

An input has 20 values in 100 s. The program takes Euler steps of 2.5 ms (with 10 ms, cars brake in
situations where they would not otherwise). A violation counts only if it also occurs with steps of
0.1 ms.
"""

import importlib.util
import statistics
import sys
import time

from frob import library, ranges, search
from frob.falsification import Looking
from frob.judging import Subject

# Means of FalCAuN in ARCH-COMP 2026; it did not falsify CCx.
PUBLISHED = {"CC1": "198", "CC2": "38", "CC3": "61", "CC4": "474", "CCx": "never"}
SECONDS, RATE, FINE, POINTS, RUNS = 100.0, 400.0, 10000.0, 20, 5000
RIVAL_RUNS = 1000
INPUTS = {"in.throttle": (0, 1), "in.brake": (0, 1)}


def ours(code, label, seeds):
    """Which searches succeeded, and after how many runs; each violation is checked again with a
    finer step.
    """
    subject, finer = (Subject(code, SECONDS, rate) for rate in (RATE, FINE))
    _, signals = ranges.of_program(code, {}, INPUTS)
    space = search.Space([], signals.varied, POINTS, "constant")
    looking = Looking(subject, finer, space, {})
    claim = subject.chosen([label])[0]
    begun = time.process_time()
    searches = [looking.searched(claim, RUNS, seed, "cma") for seed in seeds]
    used = sum(one.runs for one in searches)
    seconds = (time.process_time() - begun) / used
    return [one.runs if one.found else None for one in searches], seconds


def rival(code, label, seeds):
    """Psy-TaLiRo's dual annealing, its default search, on the same program and the same margins."""
    import staliro
    from staliro.optimizers import DualAnnealing

    subject = Subject(code, SECONDS, RATE)
    claim = subject.chosen([label])[0]
    _, signals = ranges.of_program(code, {}, INPUTS)
    space = search.Space([], signals.varied, POINTS, "constant")

    @staliro.costfunc
    def cost(given):
        inputs = space.inputs_at(list(given.static.values()), subject.time, SECONDS)
        value, failed = subject.judged(claim, {}, inputs)
        return -1.0 if failed is not None else max(value, 0.0)

    found, used = [], 0
    begun = time.process_time()
    for seed in seeds:
        inputs = {f"u{k}": (0.0, 1.0) for k in range(space.size)}
        options = staliro.TestOptions(static_inputs=inputs, iterations=RIVAL_RUNS, seed=seed)
        run = staliro.staliro(cost, DualAnnealing(min_cost=0.0), options)[0]
        costs = [one.cost for one in run.evaluations]
        used += len(costs)
        found.append(len(costs) if min(costs) < 0 else None)
    return found, (time.process_time() - begun) / used


def told(name, label, found, seconds):
    hits = [n for n in found if n is not None]
    mean = f"{statistics.mean(hits):.0f}" if hits else "-"
    middle = f"{statistics.median(hits):.0f}" if hits else "-"
    print(
        f"{label}  {name:12} falsified {len(hits)} of {len(found)}; runs: mean {mean}, median "
        f"{middle}; {seconds * 1000:.1f} ms a run; published: {PUBLISHED[label]}",
        flush=True,
    )


def main():
    code = library.build(sys.argv[1], "main", None, (), asserts="margin")
    seeds = range(1, 1 + int(sys.argv[2] if len(sys.argv) > 2 else 10))
    for label in PUBLISHED:
        told("frob", label, *ours(code, label, seeds))
        if importlib.util.find_spec("staliro"):
            told("psy-taliro", label, *rival(code, label, seeds))


if __name__ == "__main__":
    main()
