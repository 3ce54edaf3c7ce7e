"""Compares the results of programs with cameras in the simulator with the simulator's ground truth.
Prints JSON, one object a line: a value, with the goal as its reference.

    truth.py FROBC FOLDER [SEEDS]

FROBC is the compiler, FOLDER the working folder. SEEDS is the number of seeds that each example
runs with, by default 100; a tenth of these runs are recorded with their frames.
"""

import csv
import json
import math
import pathlib
import re
import subprocess
import sys

frobc, folder = sys.argv[1], pathlib.Path(sys.argv[2])
SEEDS = int(sys.argv[3]) if len(sys.argv) > 3 else 100
RECORDED = range(1, max(1, SEEDS // 10) + 1)
trackers = pathlib.Path("tests/robots/trackers")


def row(program, measure, value, aim, unit):
    print(
        json.dumps(
            {
                "program": program,
                "measure": measure,
                "compiler": "gcc",
                "value": round(value, 4),
                "reference": aim,
                "ratio": round(value / aim, 3),
                "unit": unit,
            }
        ),
        flush=True,
    )


def call(*arguments):
    return subprocess.run(
        [frobc, *map(str, arguments)], check=True, capture_output=True, text=True
    ).stdout


# Measurements of the examples' trials


def measured(example):
    """Returns the measurements of an example's trial: for each name, a list of numbers from all
    runs. All runs must succeed.
    """
    tests = call(
        "test",
        f"examples/{example}/{example}.frob",
        "--seeds",
        SEEDS,
        "--json",
        "--keep",
        folder / "failed",
    )
    runs = [run["measured"] for line in tests.splitlines() for run in json.loads(line)["runs"]]
    assert len(runs) == SEEDS
    return {name: [run[name] for run in runs] for name in runs[0]}


def examples():
    ball = measured("follow_ball")
    row("follow_ball", "distance off, on average", sum(ball["meanOff"]) / SEEDS, 0.05, "m")
    row("follow_ball", "the same, worst seed", max(ball["meanOff"]), 0.05, "m")
    row("follow_ball", "out of sight, at most", max(ball["longest"]), 1, "s")
    corridor = measured("corridor_stereo")
    row("corridor_stereo", "off the middle, at most", max(corridor["largestOff"]), 0.05, "m")
    dock = measured("dock_tag")
    row("dock_tag", "place off, at most", max(dock["largestOff"]), 0.02, "m")
    row("dock_tag", "turn off, at most", math.degrees(max(dock["largestTurned"])), 2, "deg")


# Results of trackers, compared with the true positions


def recording(program, world, seconds, seed):
    """Records a run with its frames, replacing those of the previous run."""
    log = folder / "run.csv"
    subprocess.run(["rm", "-rf", folder / "run.frames"], check=True)
    call(
        "run",
        trackers / program,
        "--world",
        trackers / world,
        "--for",
        seconds,
        "--seed",
        seed,
        "--record",
        log,
    )
    return log


def judged(program, world, seconds, unwanted):
    """Returns each field of the program's `judged` over its frames, except the first ones."""
    fields = {}
    for seed in RECORDED:
        log = recording(program, world, seconds, seed)
        lines = call("trace", trackers / program, "--entry", "judged", "--input", log).splitlines()
        for line in [line for line in lines if "{" in line][unwanted:]:
            for name, value in re.findall(r"(\w+) = ([-+.e\d]+|nan|inf)", line):
                fields.setdefault(name, []).append(float(value))
    return fields


def rms(values):
    return math.sqrt(sum(x * x for x in values) / len(values))


def against_truth():
    off = judged("known.frob", "world.toml", "8s", 1)
    row("trackers", "blob off, RMS", rms(off["ball"]), 1, "px")
    row("trackers", "SSD off, RMS", rms(off["poster"]), 0.3, "px")
    row("trackers", "edge off, RMS", rms(off["edge"]), 0.3, "px")
    shares = judged("stereo.frob", "stereo.toml", "6s", 0)["wall"]
    row("stereo", "depth at 2 m off, at most", 100 * max(shares), 5, "%")
    row("stereo", "depth at 2 m off, on average", 100 * sum(shares) / len(shares), 5, "%")


# Time until trackers find hidden objects again


def found_again(rows):
    """Returns, for each time that the camera was covered and for each tracker, how long it took
    afterwards to find its object.
    """
    waits, was, before = [], "false", None
    since = {}
    for line in rows:
        time, hidden, sights = float(line[0]), line[1], line[2:5]
        if was == "true" and hidden == "false":
            assert before == ["Lost"] * 3, "not all were lost"
            since = dict.fromkeys(range(3), time)
        for k in [k for k in since if sights[k] == "Seen"]:
            waits.append(time - since.pop(k))
        was, before = hidden, sights
    assert not since, "not all were found again"
    return waits


def occlusion():
    waits = []
    for seed in RECORDED:
        log = recording("known.frob", "world.toml", "8s", seed)
        traced = call(
            "trace", trackers / "occluded.frob", "--with", trackers / "covered.c", "--input", log
        )
        waits += found_again(list(csv.reader(traced.splitlines()))[1:])
    row("trackers", "found again after, at most", max(waits), 0.5, "s")


folder.mkdir(parents=True, exist_ok=True)
against_truth()
occlusion()
examples()
