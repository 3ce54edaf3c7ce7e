"""usage: claims.py FROBC RUN.csv FILE ROBOT

Tests what the viewer reports about a program's assertions: it must agree with the run's summary and
with the violations in the trace, also for a live run and for an edited program."""

import asyncio
import json
import os
import re
import subprocess
import sys
import tempfile

import viewer
from protocol import ask, connect, greet
from viewer import check

program_text = """import Past
import Robot
import WallFollow

main :: (HasSonar i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> wallFollow1 0.4[m] i where
    assert "is slow" (velocity i < 0.3[m/s])
    assert "has room" (frontSonar i > 0.6[m])
    assert "moves on" (afterwards (velocity i > 0.1[m/s], velocity i > 0.02[m/s]))
    assert "rests in the end" (by 30[s] (time () > 20[s]))
    assert "is asked nothing" (implies (frontSonar i < 0) True)
    assume "is early" (time () < 18[s]))
"""


def make_run(frobc, folder):
    """Makes a program and a recording of it."""
    program, recording = os.path.join(folder, "around.frob"), os.path.join(folder, "around.csv")
    with open(program, "w") as file:
        file.write(program_text)
    said = subprocess.run(
        [frobc, "run", program, "--robot", "pioneer", "--for", "20s", "--record", recording],
        check=True,
        stdout=subprocess.PIPE,
        text=True,
    ).stdout
    return program, recording, dict(re.findall(r'^ass(?:ert|ume) "(.*)": (.*)$', said, re.M))


def violated(rows, column, void):
    """Returns when an assertion starts and stops being violated, alternately."""
    fails = [
        row[f"probe.{column}"] == "Fails" and not (void is not None and k >= void)
        for k, row in enumerate(rows)
    ]
    return [
        float(row["time"]) for k, row in enumerate(rows) if fails[k] != (k > 0 and fails[k - 1])
    ]


async def of_recording(frobc, program, recording, summary):
    rows = viewer.trace(frobc, recording, program, "pioneer")
    v = viewer.Viewer(frobc, recording, program, "--robot", "pioneer", "--at", "15.9s")
    async with connect(v) as client:
        there = await greet(v, client)
        check("the page begins where it is told to", there["at"] == 15.9)
        await ask(client, f"instant {len(rows) - 1}")  # waits until the whole run has been replayed
        claims = (await ask(client, "claims"))["all"]
        check(
            "what became of each is as the run has told",
            {c["label"]: c["fate"]["text"] for c in claims} == summary,
        )
        void = next(k for k, row in enumerate(rows) if row["probe.main.assume is early"] == "Fails")
        check(
            "each has the times at which it was violated, until an assumption fails",
            all(
                c["times"] == violated(rows, c["column"], None if c["assumed"] else void)
                for c in claims
            )
            and sum(len(c["times"]) for c in claims) > 5,
        )
        check(
            "each has its line, and the signal of its verdict",
            all(
                program_text.splitlines()[int(c["place"].split(":")[1]) - 1].split('"')[1]
                == c["label"]
                and there["signals"][c["signal"]]["name"] == f"probe.{c['column']}"
                for c in claims
            ),
        )
        check(
            "what is open, and what was asked nothing",
            [c["label"] for c in claims if not c["fate"]["asked"]] == ["is asked nothing"]
            and [c["label"] for c in claims if c["fate"]["open"]] == ["rests in the end"],
        )
        edited = program_text.replace("< 0.3[m/s]", "< 3[m/s]").replace("has room", "has place")
        await ask(client, f"what-if {edited}")
        others = {c["label"]: c["other"] for c in (await ask(client, "claims"))["all"]}
        check(
            "those of an edited program are beside them",
            others["is slow"]["text"].startswith("held")
            and others["has room"] is None
            and others["is early"]["failed"],
        )
        await ask(client, "what-if")
        check(
            "and gone with it", not any("other" in c for c in (await ask(client, "claims"))["all"])
        )
    v.end()


async def of_many(frobc, folder):
    """In mapSF, many instances have an assertion with the same label."""
    program, recording = os.path.join(folder, "many.frob"), os.path.join(folder, "many.csv")
    with open(program, "w") as file:
        file.write(
            "main :: SF (Array 3 Float) (Array 3 Float)\n"
            'main = mapSF (proc x -> 2 * x where assert "small" (x < 2))\n'
        )
    with open(recording, "w") as file:
        file.write("time,in[0],in[1],in[2]\n0,1,1,1\n1,1,3,1\n2,1,1,1\n3,1,1,4\n")
    v = viewer.Viewer(frobc, recording, program)
    async with connect(v) as client:
        await greet(v, client)
        await ask(client, "instant 3")
        (claim,) = (await ask(client, "claims"))["all"]
        check(
            "one that runs many times is violated where one of them is",
            claim["times"] == [1, 2, 3] and claim["signal"] == -1,
        )
    v.end()


async def of_live_run(frobc, program, summary):
    run = viewer.Run(frobc, [program, "--robot", "pioneer", "--for", "20s"])
    async with connect(run) as client:
        await client.send(f"hello {run.token}")
        speeds, ended = False, False
        while not ended:
            said = json.loads(await client.recv())
            if said["is"] == "run" and not speeds:
                speeds = True
                await client.send("speed 100")
            if said["is"] == "live":
                ended = not said["live"]
                await client.send("more")
        await client.send("claims")
        while said["is"] != "claims":
            said = json.loads(await client.recv())
    check(
        "of a run that goes on, at its end, likewise",
        {c["label"]: c["fate"]["text"] for c in said["all"]} == summary,
    )


async def main():
    frobc = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        program, recording, summary = make_run(frobc, folder)
        await of_recording(frobc, program, recording, summary)
        await of_many(frobc, folder)
        await of_live_run(frobc, program, summary)


if __name__ == "__main__":
    asyncio.run(main())
    sys.exit(viewer.failures > 0)
