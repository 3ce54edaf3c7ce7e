"""usage: protocol.py FROBC RUN.csv FILE ROBOT

Tests the viewer's answers to a WebSocket client other than its page."""

import asyncio
import json
import math
import os
import random
import subprocess
import sys
import tempfile

import websockets

import viewer
from viewer import check
from way import is_followed


def connect(v, **changes):
    wanted = dict(subprotocols=["frob-view"], origin=f"http://{v.host}", max_size=None)
    return websockets.connect(f"ws://{v.host}/", **{**wanted, **changes})


async def ask(client, request):
    """The answer to a request. Skips messages that are not answers: beats, and the progress of a
    viewer that still reads or replays its recording, as on a busy machine."""
    await client.send(request)
    while (answer := json.loads(await client.recv()))["is"] in ("beat", "progress"):
        pass
    return answer


async def greet(v, client):
    return await ask(client, f"hello {v.token}")


def number(cell):
    if cell in ("true", "false"):
        return float(cell == "true")
    return float(cell) if cell else None


async def values(v, rows):
    async with connect(v) as client:
        program = await greet(v, client)
        names = [signal["name"] for signal in program["signals"]]
        known = {signal["name"]: signal for signal in program["signals"]}
        check(
            "signals have their units",
            [
                known[name]["unit"]
                for name in (
                    "in.odometry.position.x",
                    "in.sonar[3]",
                    "in.leftWheel",
                    "out.forward",
                    "in.motorsOn",
                    "probe.closestPlace.p.x",
                )
            ]
            == ["m", "m", "m/s", "m/s", "", "m"],
        )
        inner = known["probe.closestPlace.p.x"]
        check(
            "inner signals have their places",
            inner["instance"] == "closestPlace"
            and inner["own"] == "p.x"
            and inner["file"] == "bug.frob"
            and inner["kind"] == "float"
            and "p <- " in program["sources"][0]["text"].splitlines()[inner["line"] - 1],
        )
        check("all columns are signals", set(rows[0]) == {"time", *names})
        check("as many instants as rows", program["instants"] == len(rows))
        differing = 0
        for k in random.Random(1).sample(range(len(rows)), len(rows)):
            instant = await ask(client, f"instant {k}")
            differing += instant["cells"] != [rows[k][name] for name in names]
            differing += not math.isclose(instant["time"], float(rows[k]["time"]))
        check("each instant, in any order, is as traced", differing == 0)
        plain = [
            i
            for i, signal in enumerate(program["signals"])
            if signal["kind"] in ("bool", "int", "float")
            or (signal["kind"] == "event" and "sonar" in signal["name"])
        ]
        series = [await ask(client, f"series {i} -1 1e6 100000") for i in plain]
        check(
            "plots of whole runs are as traced",
            all(
                s["values"] == [number(row[names[i]]) for row in rows]
                for i, s in zip(plain, series)
            ),
        )
        heading = names.index("in.odometry.heading")
        whole = [float(row["in.odometry.heading"]) for row in rows]
        few = await ask(client, f"series {heading} -1 1e6 20")
        check(
            "a plot of few columns has the extremes",
            len(few["values"]) <= 80
            and min(few["values"]) == min(whole)
            and max(few["values"]) == max(whole),
        )
        x, y = (names.index(f"in.odometry.position.{c}") for c in "xy")
        places = [[float(row[name]) for name in ("time", names[x], names[y])] for row in rows]
        times = [time for time, _, _ in places]
        path = await ask(client, f"path {x} {y} 100000")
        check(
            "a path follows the robot",
            is_followed(path["points"], places)
            and path["points"][0] == places[0]
            and path["points"][-1] == places[-1]
            and all(point in places for point in path["points"]),
        )
        check("with few points", len(path["points"]) < len(rows) / 5)
        first = times.index(path["points"][3][0])
        rest = await ask(client, f"path {x} {y} 100000 {first}")
        check("a path is continued from a corner", rest["points"] == path["points"][3:])
        check("which is named", times[path["next"]] == path["points"][-2][0])
        few = await ask(client, f"path {x} {y} 11")
        check(
            "a path has as many points as requested",
            len(few["points"]) <= 11 and is_followed(few["points"], places, 5, 100),
        )
        late = await ask(client, f"instant {len(rows) - 1}")
        echoes = {names[number]: value for number, value, *_ in late["recent"]}
        check(
            "an instant has the last echoes",
            echoes
            == {
                name: float(row[name])
                for row in rows[-20:]
                for name in names
                if name.startswith("in.sonar[") and row[name] != ""
            },
        )
        after = await ask(client, "time 1.019")
        check("a time is the last instant not after it", after["k"] == 50)


