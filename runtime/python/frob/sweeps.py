"""Many runs of a trial, as `frobc sweep` makes them: here, or on the machines of a cluster."""

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
    """Makes the runs of a plan, and gives the table of them: a row for each, in the plan's order.

    Here it is `frobc sweep`, with `jobs` processes, or as many as there are processors. With a
    client of `dask.distributed` its workers make the runs, each a shard of them after another.
    Plan, program and worlds then have to be on each worker's machine, at the same path.

    Rows are kept in the folder `rows`, or beside the plan as those of `frobc sweep`; runs that
    are there are not made again, so the same call goes on where one ended, however it ended.
    `attrs` have `summary`, what `frobc sweep` prints, and `picture` if that is asked for.
    """
    path = tools.existing(plan, "plan")
    if jobs is not None and (isinstance(jobs, bool) or not isinstance(jobs, int) or jobs < 1):
        raise InputError(f"jobs: expected a whole number from 1 on, found {jobs!r}")
    if jobs is not None and client is not None:
        raise InputError("jobs: a cluster's workers make one run at a time; leave it out")
    folder = os.path.abspath(os.fspath(rows) if rows is not None else _stem(path) + ".rows")
    options = [] if robot is None else ["--robot", _own(robot)]
    for source in sources:
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
        # The files that it names are gone when the table is there.
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
    """A robot of the user's own is the file of its module."""
    name = os.fspath(robot)
    return os.path.abspath(name) if name.endswith(".frob") else name


WHOLE = {"run", "seed", "touches"}
TEXTS = {"world", "robot", "fate", "by"}


def _read(path: str) -> Any:
    """The table that frobc has written. What a run has not measured is NaN."""
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
