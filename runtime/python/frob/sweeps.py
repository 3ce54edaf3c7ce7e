"""Performs many runs of a trial, like `frobc sweep`, on this machine or on a cluster."""

from __future__ import annotations

import csv
import os
import tempfile
from typing import TYPE_CHECKING, Any, Optional, Sequence

from . import recording, tools
from .errors import InputError
from .simulation import Picture

if TYPE_CHECKING:
    from distributed import Client

    from .recording import Table


def sweep(
    plan: tools.PathLike,
    client: Optional["Client"] = None,
    *,
    jobs: Optional[int] = None,
    robot: Optional[tools.PathLike] = None,
    rows: Optional[tools.PathLike] = None,
    sources: Sequence[tools.PathLike] = (),
    picture: bool = False,
) -> "Table":
    """Performs the runs of a plan and returns a table with one row per run, in the plan's order.

    Without a client, this calls `frobc sweep` with `jobs` processes; the default is the number of
    processors. If a `dask.distributed` client is given, its workers perform the runs, one shard
    after another. Each worker's machine must then have the plan, the program and the worlds at
    the same paths.

    Rows are stored in the folder `rows` or, by default, in the folder next to the plan that
    `frobc sweep` uses. Runs that have a row are not repeated, so you can make the same call again
    after any interruption. `attrs` has `summary`, the output of `frobc sweep`, and `picture` if
    it was requested.
    """
    path = tools.existing(plan, "plan")
    if not isinstance(picture, bool):
        raise InputError(f"picture: expected True or False, found {picture!r:.60}")
    if jobs is not None and (isinstance(jobs, bool) or not isinstance(jobs, int) or jobs < 1):
        raise InputError(f"jobs: expected a whole number of at least 1, found {jobs!r}")
    if jobs is not None and client is not None:
        raise InputError("jobs: the workers of a cluster perform one run at a time; remove `jobs`")
    kept = _stem(path) + ".rows" if rows is None else tools.path_text(rows, "rows")
    folder = os.path.abspath(kept)
    options = [] if robot is None else ["--robot", _own(robot)]
    for source in tools.paths(sources, "sources"):
        options += ["--with", os.path.abspath(tools.existing(source, "C file"))]
    if client is not None:
        from . import cluster

        path = os.path.abspath(path)
        cluster.make(client, path, options, folder)
        options.append("--merge")
    elif jobs is not None:
        options += ["--jobs", str(jobs)]
    with tempfile.TemporaryDirectory(prefix="frob-") as scratch:
        told, drawn = os.path.join(scratch, "runs.csv"), os.path.join(scratch, "runs.svg")
        if picture:
            options += ["--picture", drawn]
        said = tools.run(["sweep", *options, "--rows", folder, "--table", told, path])
        table: "Table" = _read(told)
        # Omits the lines that name files, because those files are deleted before the table is
        # returned.
        lines = said.splitlines()
        table.attrs["summary"] = "\n".join(
            line for line in lines if not line.startswith(("table: ", "picture: "))
        )
        if picture:
            with open(drawn, encoding="utf-8") as svg:
                table.attrs["picture"] = Picture(svg.read())
    return table


def _stem(plan: str) -> str:
    return plan[: -len(".toml")] if plan.endswith(".toml") else plan


def _own(robot: tools.PathLike) -> str:
    """Makes the path of a user-defined robot's module (`….frob`) absolute; does not change
    other names.
    """
    name = tools.path_text(robot, "robot")
    return os.path.abspath(name) if name.endswith(".frob") else name


WHOLE = {"run", "seed", "touches", "collisions"}
TEXTS = {"world", "robot", "fate", "by", "collision_with"}


def _read(path: str) -> Any:
    """Reads the table that frobc has written. Quantities that a run did not measure are NaN."""
    with open(path, encoding="utf-8", newline="") as file:
        names, *rows = csv.reader(file)
    columns = dict(zip(names, zip(*rows)))
    return recording.as_table({name: _column(name, columns[name]) for name in names})


def _column(name: str, texts: Sequence[str]) -> Any:
    if name in TEXTS:
        return list(texts)
    if name in WHOLE:
        return [int(text) for text in texts]
    try:
        return [float(text or "nan") for text in texts]
    except ValueError:
        return [text == "true" for text in texts]