async def diagrams(v):
    async with connect(v) as client:
        program = await greet(v, client)
        modes = next(s for s in program["signals"] if s["name"] == "probe.bug.mode")
        name = lambda k: modes["names"][k] if k >= 0 else {-2: "start", -1: "any"}[k]
        drawn = {(name(t["from"]), name(t["to"])) for t in modes["transitions"]}
        check(
            "the modes of a machine, and what leads from one to the other",
            drawn
            == {
                ("start", "driveTo"),
                ("driveTo", "withSF"),
                ("driveTo", "ended"),
                ("withSF", "circleTo"),
                ("circleTo", "driveTo"),
                ("circleTo", "ended"),
            },
        )


async def units(frobc):
    """Tests that units have the program's own spelling."""
    with tempfile.TemporaryDirectory() as folder:
        program, recording = os.path.join(folder, "push.frob"), os.path.join(folder, "run.csv")
        with open(program, "w") as file:
            file.write(
                "main :: SF Acceleration (Float[N], Float[N/m^2], AngularVelocity)\n"
                "main = proc a -> (2[kg] * a, 2[kg] * a / 1[m^2], 1[rad/s])\n"
            )
        with open(recording, "w") as file:
            file.write("time,in\n0,1\n")
        v = viewer.Viewer(frobc, recording, program)
        async with connect(v) as client:
            signals = (await greet(v, client))["signals"]
        v.end()
    check(
        "derived units have their names",
        [s["unit"] for s in signals if s["side"] == "output"] == ["N", "Pa", "1/s"],
    )


async def origins(v, rows):
    async with connect(v) as client:
        program = await greet(v, client)
        signals = program["signals"]
        names = [signal["name"] for signal in signals]
        lines = {s["name"]: s["text"].splitlines() for s in program["sources"]}

        async def why(k, name):
            return await ask(client, f"why {k} {names.index(name)}")

        def named(sources):
            return [(names[s["signal"]], s["k"]) for s in sources]

        chance = random.Random(3)
        differing = 0
        for _ in range(400):
            k, name = chance.randrange(len(rows)), chance.choice(names)
            answer = await why(k, name)
            since = answer["since"]["k"]
            differing += len({rows[i][name] for i in range(since, k + 1)}) != 1
            differing += since > 0 and rows[since - 1][name] == rows[k][name]
            switches = answer.get("switches", [])
            for s in answer["sources"] + [s for change in switches for s in change["sources"]]:
                differing += s["cell"] != rows[s["k"]][names[s["signal"]]]
                differing += s["k"] > k
            for place in [answer, *switches]:
                differing += place["file"] != "" and not (
                    1 <= place["line"] <= place["last"] <= len(lines[place["file"]])
                )
        check("what values come from is as traced", differing == 0)

        answer = await why(50, "probe.driveTo.v")
        check(
            "an equation and what it mentions",
            lines[answer["file"]][answer["line"] - 1].strip().startswith("v ")
            and named(answer["sources"])
            == [(f"probe.driveTo.{own}", 50) for own in ("looks", "near", "off")],
        )
        switch = next(k for k, row in enumerate(rows) if row["probe.bug.mode"] == "withSF")
        answer = await why(switch + 20, "probe.bug.mode")
        check(
            "a mode by what it came there, and when",
            answer["since"]["k"] == switch
            and [(s["from"], s["to"], s["k"]) for s in answer["switches"]]
            == [("driveTo", "withSF", switch)]
            and named(answer["switches"][0]["sources"])
            == [("probe.driveTo.arrived", switch - 1), ("probe.driveTo.blocked", switch - 1)],
        )
        answer = await why(switch + 20, "probe.withSF.hit.x")
        check(
            "a parameter of a mode from when that began",
            named(answer["sources"]) == [("in.odometry.position.x", switch)]
            and answer["sources"][0]["cell"] == rows[switch + 20]["probe.withSF.hit.x"],
        )
        omega = next(
            n for n in names if n.endswith(".wallFollow.omega") and rows[switch + 20][n] != ""
        )
        answer = await why(switch + 20, omega)
        s = omega.replace("omega", "s")
        check(
            "what a derivative was taken of, now and an instant ago",
            {(s, switch + 20), (s, switch + 19)} <= set(named(answer["sources"])),
        )
        answer = await why(50, "out.forward")
        check(
            "an output in the mode that runs, and no other",
            named(answer["sources"])
            == [
                ("probe.withMarks.mode", 50),
                ("probe.watching.mode", 50),
                ("probe.bug.mode", 50),
                ("probe.driveTo.v", 50),
            ],
        )
        answer = await why(7, "in.sonar[3]")
        check("input comes from nowhere", answer["sources"] == [] and answer["file"] == "")


