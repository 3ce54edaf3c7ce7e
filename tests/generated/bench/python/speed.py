"""Measures the processor time of a step of `Program.run` from Python, compared with a loop in C,
for a million instants in an array. Takes the best of nine runs each, alternating after every three.
Both allocate new memory for the outputs, as `run` does. Prints a JSON object for each program.

usage: speed.py PROGRAM.frob...   (programs whose inputs and outputs are numbers)"""

import json
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

import frob
from frob import tools

N, TIMES = 1_000_000, 3

LOOP = """
#include "%(name)s.h"
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

int main(int argc, char **argv)
{
    enum { N = %(count)d };
    struct %(name)s_input *in = malloc(N * sizeof *in);
    struct %(name)s_output *out = NULL;
    FILE *file = fopen(argv[1], "rb");
    if (fread(in, sizeof *in, N, file) != N)
        return 1;
    for (int k = 0; k < %(times)d; k++) {
        struct timespec before, after;
        struct %(name)s_state state;
        free(out);
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &before);
        out = malloc(N * sizeof *out);
        %(name)s_reset(&state);
        for (int i = 0; i < N; i++)
            %(name)s_step(&state, 0.02, &in[i], &out[i]);
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &after);
        printf("%%.9f\\n", (double)(after.tv_sec - before.tv_sec) +
                            (double)(after.tv_nsec - before.tv_nsec) * 1e-9);
    }
    fwrite(out, sizeof *out, N, stderr);
    return argc < 2;
}
"""


def build(folder, name, file, inputs):
    tools.run(["compile", file, "-o", folder])
    with open(os.path.join(folder, "loop.c"), "w") as source:
        source.write(LOOP % dict(name=name, count=N, times=TIMES))
    inputs.tofile(os.path.join(folder, "in"))
    include = os.path.join(tools.prefix(), "share", "frobc", "include")
    library = os.path.join(tools.prefix(), "lib", "frobc", "libfrob.a")
    flags = ["-std=gnu99", "-O2", "-ffp-contract=off", "-I", include]
    command = ["cc", *flags, f"{name}.c", "loop.c", library, "-lm", "-o", "loop"]
    subprocess.run(command, cwd=folder, check=True)


def in_c(folder):
    # Allocate memory in large pages, as numpy requests; small pages take longer than the filter.
    env = {**os.environ, "GLIBC_TUNABLES": "glibc.malloc.hugetlb=1"}
    done = subprocess.run(["./loop", "in"], cwd=folder, check=True, capture_output=True, env=env)
    return min(float(line) for line in done.stdout.split()), done.stderr


def in_python(program, inputs):
    best = float("inf")
    for _ in range(TIMES):
        before = time.process_time()
        outputs = program.run(inputs, dt=0.02)
        best = min(best, time.process_time() - before)
    return best, outputs.tobytes()


for file in sys.argv[1:]:
    p = frob.compile(file)
    inputs = np.random.default_rng(1).random((N, len(p.inputs)))
    with tempfile.TemporaryDirectory() as folder:
        build(folder, p.name, file, inputs)
        rounds = [(in_c(folder), in_python(p, inputs)) for _ in range(3)]
    if any(told != given for (_, told), (_, given) in rounds):
        sys.exit(f"{file}: Python has other outputs than C")
    c, python = (min(times[k][0] for times in rounds) / N * 1e9 for k in (0, 1))
    result = {"program": p.name, "measure": "a step from Python", "compiler": "gcc"}
    result.update(
        value=round(python, 2), reference=round(c, 2), ratio=round(python / c, 3), unit="ns"
    )
    print(json.dumps(result))
