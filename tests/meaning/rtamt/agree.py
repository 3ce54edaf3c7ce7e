"""Compares the module Past with RTAMT, a library for monitors of signal temporal logic.

    agree.py FROBC N SEED           compares frobc with RTAMT on N random formulas
    agree.py --store FOLDER N SEED  writes N formulas as a program, its input, and RTAMT's results

Both get the same traces of three signals, with one instant a second. A formula holds for RTAMT if
its robustness is positive. No signal is ever 0, so every formula is decided.
"""

import csv
import os
import random
import subprocess
import sys
import tempfile

import rtamt

SIGNALS = ["x", "y", "z"]
INSTANTS = 24
BATCH = 25  # number of formulas in one program


def atom(r):
    s = r.choice(SIGNALS)
    return r.choice([(f"({s} > 0)", f"({s} > 0)"), (f"({s} < 0)", f"({s} < 0)")])


def formula(r, depth):
    """Returns a random formula as a pair: in Frob's and in RTAMT's syntax."""
    if depth == 0:
        return atom(r)
    f, g = formula(r, depth - 1), formula(r, r.randrange(depth))
    k = r.randrange(6)
    kind = r.randrange(11)
    if kind == 0:
        return f"(not {f[0]})", f"(not {f[1]})"
    if kind == 1:
        return f"({f[0]} && {g[0]})", f"({f[1]} and {g[1]})"
    if kind == 2:
        return f"({f[0]} || {g[0]})", f"({f[1]} or {g[1]})"
    if kind == 3:
        return f"(holds (implies {f[0]} {g[0]}))", f"({f[1]} implies {g[1]})"
    if kind == 4:
        return f"(ever {f[0]})", f"(once {f[1]})"
    if kind == 5:
        return f"(always {f[0]})", f"(historically {f[1]})"
    if kind == 6:
        return f"(since ({f[0]}, {g[0]}))", f"({f[1]} since {g[1]})"
    if kind == 7:
        return f"(within {k}[s] {f[0]})", f"(once[0:{k}] {f[1]})"
    if kind == 8:
        # Before the first instant there is no past; RTAMT would assume whatever makes the formula
        # true.
        return f"(heldFor {k}[s] {f[0]})", f"((historically[0:{k}] {f[1]}) and (t > {k - 0.5}))"
    if kind == 9:
        return f"(holds (afterwards ({f[0]}, {g[0]})))", f"((once {f[1]}) implies {g[1]})"
    late = f"((not {g[1]}) since[{k + 1}:{INSTANTS}] ({f[1]} and (not {g[1]})))"
    return f"(holds (respondsWithin {k}[s] ({f[0]}, {g[0]})))", f"(not {late})"


def trace(r):
    """Signals that keep their sign for some time."""
    rows = {s: [] for s in SIGNALS}
    for s in SIGNALS:
        stays = r.choice([2, 4, 8])
        sign = r.choice([-1, 1])
        for _ in range(INSTANTS):
            if r.randrange(stays) == 0:
                sign = -sign
            rows[s].append(sign * (0.5 + r.randrange(8)))
    return rows


def by_rtamt(text, rows):
    spec = rtamt.StlDiscreteTimeSpecification()
    for name in SIGNALS + ["t"]:
        spec.declare_var(name, "float")
    spec.declare_var("out", "float")
    spec.spec = "out = " + text
    spec.parse()
    data = {"time": list(range(INSTANTS)), "t": [float(k) for k in range(INSTANTS)], **rows}
    said = spec.evaluate(data)
    assert all(value != 0 for _, value in said), text
    return [value > 0 for _, value in said]


def program(formulas):
    names = [f"r{k}" for k in range(len(formulas))]
    bools = ", ".join(["Bool"] * len(formulas))
    lines = [f"    {name} = {frob}" for name, (frob, _) in zip(names, formulas)]
    return (
        "import Past\n\n"
        f"main :: SF (Float, Float, Float) ({bools})\n"
        f"main = proc (x, y, z) -> ({', '.join(names)}) where\n" + "\n".join(lines) + "\n"
    )


def inputs(rows):
    header = "time,in.1,in.2,in.3\n"
    return header + "".join(
        f"{k},{rows['x'][k]},{rows['y'][k]},{rows['z'][k]}\n" for k in range(INSTANTS)
    )


def batch(r, n):
    formulas = [formula(r, 1 + r.randrange(3)) for _ in range(n)]
    rows = trace(r)
    return formulas, rows, [by_rtamt(text, rows) for _, text in formulas]


def outputs(said):
    header = "time," + ",".join(f"out.{k + 1}" for k in range(len(said))) + "\n"
    row = lambda k: ",".join("true" if one[k] else "false" for one in said)
    return header + "".join(f"{k}.000000000,{row(k)}\n" for k in range(INSTANTS))


def write(folder, name, text):
    with open(os.path.join(folder, name), "w") as file:
        file.write(text)


def store(folder, n, seed):
    formulas, rows, said = batch(random.Random(seed), n)
    write(folder, "stored.frob", program(formulas))
    write(folder, "stored.csv", inputs(rows))
    write(folder, "stored.expected", outputs(said))


def disagreements(frobc, formulas, rows, said):
    with tempfile.TemporaryDirectory() as folder:
        write(folder, "past.frob", program(formulas))
        write(folder, "in.csv", inputs(rows))
        path = lambda name: os.path.join(folder, name)
        found = subprocess.run(
            [frobc, "trace", path("past.frob"), "--engine", "interp", "--input", path("in.csv")],
            capture_output=True,
            text=True,
        )
    assert found.returncode == 0, found.stderr
    table = list(csv.reader(found.stdout.splitlines()))[1:]
    for k, one in enumerate(said):
        for instant, row in enumerate(table):
            if (row[k + 1] == "true") != one[instant]:
                yield formulas[k], instant, row[k + 1]
                break


def compare(frobc, n, seed):
    r = random.Random(seed)
    wrong = done = held = 0
    while done < n:
        formulas, rows, said = batch(r, min(BATCH, n - done))
        done += len(formulas)
        held += sum(map(sum, said))
        for (frob, stl), instant, found in disagreements(frobc, formulas, rows, said):
            wrong += 1
            print(f"{frob} is {found} at {instant} s; RTAMT says otherwise of {stl}")
    print(
        f"{done} formulas, {INSTANTS} instants each, of seed {seed}: "
        f"{wrong} told otherwise; {100 * held // (done * INSTANTS)} % of instants held"
    )
    return 1 if wrong else 0


if __name__ == "__main__":
    if sys.argv[1] == "--store":
        store(sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
    else:
        sys.exit(compare(sys.argv[1], int(sys.argv[2]), int(sys.argv[3])))