def rises(holds):
    return [k for k, now in enumerate(holds) if now and not (k and holds[k - 1])]


async def conditions(v, rows):
    def x(row, name):
        return float(row[name]) if row[name] else math.nan

    wanted = {
        "out.forward < 0.1[m/s]": lambda row: x(row, "out.forward") < 0.1,
        "forward * 100 < 10[m/s] || turn > 0.5[rad/s]": lambda row: x(row, "out.forward") * 100 < 10
        or x(row, "out.turn") > 0.5,
        "sonar[3] <= 150[cm]": lambda row: x(row, "in.sonar[3]") <= 1.5,
        "not (sonar[3] <= 1.5[m])": lambda row: not x(row, "in.sonar[3]") <= 1.5,
        "abs heading > 10[deg] && motorsOn": lambda row: abs(x(row, "in.odometry.heading"))
        > math.radians(10)
        and row["in.motorsOn"] == "true",
        "mode.bug == driveTo": lambda row: row["mode.bug"] == "driveTo",
        "mode.bug /= driveTo": lambda row: row["mode.bug"] not in ("driveTo", ""),
        "-forward - 0.1[m/s] >= -(0.2[m] + 10[cm]) / 2 * 2[1/s]": lambda row: -x(row, "out.forward")
        - 0.1
        >= -(0.2 + 0.1) / 2 * 2,
        "forward > 0 && 5[s] * forward < 30[cm]": lambda row: 0 < x(row, "out.forward") < 0.06,
        "time >= 2[s] && time < 2500[ms]": lambda row: 2 <= x(row, "time") < 2.5,
        "True": lambda row: True,
        "False": lambda row: False,
    }
    wrong = {
        "forward > 10[s]": "cannot compare m/s and s: their units differ",
        "forward * turn > 1[m/s]": "cannot compare m/s^2 and m/s: their units differ",
        "1[m] + 2[s] > 0": "cannot add or subtract m and s: their units differ",
        "heading > 2[m]": "cannot compare a plain number and m: write the number with its unit, such as 0.3[m]",
        "turn < 0.3": "cannot compare 1/s and a plain number: write the number with its unit, such as 0.3[1/s]",
        "foo > 1": "there is no signal `foo`",
        "x": None,
        "forward >": "the condition is incomplete",
        "(forward > 1[m/s]": "a closing parenthesis is missing before",
        "forward > 1[ell]": "not a unit: `[ell]`",
        "forward ! 1": "the viewer does not understand `! 1`",
        "forward = 1[m/s]": "write `==` to compare, instead of `= 1[m/s]`",
        "SONAR": "there is no signal `SONAR`; similar names: `in.sonar[0]`, `in.sonar[1]`, `in.sonar[2]`",
        "mode.bug == drive": "there is no mode or value `drive`; it can be `driveTo`, `ended`, `withSF`, `circleTo`",
        "1" + " + 1" * 300: "the condition is too long",
        "(" * 300: "the condition is nested too deeply",
    }
    async with connect(v) as client:
        await greet(v, client)
        for condition, holds in wanted.items():
            expected = rises([holds(row) for row in rows])
            found = await ask(client, f"find 100 {condition}")
            check(
                f"{condition}: begins to hold where it should",
                found["count"] == len(expected)
                and found["first"] == (expected or [None])[0]
                and found["before"] == ([k for k in expected if k < 100] or [None])[-1]
                and found["after"] == ([k for k in expected if k > 100] or [None])[0],
            )
        for condition, why in wrong.items():
            found = await ask(client, f"find 0 {condition}")
            check(f"{condition[:20]}: {why or 'is found'}", found.get("why") == why)


