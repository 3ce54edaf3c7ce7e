"""Checks that outputs equal those of `frobc trace`, bit for bit: for random programs, examples, and
each construct.
"""

import csv
import glob
import os
import subprocess
import unittest
import warnings

import checks
import frob
from frob import shapes

ROOT = os.environ["FROB_ROOT"]
ROBOTS = {"line_follow": "create", "safe_stick": "pioneer"}


def rows(text):
    lines = [line for line in text.splitlines(keepends=True) if not line.startswith("#")]
    names, *body = csv.reader(lines)
    return {name: list(column) for name, column in zip(names, zip(*body))}


def source(name):
    places = [name + ".frob", f"{ROOT}/examples/{name}/{name}.frob"]
    places.append(f"{ROOT}/tests/meaning/interp/{name}.frob")
    return next(place for place in places if os.path.exists(place))


def traced(name):
    robot = ["--robot", ROBOTS[name]] if name in ROBOTS else []
    command = ["frobc", "trace", source(name), "--input", name + ".csv", *robot]
    return rows(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


class Agree(unittest.TestCase):
    def same(self, program, told, given):
        """Compares values as texts: all NaNs are equal, and -0 differs from 0."""
        for name, leaf in program._code.output_columns:
            self.assertEqual(len(told[name]), len(given[name]))
            for row, (cell, value) in enumerate(zip(told[name], list(given[name]))):
                memory = bytearray(program._code.table.output_size)
                leaf.write(memory, 0, cell, name)
                value = value.item() if hasattr(value, "item") else value
                self.assertEqual(repr(leaf.read(memory, 0)), repr(value), (name, row))

    def agree(self, name):
        with open(name + ".csv") as file:
            head = file.read()
        recording = frob.read(name + ".csv")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", frob.FrobWarning)
            program = frob.compile(
                source(name), robot=ROBOTS.get(name), params=recording.attrs["params"]
            )
        told = traced(name)
        texts = rows(head)
        self.same(program, told, program.run(texts, time=[float(t) for t in texts["time"]]))
        self.same(program, told, program.run(recording))
        self.step_by_step(program, told, texts)

    def step_by_step(self, program, told, texts):
        memory = bytearray(program._code.table.input_size)
        ns = [round(float(t) * 1e9) for t in texts["time"]]
        results = []
        for row, now in enumerate(ns):
            for name, leaf in program._code.input_columns:
                leaf.write(memory, 0, texts[name][row], name)
            dt = (now - ns[max(row - 1, 0)]) / 1e9
            results.append(program.step(dt, program._code.input.read(memory, 0)))
        listed = {name: [] for name in program.outputs}
        out = bytearray(program._code.table.output_size)
        for result in results:
            program._code.output.write(out, 0, result, "out")
            for name, leaf in shapes.columns(program._code.output, "out"):
                listed[name].append(leaf.read(out, 0))
        self.same(program, told, listed)


for path in sorted(glob.glob("*.csv")):
    stem = os.path.splitext(path)[0]
    setattr(Agree, "test_" + stem, lambda self, stem=stem: self.agree(stem))

if __name__ == "__main__":
    checks.main("Python agrees with frobc trace")
