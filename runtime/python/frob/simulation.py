"""Runs a program in the simulator in the same way as `frobc run`."""

from __future__ import annotations

import glob
import os
import tempfile
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Union

from . import data, library, recording, shapes, tools
from .errors import InputError
from .simulator import world_path

if TYPE_CHECKING:
    from .recording import Table


class Picture(str):
    """A picture as SVG text, which notebooks display."""

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
    """Drives a robot in a world and returns the recording, in the form that `frob.read` returns.

    The default for `world` is `world.toml` in the program's folder or, if there is none, the room
    that is installed with frobc. `params` are numbers in the parameters' units, or strings such as
    `"20[cm]"`. `probe` names internal signals to record. If `until_done` is true, the run ends when
    the program ends. In addition to the attributes of a recording, `attrs` has `summary` (the
    summary that `frobc run` prints, as a dict) and, if requested, `picture`. If the world has
    several robots, the table is the recording of the first one, and `attrs["robots"]` is a list of
    all tables.
    """
    path = tools.existing(file, "program")
    for name, flag in (("until_done", until_done), ("picture", picture)):
        if not isinstance(flag, bool):
            raise InputError(f"{name}: expected True or False, found {shapes.shown(flag)}")
    if isinstance(seed, bool) or not isinstance(seed, int) or not 0 <= seed < 2**62:
        raise InputError(f"seed: expected a whole number of at least 0, found {shapes.shown(seed)}")
    duration, rate = _seconds(duration, "duration"), _seconds(rate, "rate")
    if not 0.001 <= duration <= 1e5:
        raise InputError(f"duration: expected seconds from 0.001 to 100000, found {duration}")
    if not 0.1 <= rate <= 10000:
        raise InputError(f"rate: expected steps per second from 0.1 to 10000, found {rate}")
    options = ["--entry", tools.word(entry, "entry"), "--seed", str(seed), "--rate", repr(rate)]
    if world is not None:
        options += ["--world", world_path(path, world)]
    if robot is not None:
        options += ["--robot", tools.path_text(robot, "robot")]
    for source in tools.paths(sources, "sources"):
        options += ["--with", tools.existing(source, "C file")]
    with tempfile.TemporaryDirectory(prefix="frob-") as folder:
        settings = _settings(library.settings(params, "params"), [*options, path], folder)
        probes = tools.words(probe, "probe")
        if any(probes):
            options += ["--probe", ",".join(probes)]
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
    try:
        return shapes.number(value)
    except (TypeError, ValueError, ArithmeticError):
        raise InputError(f"{place}: expected a number, found {shapes.shown(value)}") from None


def _run(options: Sequence[str], duration: float, folder: str) -> Dict[str, str]:
    record = os.path.join(folder, "run.csv")
    told = tools.run(["run", "--for", f"{duration:.9f}s", "--record", record, *options])
    lines = (line.split(": ", 1) for line in told.splitlines() if ": " in line)
    # Omits the lines that name files, because those files are deleted before the table is returned.
    return {name: value for name, value in lines if name not in ("log", "picture")}


def _recorded(folder: str) -> List[Any]:
    names = glob.glob(os.path.join(folder, "run*.csv"))
    names.sort(key=lambda name: (len(name), name))
    return [recording.read(name) for name in names]


def _settings(params: Mapping[str, Any], options: Sequence[str], folder: str) -> List[str]:
    """Converts parameters to options. A number gets the unit that the program declares. To find the
    unit, this runs a single instant and reads the recording's header."""
    units: Dict[str, str] = {}
    if any(not isinstance(value, str) for value in params.values()):
        _run(options, 0.001, folder)
        units = _recorded(folder)[0].attrs["units"]
    settings: List[str] = []
    for name, value in params.items():
        text = value if isinstance(value, str) else _with_unit(value, units.get(name, ""))
        settings += ["--param", tools.word(f"{name}={text}", "params")]
    return settings


def _with_unit(value: Any, unit: str) -> str:
    if isinstance(value, bool):
        return str(value)
    text = data.text(value)
    return f"{text}[{unit}]" if unit not in ("", "1") else text
