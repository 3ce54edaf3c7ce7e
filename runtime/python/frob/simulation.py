"""Runs a program in the simulator, as `frobc run` does."""

from __future__ import annotations

import glob
import os
import tempfile
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Union

from . import data, recording, tools
from .errors import InputError

if TYPE_CHECKING:
    from .recording import Table


class Picture(str):
    """A picture as the text of an SVG; a notebook shows it."""

    def __repr__(self) -> str:
        return f"<a picture: SVG of {len(self)} characters>"

    def _repr_svg_(self) -> str:
        return str(self)


def simulate(
    file: tools.PathLike,
    *,
    world: Optional[tools.PathLike] = None,
    seed: int = 1,
    params: Optional[Mapping[str, Any]] = None,
    duration: float = 60.0,
    rate: float = 50.0,
    robot: Optional[tools.PathLike] = None,
    entry: str = "main",
    probe: Union[str, Sequence[str]] = (),
    until_done: bool = False,
    picture: bool = False,
    sources: Sequence[tools.PathLike] = (),
) -> "Table":
    """Drives a robot in a world, and gives the recording of it, as `frob.read` does.

    Without `world` it is the `world.toml` beside the program, or else the room that comes with
    frobc. `params` are numbers in the parameters' units, or texts as `"20[cm]"`; `probe` names
    inner signals to be recorded too; `until_done` ends the run when the program has ended.
    `attrs` have, besides those of a recording, `summary`, what `frobc run` prints, by names,
    and `picture` if that is asked for. In a world of several robots the table is that of the
    first, and `robots` in `attrs` has all of them.
    """
    path = tools.existing(file, "program")
    if isinstance(seed, bool) or not isinstance(seed, int) or not 0 <= seed < 2**62:
        raise InputError(f"seed: expected a whole number from 0 on, found {seed!r}")
    if not 0.001 <= _seconds(duration, "duration") <= 1e5:
        raise InputError(f"duration: expected seconds from 0.001 to 100000, found {duration}")
    if not 0.1 <= _seconds(rate, "rate") <= 10000:
        raise InputError(f"rate: expected steps in a second from 0.1 to 10000, found {rate}")
    options = ["--entry", entry, "--seed", str(seed), "--rate", repr(float(rate))]
    if world is not None:
        options += ["--world", tools.existing(world, "world")]
    if robot is not None:
        options += ["--robot", os.fspath(robot)]
    for source in sources:
        options += ["--with", tools.existing(source, "C file")]
    with tempfile.TemporaryDirectory(prefix="frob-") as folder:
        settings = _settings(params or {}, [*options, path], folder)
        if probe:
            options += ["--probe", probe if isinstance(probe, str) else ",".join(probe)]
        if until_done:
            options.append("--exit-when-done")
        drawn = os.path.join(folder, "run.svg")
        if picture:
            options += ["--picture", drawn]
        summary = _run([*options, *settings, path], duration, folder)
        tables = _recorded(folder)
        table: "Table" = tables[0]
        table.attrs["summary"] = summary
        if len(tables) > 1:
            table.attrs["robots"] = tables
        if picture:
            with open(drawn, encoding="utf-8") as svg:
                table.attrs["picture"] = Picture(svg.read())
    return table


def _seconds(value: Any, place: str) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise InputError(f"{place}: expected a number, found {value!r}")
    return float(value)


def _run(options: Sequence[str], duration: float, folder: str) -> Dict[str, str]:
    record = os.path.join(folder, "run.csv")
    told = tools.run(["run", "--for", f"{duration:.9f}s", "--record", record, *options])
    lines = (line.split(": ", 1) for line in told.splitlines() if ": " in line)
    # The files that it names are gone when the table is there.
    return {name: value for name, value in lines if name not in ("log", "picture")}


def _recorded(folder: str) -> List[Any]:
    names = glob.glob(os.path.join(folder, "run*.csv"))
    names.sort(key=lambda name: (len(name), name))
    return [recording.read(name) for name in names]


def _settings(params: Mapping[str, Any], options: Sequence[str], folder: str) -> List[str]:
    """As options. A number gets the unit that the program declares, which is at the head of a
    recording: one of a single instant tells it."""
    units: Dict[str, str] = {}
    if any(not isinstance(value, str) for value in params.values()):
        _run(options, 0.001, folder)
        units = _recorded(folder)[0].attrs["units"]
    settings: List[str] = []
    for name, value in params.items():
        text = value if isinstance(value, str) else _with_unit(value, units.get(name, ""))
        settings += ["--param", f"{name}={text}"]
    return settings


def _with_unit(value: Any, unit: str) -> str:
    if isinstance(value, bool):
        return str(value)
    text = data.text(value)
    return f"{text}[{unit}]" if unit not in ("", "1") else text