async def what_if(v, frobc, recording, program, robot, rows):
    """Compares the results for an edited program with a trace of it."""
    with open(program) as file:
        text = file.read()
    edited = text.replace("13[m]", "12[m]")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, os.path.basename(program))
        with open(path, "w") as file:
            file.write(edited)
        others = viewer.trace(frobc, recording, path, robot)
    before = os.listdir(tempfile.gettempdir())
    async with connect(v) as client:
        names = [signal["name"] for signal in (await greet(v, client))["signals"]]
        outputs = [name for name in names if name.startswith("out.")]
        first = next(
            k for k in range(len(rows)) if any(rows[k][name] != others[k][name] for name in outputs)
        )
        answer = await ask(client, f"what-if {text}")
        check(
            "the same program has the same outputs",
            answer == {"is": "what-if", "there": True, "drives": False},
        )
        answer = await ask(client, f"what-if {edited}")
        check("an edited program is other from where its trace is", answer["first"] == first)
        differing = 0
        for k in random.Random(2).sample(range(len(rows)), 100):
            instant = await ask(client, f"instant {k}")
            differing += instant["cells"] != [rows[k][name] for name in names]
            differing += instant["others"] != [others[k].get(name) for name in names]
        check("both have the values of their traces", differing == 0)
        forward = names.index("out.forward")
        series = await ask(client, f"series {forward} -1 1e6 100000")
        check(
            "both have the plots of their traces",
            series["values"] == [number(row["out.forward"]) for row in rows]
            and series["others"] == [number(row["out.forward"]) for row in others],
        )
        # The import is unused, so the compiler warns.
        warned = await ask(client, f"what-if import Sources\n{edited}")
        check("an edited program with a warning is run, too", warned == answer)
        wrong = await ask(client, f"what-if {text.replace('13[m]', '13[s]')}")
        check(
            "what the compiler says comes back",
            not wrong["there"] and "error[" in wrong["why"] and " bug.frob:14" in wrong["why"],
        )
        other = await ask(client, "what-if main :: SF Float Float\nmain = proc x -> x")
        check("another input is refused", "cannot be run on this recording" in other["why"])
        answer = await ask(client, "what-if")
        check(
            "an edited program can be dropped",
            answer == {"is": "what-if", "there": False}
            and "others" not in await ask(client, "instant 1"),
        )
    check(
        "nothing of it is left on disk",
        [
            name
            for name in os.listdir(tempfile.gettempdir())
            if name.startswith("frob-view-") and name not in before
        ]
        == [],
    )


async def drive_again(v, frobc, recording, program, robot, rows):
    """Compares the results for an edited program with a run of it in the simulator."""
    with open(program) as file:
        text = file.read()
    edited = text.replace("13[m]", "0.5[m]")
    world = os.path.join(os.path.dirname(program), "world.toml")
    with tempfile.TemporaryDirectory() as folder:
        path, driven = os.path.join(folder, "bug.frob"), os.path.join(folder, "driven.csv")
        with open(path, "w") as file:
            file.write(edited)
        subprocess.run(
            [frobc, "run", "--world", world, "--for", "10s", "--record", driven, path],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        others = viewer.trace(frobc, driven, path, robot)
    async with connect(v) as client:
        names = [signal["name"] for signal in (await greet(v, client))["signals"]]
        outputs = [name for name in names if name.startswith("out.")]
        answer = await ask(client, f"drive {text}")
        check(
            "the same program drives the same way",
            answer == {"is": "what-if", "there": True, "drives": True},
        )
        answer = await ask(client, f"drive import Sources\n{edited}")
        check("an edited program with a warning drives, too", answer["there"])
        answer = await ask(client, f"drive {edited}")
        check(
            "an edited program drives in the same world",
            answer["drives"]
            and answer["first"]
            == next(
                k
                for k in range(len(rows))
                if any(rows[k][name] != others[k][name] for name in outputs)
            ),
        )
        differing = 0
        for k in random.Random(2).sample(range(len(rows)), 50):
            instant = await ask(client, f"instant {k}")
            differing += instant["others"] != [others[k].get(name) for name in names]
        check("all of it is as in a run of its own", differing == 0)
        x, y = (names.index(f"in.odometry.position.{c}") for c in "xy")
        path = await ask(client, f"path {x} {y} 100000")
        check(
            "both ways are on the map",
            is_followed(
                path["others"],
                [[float(row[name]) for name in ("time", names[x], names[y])] for row in others],
            ),
        )
        wrong = await ask(client, f"drive {text.replace('13[m]', '13[s]')}")
        check(
            "what the compiler says comes back from there too",
            not wrong["there"] and "error[" in wrong["why"],
        )
        await ask(client, "what-if")
    other = viewer.Viewer(frobc, recording, program, "--seed", "2")
    async with connect(other) as client:
        await greet(other, client)
        answer = await ask(client, f"drive {text}")
        check(
            "a recording that the simulator does not repeat is no measure",
            not answer["there"]
            and "the simulator does not reproduce this recording" in answer["why"],
        )
    other.end()


async def main():
    frobc, recording, program, robot = sys.argv[1:]
    v = viewer.Viewer(frobc, recording, program)
    rows = viewer.trace(frobc, recording, program, robot)
    await values(v, rows)
    await origins(v, rows)
    await diagrams(v)
    await units(frobc)
    await conditions(v, rows)
    await what_if(v, frobc, recording, program, robot, rows)
    await drive_again(v, frobc, recording, program, robot, rows)
    check("it ends when it is told to", v.end() == 0)


if __name__ == "__main__":
    asyncio.run(main())
    sys.exit(viewer.failures > 0)
