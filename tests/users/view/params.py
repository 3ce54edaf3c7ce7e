"""usage: params.py FROBC RUN.csv FILE ROBOT

Tests the parameters of a viewed run, and what-ifs with other values: the results must equal traces
of runs with these values."""

import asyncio
import os
import subprocess
import sys
import tempfile

import viewer
from protocol import ask, connect, greet
from viewer import check

corridor = "../../../examples/corridor/corridor.frob"
robot = "pioneer"


async def visit(v, recording, folder):
    def traced(program, recording, *params):
        return viewer.trace(v.frobc, recording, program, robot, *params)

    async with connect(v) as client:
        program = await greet(v, client)
        names = [signal["name"] for signal in program["signals"]]
        text = program["sources"][0]["text"]
        rows = traced(corridor, recording)

        async def others(answer, wanted):
            """Whether the results for the edited program equal those in a trace of it."""
            outputs = [name for name in names if name.startswith("out.")]
            first = next(
                (
                    k
                    for k in range(len(wanted))
                    if any(rows[k][name] != wanted[k][name] for name in outputs)
                ),
                None,
            )
            same = answer.get("first") == first
            for k in range(0, len(rows), 7):
                instant = await ask(client, f"instant {k}")
                same &= instant["others"] == [wanted[k].get(name) for name in names]
            return same and answer["there"]

        params = {param["name"]: param for param in program["params"]}
        check(
            "parameters are told, as they are in this run and by default",
            params["speed"]
            == {"name": "speed", "unit": "m/s", "value": "0.2[m/s]", "first": "0.3[m/s]"}
            and params["clearance"]["value"] == params["clearance"]["first"],
        )
        answer = await ask(client, f"with clearance=0.25 kTurn=3 what-if {text}")
        check(
            "they can be set otherwise",
            await others(answer, traced(corridor, recording, "clearance=0.25[m]", "kTurn=3[1/m]")),
        )
        edited = os.path.join(folder, "corridor.frob")
        with open(edited, "w") as file:
            file.write(text.replace("= 0.3[m/s]", "= 0.1[m/s]"))
        with open(edited) as file:
            answer = await ask(client, f"what-if {file.read()}")
        check(
            "another default in the program counts, whatever was recorded",
            await others(answer, traced(corridor, recording, "speed=0.1[m/s]")),
        )
        with open(edited) as file:
            answer = await ask(client, f"with speed=0.15 what-if {file.read()}")
        check(
            "and what is set counts more",
            await others(answer, traced(corridor, recording, "speed=0.15[m/s]")),
        )
        answer = await ask(client, f"what-if {text.replace('6[1/m]', '5[1/m]')}")
        check(
            "others are as recorded",
            await others(answer, traced(corridor, recording, "kTurn=5[1/m]")),
        )
        for setting, why in (
            ("speed=fast", "not `fast`"),
            ("speed=1[m]", "a different unit"),
            ("sped=1", "no parameter `sped`"),
            ("speed=nan", "not `nan`"),
        ):
            answer = await ask(client, f"with {setting} what-if {text}")
            check(f"{setting} is told", not answer["there"] and why in answer["why"])
        for nonsense in (
            "with",
            "with speed=1",
            "with speed=1 what-if",
            "with what-if x",
            "with speed=1 x",
        ):
            if (await ask(client, nonsense))["is"] != "refused":
                check(f"{nonsense} is refused", False)
        answer = await ask(client, f"with kMiddle=0.3 drive {text}")
        driven = os.path.join(folder, "driven.csv")
        record(v.frobc, driven, "--param", "speed=0.2[m/s]", "--param", "kMiddle=0.3[1/s]")
        check(
            "it drives again with other parameters",
            answer["drives"] and await others(answer, traced(corridor, driven)),
        )


def record(frobc, file, *options):
    subprocess.run(
        [frobc, "run", "--for", "4s", "--record", file, *options, corridor],
        check=True,
        stdout=subprocess.DEVNULL,
    )


async def main():
    frobc = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        recording = os.path.join(folder, "run.csv")
        record(frobc, recording, "--param", "speed=0.2[m/s]")
        v = viewer.Viewer(frobc, recording, corridor)
        await visit(v, recording, folder)
        v.end()


asyncio.run(main())
sys.exit(viewer.failures > 0)
